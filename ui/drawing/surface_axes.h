// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/drawing/surface_image.h"
#include "ui/text/value_scale.h"

#include <QColor>
#include <QString>

#include <array>

class QPainter;

namespace axiscomp::ui {

/// The box around a surface, its axes with ticks, numbers and names.
class SurfaceAxes {
public:
    /// All must outlive it. values: how heights are named.
    SurfaceAxes(
        QPainter& painter, const SurfaceSight& sight, const ValueScale& values, const QColor& line);

    void drawFloor();
    /// text: of the numbers; the ends of each axis have one.
    void drawScales(const std::array<QString, 3>& names, const QColor& text);

private:
    [[nodiscard]] double floor() const { return m_sight.heights[0]; }
    [[nodiscard]] std::array<double, 2> leftCorner() const;
    void line(const std::array<double, 3>& from, const std::array<double, 3>& to);
    [[nodiscard]] QPointF pixel(const std::array<double, 3>& place) const;
    [[nodiscard]] QPointF outwards(const QPointF& pixel, double by) const;
    void floorTick(double x, double y, const QPointF& away, const QString& label);
    void heightTick(const std::array<double, 3>& place, const QString& label);
    void name(const std::array<double, 3>& place, const QString& label);
    void write(const QPointF& at, const QString& label, Qt::Alignment side);

    QPainter& m_painter;
    const SurfaceSight& m_sight;
    const ValueScale& m_values;
    SurfaceProjection m_projection;
    QColor m_line;
    QColor m_text;
    const GridAxis& m_x;
    const GridAxis& m_y;
    double m_frontX = 0.0;
    double m_frontY = 0.0;
};

/// Both ends, and round numbers between them that are no nearer to an end than this part of all, at
/// most so many; ascending.
[[nodiscard]] std::vector<double> ticksWithEnds(
    double low, double high, double nearest, int most = 5);

} // namespace axiscomp::ui
