// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/map_contours.h"

#include "ui/async/background_job.h"
#include "ui/text/value_text.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

using Contours = std::shared_ptr<const std::vector<Contour>>;

/// Free for a label, its centre on the line; empty when nowhere is room.
QRectF placeForLabel(const QPolygonF& line, const QSizeF& size, const QRectF& sight,
    const std::vector<QRectF>& taken)
{
    for (const double part : {0.5, 0.3, 0.7, 0.15, 0.85}) {
        const auto at = static_cast<qsizetype>(part * static_cast<double>(line.size() - 1));
        QRectF place({}, size);
        place.moveCenter(line[at]);
        const bool isFree = std::ranges::none_of(
            taken, [&](const QRectF& other) { return other.intersects(place); });
        if (isFree && sight.contains(place))
            return place;
    }
    return {};
}

} // namespace

MapContours::MapContours(QCustomPlot& plot) : QCPAbstractItem(&plot)
{
    setLayer(QStringLiteral("axes")); // above the map
    setSelectable(false);
    setClipAxisRect(plot.axisRect());
    setClipToAxisRect(true);
}

void MapContours::setTable(std::shared_ptr<const CompensationTable> table)
{
    if (table == m_table)
        return;
    m_table = std::move(table);
    m_contours.reset();
    const int request = ++m_request;
    if (!m_table)
        return;
    const auto found = inBackground<Contours>([shown = m_table]() -> Contours {
        return std::make_shared<const std::vector<Contour>>(
            contours(*shown, contourLevels(*shown)));
    });
    whenDone(found, this, [this, request](const Contours& computed) {
        if (request != m_request)
            return;
        m_contours = computed;
        mParentPlot->replot(QCustomPlot::rpQueuedReplot);
    });
}

void MapContours::setColors(const QColor& line, const QColor& background)
{
    m_line = line;
    m_background = background;
}

double MapContours::selectTest(const QPointF&, bool, QVariant*) const
{
    return -1.0; // never hit
}

MapContours::Lines MapContours::linesOf(const Contour& contour, const QRectF& sight) const
{
    constexpr double smallest = 3.0; // pixels: a dot says nothing
    Lines lines;
    for (const ContourLine& line : contour.lines) {
        QPolygonF drawn;
        for (const ContourPoint& point : line.points) {
            const QPointF pixel(mParentPlot->xAxis->coordToPixel(point.x),
                mParentPlot->yAxis->coordToPixel(point.y));
            const bool isLast = &point == &line.points.back();
            if (drawn.isEmpty() || isLast || (pixel - drawn.back()).manhattanLength() > 1.0)
                drawn.append(pixel);
        }
        const QRectF extent = drawn.boundingRect();
        if (extent.width() + extent.height() > smallest
            && extent.adjusted(-1.0, -1.0, 1.0, 1.0).intersects(sight))
            lines.push_back(std::move(drawn));
    }
    return lines;
}

void MapContours::draw(QCPPainter* painter)
{
    if (!m_contours)
        return;
    const QRectF sight(clipRect());
    std::vector<Lines> lines;
    for (const Contour& contour : *m_contours)
        lines.push_back(linesOf(contour, sight));
    // A seam in the background's colour: the lines are seen on dark and light parts of the map.
    QColor seam = m_background;
    seam.setAlpha(120);
    painter->setAntialiasing(true);
    painter->setBrush(Qt::NoBrush);
    for (const auto& [color, width] : {std::pair(seam, 3.0), std::pair(m_line, 1.0)}) {
        painter->setPen(QPen(color, width));
        for (const Lines& level : lines)
            for (const QPolygonF& line : level)
                painter->drawPolyline(line);
    }
    drawLabels(painter, lines);
}

void MapContours::drawLabels(QCPPainter* painter, const std::vector<Lines>& lines) const
{
    QFont font = mParentPlot->font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    painter->setFont(font);
    const QFontMetricsF metrics(font);
    const QRectF sight(clipRect());
    std::vector<QRectF> taken;
    QColor background = m_background;
    background.setAlpha(225);
    for (std::size_t n = 0; n < lines.size(); ++n) {
        const QString text = signedNumberText((*m_contours)[n].level * m_scale.factor());
        const QSizeF size(metrics.horizontalAdvance(text) + 6.0, metrics.height());
        for (const QPolygonF& line : lines[n]) {
            const QRectF extent = line.boundingRect();
            const QRectF place = extent.width() + extent.height() > 2.0 * size.width()
                ? placeForLabel(line, size, sight, taken)
                : QRectF();
            if (place.isEmpty())
                continue;
            taken.push_back(place);
            painter->setPen(Qt::NoPen);
            painter->setBrush(background);
            painter->drawRoundedRect(place, 3.0, 3.0);
            painter->setPen(m_line);
            painter->drawText(place, Qt::AlignCenter, text);
        }
    }
}

} // namespace axiscomp::ui
