// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/contours.h"
#include "ui/text/value_scale.h"

#include "ui/drawing/custom_plot.h"

#include <memory>

namespace axiscomp::ui {

/// Lines of equal value over a map, with the value beside them. Found on another thread.
class MapContours : public QCPAbstractItem {
public:
    explicit MapContours(QCustomPlot& plot);
    /// Null: none.
    void setTable(std::shared_ptr<const CompensationTable> table);
    void setValueScale(const ValueScale& scale) { m_scale = scale; }
    void setColors(const QColor& line, const QColor& background);

    double selectTest(const QPointF& pos, bool onlySelectable, QVariant* details) const override;

protected:
    void draw(QCPPainter* painter) override;

private:
    using Lines = std::vector<QPolygonF>; ///< in pixels, those in sight
    [[nodiscard]] Lines linesOf(const Contour& contour, const QRectF& sight) const;
    void drawLabels(QCPPainter* painter, const std::vector<Lines>& lines) const;

    std::shared_ptr<const CompensationTable> m_table;
    std::shared_ptr<const std::vector<Contour>> m_contours;
    ValueScale m_scale;
    QColor m_line;
    QColor m_background;
    int m_request = 0; ///< the newest one
};

} // namespace axiscomp::ui
