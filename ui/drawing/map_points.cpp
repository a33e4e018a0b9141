// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/map_points.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

MapPoints::MapPoints(QCustomPlot& plot) : QCPAbstractItem(&plot)
{
    setLayer(QStringLiteral("axes")); // above the map
    setSelectable(false);
    setClipAxisRect(plot.axisRect());
    setClipToAxisRect(true);
}

void MapPoints::setTable(std::shared_ptr<const CompensationTable> table)
{
    m_table = std::move(table);
}

void MapPoints::setColors(const QColor& point, const QColor& ring)
{
    m_point = point;
    m_ring = ring;
}

double MapPoints::selectTest(const QPointF&, bool, QVariant*) const
{
    return -1.0; // never hit
}

MapPoints::Visible MapPoints::visibleOf(const GridAxis& axis, const QCPAxis& drawn)
{
    constexpr double nearest = 6.0; // pixels
    const double pixels =
        std::abs(drawn.coordToPixel(axis.start + axis.distance) - drawn.coordToPixel(axis.start));
    if (!(pixels >= nearest))
        return {};
    const double last = axis.size - 1.0;
    const double from = std::ceil((drawn.range().lower - axis.start) / axis.distance);
    const double to = std::floor((drawn.range().upper - axis.start) / axis.distance);
    if (from > last || to < 0.0)
        return {};
    const auto first = static_cast<std::size_t>(std::max(from, 0.0));
    return {first, static_cast<std::size_t>(std::min(to, last)) + 1 - first};
}

std::size_t MapPoints::visibleCount() const
{
    if (!m_table)
        return 0;
    return visibleOf(m_table->grid.axes[0], *mParentPlot->xAxis).count
        * visibleOf(m_table->grid.axes[1], *mParentPlot->yAxis).count;
}

void MapPoints::draw(QCPPainter* painter)
{
    if (visibleCount() == 0)
        return;
    const GridAxis& xAxis = m_table->grid.axes[0];
    const GridAxis& yAxis = m_table->grid.axes[1];
    const Visible columns = visibleOf(xAxis, *mParentPlot->xAxis);
    const Visible rows = visibleOf(yAxis, *mParentPlot->yAxis);
    QVector<QRectF> rings;
    QVector<QRectF> points;
    for (std::size_t j = rows.first; j < rows.first + rows.count; ++j) {
        const double y = std::round(mParentPlot->yAxis->coordToPixel(yAxis.position(j)));
        for (std::size_t i = columns.first; i < columns.first + columns.count; ++i) {
            const double x = std::round(mParentPlot->xAxis->coordToPixel(xAxis.position(i)));
            rings.append(QRectF(x - 2.0, y - 2.0, 4.0, 4.0));
            points.append(QRectF(x - 1.0, y - 1.0, 2.0, 2.0));
        }
    }
    painter->setAntialiasing(false);
    painter->setPen(Qt::NoPen);
    painter->setBrush(m_ring);
    painter->drawRects(rings);
    painter->setBrush(m_point);
    painter->drawRects(points);
}

} // namespace axiscomp::ui
