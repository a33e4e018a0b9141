// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/table_map.h"

#include "core/table/lookup.h"

#include <array>
#include <cmath>

namespace axiscomp::ui {

QCPColorGradient divergingGradient(bool dark)
{
    QCPColorGradient gradient;
    gradient.clearColorStops();
    gradient.setColorInterpolation(QCPColorGradient::ciRGB);
    const std::array<QColor, 5> light{QColor(5, 70, 140), QColor(90, 155, 205),
        QColor(247, 247, 247), QColor(225, 120, 85), QColor(150, 15, 35)};
    const std::array<QColor, 5> night{QColor(120, 195, 255), QColor(45, 105, 165),
        QColor(38, 38, 40), QColor(175, 75, 50), QColor(255, 165, 130)};
    const std::array<QColor, 5>& colors = dark ? night : light;
    for (std::size_t i = 0; i < colors.size(); ++i)
        gradient.setColorStopAt(static_cast<double>(i) / 4.0, colors[i]);
    return gradient;
}

TableMap::TableMap(QCustomPlot& plot) : QCPColorMap(plot.xAxis, plot.yAxis) { }

void TableMap::setTable(std::shared_ptr<const CompensationTable> table)
{
    m_table = std::move(table);
}

QRectF TableMap::visiblePlace() const
{
    if (!m_table)
        return {};
    const GridAxis& x = m_table->grid.axes[0];
    const GridAxis& y = m_table->grid.axes[1];
    const QRectF whole(coordsToPixels(x.start, y.last()), coordsToPixels(x.last(), y.start));
    return whole & QRectF(clipRect());
}

void TableMap::draw(QCPPainter* painter)
{
    const QRectF place = visiblePlace();
    if (place.isEmpty())
        return;
    // One lookup for each pixel of the device, which may have more of them than the window.
    const double scale = painter->deviceTransform().m11();
    const QSize size(static_cast<int>(std::ceil(place.width() * scale)),
        static_cast<int>(std::ceil(place.height() * scale)));
    painter->drawImage(place, imageOf(sectionOf(*this, m_table), size));
}

MapSection sectionOf(const TableMap& map, const std::shared_ptr<const CompensationTable>& table)
{
    MapSection section{table, map.gradient(), map.dataRange(), map.visiblePlace(), {}, {}};
    const QRectF& place = section.place;
    section.x = QCPRange(
        map.keyAxis()->pixelToCoord(place.left()), map.keyAxis()->pixelToCoord(place.right()));
    section.y = QCPRange(
        map.valueAxis()->pixelToCoord(place.bottom()), map.valueAxis()->pixelToCoord(place.top()));
    return section;
}

QImage imageOf(MapSection section, const QSize& size)
{
    QImage image(size, QImage::Format_RGB32);
    const Lookup lookup(*section.table);
    const double stepX = section.x.size() / size.width();
    const double stepY = section.y.size() / size.height();
    const auto width = static_cast<std::size_t>(size.width());
    std::vector<double> positions(2 * width);
    for (std::size_t i = 0; i < width; ++i)
        positions[2 * i] = section.x.lower + (static_cast<double>(i) + 0.5) * stepX;
    std::vector<double> row(width);
    for (int line = 0; line < size.height(); ++line) {
        for (std::size_t i = 0; i < width; ++i)
            positions[2 * i + 1] = section.y.upper - (line + 0.5) * stepY;
        lookup.atEach(positions, row);
        section.gradient.colorize(
            row.data(), section.range, reinterpret_cast<QRgb*>(image.scanLine(line)), size.width());
    }
    return image;
}

} // namespace axiscomp::ui
