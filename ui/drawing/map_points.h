// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <QPalette>

#include "ui/drawing/custom_plot.h"

#include <memory>

namespace axiscomp::ui {

/// The grid points of a map: dark in a light ring or the other way round, to be seen on every
/// colour. Only where they are far enough apart to be told apart.
class MapPoints : public QCPAbstractItem {
public:
    explicit MapPoints(QCustomPlot& plot);
    /// Null: none.
    void setTable(std::shared_ptr<const CompensationTable> table);
    void setColors(const QColor& point, const QColor& ring);
    /// How many are drawn at the present zoom.
    [[nodiscard]] std::size_t visibleCount() const;

    double selectTest(const QPointF& pos, bool onlySelectable, QVariant* details) const override;

protected:
    void draw(QCPPainter* painter) override;

private:
    /// Indices of the points in sight, and where the first of them is.
    struct Visible {
        std::size_t first = 0;
        std::size_t count = 0;
    };
    [[nodiscard]] static Visible visibleOf(const GridAxis& axis, const QCPAxis& drawn);

    std::shared_ptr<const CompensationTable> m_table;
    QColor m_point;
    QColor m_ring;
};

} // namespace axiscomp::ui
