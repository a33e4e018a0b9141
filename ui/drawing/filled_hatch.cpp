// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/filled_hatch.h"

#include <algorithm>

namespace axiscomp::ui {

FilledHatch::FilledHatch(QCustomPlot& plot) : QCPAbstractItem(&plot)
{
    setLayer(QStringLiteral("axes")); // above the map
    setSelectable(false);
    setClipAxisRect(plot.axisRect());
    setClipToAxisRect(true);
}

void FilledHatch::setTable(std::shared_ptr<const CompensationTable> table)
{
    m_table = std::move(table);
}

double FilledHatch::selectTest(const QPointF&, bool, QVariant*) const
{
    return -1.0; // never hit
}

std::vector<QRectF> FilledHatch::places() const
{
    if (!m_table)
        return {};
    const GridAxis& x = m_table->grid.axes[0];
    const GridAxis& y = m_table->grid.axes[1];
    const auto& filled = m_table->filled;
    const QRectF sight(clipRect());
    std::vector<QRectF> places;
    for (std::size_t from = 0; from < filled.size();) {
        const std::size_t row = filled[from] / x.size;
        std::size_t to = from + 1;
        while (to < filled.size() && filled[to] == filled[to - 1] + 1 && filled[to] / x.size == row)
            ++to;
        const double first = x.position(filled[from] % x.size) - 0.5 * x.distance;
        const double last = x.position(filled[to - 1] % x.size) + 0.5 * x.distance;
        const double low = y.position(row) - 0.5 * y.distance;
        const QPointF corner(mParentPlot->xAxis->coordToPixel(std::max(first, x.start)),
            mParentPlot->yAxis->coordToPixel(std::min(low + y.distance, y.last())));
        const QPointF other(mParentPlot->xAxis->coordToPixel(std::min(last, x.last())),
            mParentPlot->yAxis->coordToPixel(std::max(low, y.start)));
        const QRectF place = QRectF(corner, other).normalized() & sight;
        if (!place.isEmpty())
            places.push_back(place);
        from = to;
    }
    return places;
}

void FilledHatch::draw(QCPPainter* painter)
{
    painter->setPen(Qt::NoPen);
    painter->setBrush(QBrush(m_color, Qt::BDiagPattern));
    for (const QRectF& place : places())
        painter->drawRect(place);
}

} // namespace axiscomp::ui
