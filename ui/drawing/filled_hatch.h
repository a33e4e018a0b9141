// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include "ui/drawing/custom_plot.h"

#include <memory>

namespace axiscomp::ui {

/// Hatches what of a map was made up, not measured: half a cell around each such point.
class FilledHatch : public QCPAbstractItem {
public:
    explicit FilledHatch(QCustomPlot& plot);
    /// Of two dimensions. Null: none.
    void setTable(std::shared_ptr<const CompensationTable> table);
    void setColor(const QColor& color) { m_color = color; }
    /// In pixels, neighbours of a row in one.
    [[nodiscard]] std::vector<QRectF> places() const;

    double selectTest(const QPointF& pos, bool onlySelectable, QVariant* details) const override;

protected:
    void draw(QCPPainter* painter) override;

private:
    std::shared_ptr<const CompensationTable> m_table;
    QColor m_color;
};

} // namespace axiscomp::ui
