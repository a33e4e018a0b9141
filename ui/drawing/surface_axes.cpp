// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/surface_axes.h"

#include "core/table/contours.h"
#include "ui/text/value_text.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

SurfaceAxes::SurfaceAxes(
    QPainter& painter, const SurfaceSight& sight, const ValueScale& values, const QColor& line)
    : m_painter(painter)
    , m_sight(sight)
    , m_values(values)
    , m_projection(sight)
    , m_line(line)
    , m_x(sight.table->grid.axes[0])
    , m_y(sight.table->grid.axes[1])
{
    // The two edges of the floor that are nearest to the eye.
    const double quarter = std::fmod(std::fmod(sight.turn, 360.0) + 360.0, 360.0);
    m_frontY = quarter < 90.0 || quarter >= 270.0 ? m_y.start : m_y.last();
    m_frontX = quarter < 180.0 ? m_x.start : m_x.last();
}

void SurfaceAxes::drawFloor()
{
    m_painter.setPen(QPen(m_line, 1.0));
    for (const double x : {m_x.start, m_x.last()})
        line({x, m_y.start, floor()}, {x, m_y.last(), floor()});
    for (const double y : {m_y.start, m_y.last()})
        line({m_x.start, y, floor()}, {m_x.last(), y, floor()});
}

void SurfaceAxes::drawScales(const std::array<QString, 3>& names, const QColor& text)
{
    m_text = text;
    const auto [left, leftY] = leftCorner();
    m_painter.setPen(QPen(m_line, 1.0));
    line({left, leftY, floor()}, {left, leftY, m_sight.heights[1]});
    // Each number stands in the direction of the other axis, so that those of a corner are apart.
    const auto direction = [](const QPointF& from, const QPointF& to) {
        const QPointF way = to - from;
        return way / std::max(1.0, std::hypot(way.x(), way.y()));
    };
    const double backX = m_x.start + m_x.last() - m_frontX;
    const double backY = m_y.start + m_y.last() - m_frontY;
    const QPointF front = pixel({m_frontX, m_frontY, floor()});
    const QPointF awayFromX = direction(pixel({m_frontX, backY, floor()}), front);
    const QPointF awayFromY = direction(pixel({backX, m_frontY, floor()}), front);
    constexpr double nearest = 0.12;
    for (const double x : ticksWithEnds(m_x.start, m_x.last(), nearest))
        floorTick(x, m_frontY, awayFromX, numberText(x));
    for (const double y : ticksWithEnds(m_y.start, m_y.last(), nearest))
        floorTick(m_frontX, y, awayFromY, numberText(y));
    const double factor = m_values.factor();
    const std::array<double, 2> ends{m_sight.heights[0] * factor, m_sight.heights[1] * factor};
    // As many numbers as have room above each other.
    const double room = std::max(1.0,
        pixel({left, leftY, m_sight.heights[0]}).y()
            - pixel({left, leftY, m_sight.heights[1]}).y());
    const double lineHeight = QFontMetricsF(m_painter.font()).height() * 1.2;
    for (const double value : ticksWithEnds(ends[0], ends[1],
             std::max(nearest, 1.5 * lineHeight / room), static_cast<int>(room / lineHeight))) {
        const bool isEnd = value == ends[0] || value == ends[1];
        heightTick({left, leftY, value / factor},
            isEnd ? m_values.text(value / factor) : signedNumberText(value));
    }
    m_painter.setPen(m_text);
    name({(m_x.start + m_x.last()) / 2.0, m_frontY, floor()}, names[0]);
    name({m_frontX, (m_y.start + m_y.last()) / 2.0, floor()}, names[1]);
    constexpr double above = 16.0;
    write(
        pixel({left, leftY, m_sight.heights[1]}) - QPointF(0.0, above), names[2], Qt::AlignHCenter);
}

/// The corner of the floor that is farthest left in the picture.
std::array<double, 2> SurfaceAxes::leftCorner() const
{
    std::array<double, 2> best{m_x.start, m_y.start};
    double smallest = 1e300;
    for (const double x : {m_x.start, m_x.last()}) {
        for (const double y : {m_y.start, m_y.last()}) {
            const double place = pixel({x, y, floor()}).x();
            if (place < smallest) {
                smallest = place;
                best = {x, y};
            }
        }
    }
    return best;
}

QPointF SurfaceAxes::pixel(const std::array<double, 3>& place) const
{
    return m_projection.pixel(place[0], place[1], place[2]);
}

void SurfaceAxes::line(const std::array<double, 3>& from, const std::array<double, 3>& to)
{
    m_painter.drawLine(pixel(from), pixel(to));
}

/// Away from the middle of the picture.
QPointF SurfaceAxes::outwards(const QPointF& from, double by) const
{
    const QPointF middle =
        pixel({(m_x.start + m_x.last()) / 2.0, (m_y.start + m_y.last()) / 2.0, floor()});
    const QPointF way = from - middle;
    const double length = std::max(1.0, std::hypot(way.x(), way.y()));
    return from + way * (by / length);
}

void SurfaceAxes::floorTick(double x, double y, const QPointF& away, const QString& label)
{
    constexpr double length = 5.0;
    const QFontMetricsF metrics(m_painter.font());
    // The words are moved by as much as they are wide in this direction.
    const double by = length + 3.0 + std::abs(away.x()) * metrics.horizontalAdvance(label) / 2.0
        + std::abs(away.y()) * metrics.height() / 2.0;
    const QPointF at = pixel({x, y, floor()});
    const auto [left, leftY] = leftCorner();
    const bool isBelowHeights = x == left && y == leftY;
    m_painter.setPen(QPen(m_line, 1.0));
    m_painter.drawLine(at, at + away * length);
    m_painter.setPen(m_text);
    write(at + away * by + QPointF(0.0, isBelowHeights ? metrics.height() / 2.0 : 0.0), label,
        Qt::AlignHCenter);
}

/// The lowest number stands above its tick: the numbers of the floor are below.
void SurfaceAxes::heightTick(const std::array<double, 3>& place, const QString& label)
{
    constexpr double length = 5.0;
    constexpr double away = 8.0;
    const QPointF at = pixel(place);
    m_painter.setPen(QPen(m_line, 1.0));
    m_painter.drawLine(at, at - QPointF(length, 0.0));
    m_painter.setPen(m_text);
    const double up = place[2] == floor() ? QFontMetricsF(m_painter.font()).height() / 2.0 : 0.0;
    write(at - QPointF(away, up), label, Qt::AlignRight);
}

void SurfaceAxes::name(const std::array<double, 3>& place, const QString& label)
{
    constexpr double away = 38.0;
    constexpr double middle = 20.0;
    const QPointF at = pixel(place);
    const double beside = at.x() - m_sight.size.width() / 2.0;
    write(outwards(at, away), label,
        beside < -middle      ? Qt::AlignRight
            : beside > middle ? Qt::AlignLeft
                              : Qt::AlignHCenter);
}

void SurfaceAxes::write(const QPointF& at, const QString& label, Qt::Alignment side)
{
    const QFontMetricsF metrics(m_painter.font());
    const QSizeF size(metrics.horizontalAdvance(label) + 2.0, metrics.height());
    QRectF place({}, size);
    place.moveCenter(at);
    if (side == Qt::AlignRight)
        place.moveRight(at.x());
    else if (side == Qt::AlignLeft)
        place.moveLeft(at.x());
    place.moveLeft(std::clamp(place.left(), 0.0,
        std::max(0.0, static_cast<double>(m_sight.size.width()) - size.width())));
    place.moveTop(std::clamp(place.top(), 0.0,
        std::max(0.0, static_cast<double>(m_sight.size.height()) - size.height())));
    m_painter.drawText(place, Qt::AlignCenter, label);
}

std::vector<double> ticksWithEnds(double low, double high, double nearest, int most)
{
    constexpr int enough = 5;
    std::vector<double> ticks{low};
    for (const double tick : roundLevels(low, high, std::clamp(most, 1, enough))) {
        const double part = (tick - low) / (high - low);
        if (part > nearest && part < 1.0 - nearest)
            ticks.push_back(tick);
    }
    ticks.push_back(high);
    return ticks;
}

} // namespace axiscomp::ui
