// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/surface_image.h"

#include "core/table/lookup.h"
#include "core/table/position_unit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp::ui {

namespace {

double spanOf(const GridAxis& axis)
{
    return axis.last() - axis.start;
}

/// How many of dimension 1's units one unit of the values is.
double valueUnit(const CompensationTable& table)
{
    return commonUnitFactor(table.unit, table.grid.axes[0].unit).value_or(1.0);
}

/// The same for dimension 2. Without a common unit both sides of the floor are as long.
double secondUnit(const CompensationTable& table)
{
    const GridAxis& x = table.grid.axes[0];
    const GridAxis& y = table.grid.axes[1];
    return commonUnitFactor(y.unit, x.unit).value_or(spanOf(x) / spanOf(y));
}

/// A point of the surface, in pixels, with the colour that its value has.
struct Corner {
    float x = 0.0F;
    float y = 0.0F;
    float depth = 0.0F;
    float value = 0.0F;
};

/// Draws triangles and lines; what is nearer hides what is farther away.
class Canvas {
public:
    Canvas(const QSize& size, const std::vector<QRgb>& colors, const QCPRange& range)
        : m_image(size, QImage::Format_ARGB32_Premultiplied)
        , m_pixels(reinterpret_cast<QRgb*>(m_image.bits()))
        , m_depths(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()),
              std::numeric_limits<float>::max())
        , m_colors(colors)
        , m_lower(static_cast<float>(range.lower))
        , m_perColor(static_cast<float>(
              static_cast<double>(colors.size() - 1) / std::max(range.size(), 1e-300)))
    {
        m_image.fill(Qt::transparent);
    }

    void triangle(const Corner& a, const Corner& b, const Corner& c)
    {
        const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if (area == 0.0F)
            return; // seen from its edge
        const auto [left, right] = std::minmax({a.x, b.x, c.x});
        const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
        const int firstX = std::max(0, static_cast<int>(std::ceil(left - 0.5F)));
        const int lastX = std::min(m_image.width() - 1, static_cast<int>(right - 0.5F));
        const int firstY = std::max(0, static_cast<int>(std::ceil(top - 0.5F)));
        const int lastY = std::min(m_image.height() - 1, static_cast<int>(bottom - 0.5F));
        constexpr float edge = -1e-4F; // no gaps between neighbours
        for (int y = firstY; y <= lastY; ++y) {
            for (int x = firstX; x <= lastX; ++x) {
                const float px = static_cast<float>(x) + 0.5F;
                const float py = static_cast<float>(y) + 0.5F;
                const float ofB = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area;
                const float ofC = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / area;
                if (ofB < edge || ofC < edge || ofB + ofC > 1.0F - edge)
                    continue;
                const float depth = a.depth + ofB * (b.depth - a.depth) + ofC * (c.depth - a.depth);
                float& nearest = m_depths[offset(x, y)];
                if (depth >= nearest)
                    continue;
                nearest = depth;
                m_pixels[offset(x, y)] =
                    colorOf(a.value + ofB * (b.value - a.value) + ofC * (c.value - a.value));
            }
        }
    }

    /// On the surface: where that is not hidden. strength: 0 to 255.
    void line(const Corner& from, const Corner& to, const QColor& color, int strength)
    {
        const float dx = to.x - from.x;
        const float dy = to.y - from.y;
        const int steps = 1 + static_cast<int>(std::max(std::abs(dx), std::abs(dy)));
        for (int n = 0; n < steps; ++n) {
            const float part = static_cast<float>(n) / static_cast<float>(steps);
            const int x = static_cast<int>(from.x + part * dx);
            const int y = static_cast<int>(from.y + part * dy);
            if (x < 0 || y < 0 || x >= m_image.width() || y >= m_image.height())
                continue;
            constexpr float tolerance = 2.5F; // pixels: the surface beside the line is as near
            if (from.depth + part * (to.depth - from.depth) <= m_depths[offset(x, y)] + tolerance)
                blend(m_pixels[offset(x, y)], color, strength);
        }
    }

    [[nodiscard]] QImage image() const { return m_image; }

private:
    [[nodiscard]] std::size_t offset(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_image.width())
            + static_cast<std::size_t>(x);
    }
    [[nodiscard]] QRgb colorOf(float value) const
    {
        const float place = (value - m_lower) * m_perColor + 0.5F;
        return m_colors[static_cast<std::size_t>(
            std::clamp(place, 0.0F, static_cast<float>(m_colors.size() - 1)))];
    }
    static void blend(QRgb& pixel, const QColor& color, int strength)
    {
        if (qAlpha(pixel) == 0)
            return;
        const auto mixed = [strength](int under, int over) {
            return under + (over - under) * strength / 255;
        };
        pixel = qRgb(mixed(qRed(pixel), color.red()), mixed(qGreen(pixel), color.green()),
            mixed(qBlue(pixel), color.blue()));
    }

    QImage m_image;
    QRgb* m_pixels;
    std::vector<float> m_depths;
    const std::vector<QRgb>& m_colors;
    float m_lower;
    float m_perColor;
};

std::vector<QRgb> colorTable(QCPColorGradient& gradient)
{
    constexpr int count = 1024;
    std::vector<double> places(count);
    for (int n = 0; n < count; ++n)
        places[static_cast<std::size_t>(n)] = n;
    std::vector<QRgb> colors(count);
    gradient.colorize(places.data(), QCPRange(0.0, count - 1.0), colors.data(), count);
    return colors;
}

/// How often a dimension is looked up. The edges between grid points are straight, but a cell of
/// four points is not flat.
int samplesOf(std::uint32_t size, int most)
{
    const int points = static_cast<int>(size);
    if (points >= most)
        return most;
    constexpr int enough = 96;
    const int perCell = std::max(1, std::min(enough, most) / (points - 1));
    return (points - 1) * perCell + 1;
}

/// Lines at every so many grid points: never more than can be told apart.
std::size_t lineStep(std::uint32_t size)
{
    constexpr std::size_t most = 24;
    std::size_t step = 1;
    for (const std::size_t factor : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000})
        if ((step = factor) * most >= size)
            break;
    return std::max(step, std::size_t{size} / (4 * most));
}

/// The samples of a table, row by row.
class Mesh {
public:
    Mesh(const SurfaceSight& sight, int samples)
        : m_sight(sight)
        , m_lookup(*sight.table)
        , m_projection(sight)
        , m_columns(samplesOf(sight.table->grid.axes[0].size, samples))
        , m_rows(samplesOf(sight.table->grid.axes[1].size, samples))
    {
    }

    [[nodiscard]] int rows() const { return m_rows; }

    [[nodiscard]] std::vector<Corner> row(int index) const
    {
        const GridAxis& axis = m_sight.table->grid.axes[1];
        const double y = axis.start + spanOf(axis) * index / (m_rows - 1.0);
        return alongX(y, m_columns);
    }

    void drawLines(Canvas& canvas, const QColor& color) const
    {
        const auto polyline = [&](const std::vector<Corner>& line) {
            constexpr int strength = 90;
            for (std::size_t n = 1; n < line.size(); ++n)
                canvas.line(line[n - 1], line[n], color, strength);
        };
        const GridAxis& x = m_sight.table->grid.axes[0];
        const GridAxis& y = m_sight.table->grid.axes[1];
        for (std::size_t j = 0; j < y.size; j += lineStep(y.size))
            polyline(alongX(y.position(j), m_columns));
        for (std::size_t i = 0; i < x.size; i += lineStep(x.size)) {
            std::vector<Corner> line;
            for (int n = 0; n < m_rows; ++n)
                line.push_back(corner(x.position(i), y.start + spanOf(y) * n / (m_rows - 1.0)));
            polyline(line);
        }
    }

private:
    [[nodiscard]] Corner corner(double x, double y) const
    {
        const double value = m_lookup.at(x, y);
        const auto place = m_projection.at(x, y, value);
        return {static_cast<float>(place.x), static_cast<float>(place.y),
            static_cast<float>(place.depth), static_cast<float>(value)};
    }
    [[nodiscard]] std::vector<Corner> alongX(double y, int count) const
    {
        const GridAxis& axis = m_sight.table->grid.axes[0];
        std::vector<Corner> corners;
        corners.reserve(static_cast<std::size_t>(count));
        for (int n = 0; n < count; ++n)
            corners.push_back(corner(axis.start + spanOf(axis) * n / (count - 1.0), y));
        return corners;
    }

    const SurfaceSight& m_sight;
    Lookup m_lookup;
    SurfaceProjection m_projection;
    int m_columns;
    int m_rows;
};

} // namespace

SurfaceProjection::SurfaceProjection(const SurfaceSight& sight)
{
    const GridAxis& x = sight.table->grid.axes[0];
    const GridAxis& y = sight.table->grid.axes[1];
    m_middleX = x.start + spanOf(x) / 2.0;
    m_middleY = y.start + spanOf(y) / 2.0;
    m_middleValue = (sight.heights[0] + sight.heights[1]) / 2.0;
    // True to scale, but for tables that would be a thin strip.
    constexpr double narrowest = 0.25;
    const double second = secondUnit(*sight.table);
    const double longer = std::max(spanOf(x), spanOf(y) * second);
    m_perX = std::max(1.0 / longer, narrowest / spanOf(x));
    m_perY = std::max(second / longer, narrowest / spanOf(y));
    m_perValue = sight.exaggeration * valueUnit(*sight.table) / longer;
    constexpr double degree = M_PI / 180.0;
    m_turn = {std::sin(sight.turn * degree), std::cos(sight.turn * degree)};
    m_tilt = {std::sin(sight.tilt * degree), std::cos(sight.tilt * degree)};
    // The same size at every turn, with room for the texts around it.
    const double radius = std::hypot(spanOf(x) * m_perX, spanOf(y) * m_perY) / 2.0;
    const double height = (sight.heights[1] - sight.heights[0]) * m_perValue / 2.0;
    const double sideRoom = 80.0 * sight.ratio;
    const double topRoom = 38.0 * sight.ratio;
    m_pixels = sight.zoom
        * std::max(1.0,
            std::min((sight.size.width() / 2.0 - sideRoom) / radius,
                (sight.size.height() / 2.0 - topRoom) / (radius * m_tilt[0] + height * m_tilt[1])));
    m_centre = QPointF(sight.size.width() / 2.0, sight.size.height() / 2.0);
}

SurfaceProjection::Place SurfaceProjection::at(double x, double y, double value) const
{
    const double along = (x - m_middleX) * m_perX;
    const double across = (y - m_middleY) * m_perY;
    const double up = (value - m_middleValue) * m_perValue;
    const double right = along * m_turn[1] - across * m_turn[0];
    const double away = along * m_turn[0] + across * m_turn[1];
    return {m_centre.x() + m_pixels * right,
        m_centre.y() - m_pixels * (away * m_tilt[0] + up * m_tilt[1]),
        m_pixels * (away * m_tilt[1] - up * m_tilt[0])};
}

bool hasOneScale(const CompensationTable& table)
{
    const auto& axes = table.grid.axes;
    return commonUnitFactor(axes[1].unit, axes[0].unit)
        && commonUnitFactor(table.unit, axes[0].unit);
}

double fittingExaggeration(const CompensationTable& table, const std::array<double, 2>& heights)
{
    const double height = (heights[1] - heights[0]) * valueUnit(table);
    const double width =
        std::max(spanOf(table.grid.axes[0]), spanOf(table.grid.axes[1]) * secondUnit(table));
    constexpr double part = 1.0 / 3.0;
    return part * width / height;
}

QImage surfaceImage(const SurfaceSight& sight, QCPColorGradient gradient, const QCPRange& colors,
    const QColor& lines, int samples)
{
    const std::vector<QRgb> table = colorTable(gradient);
    Canvas canvas(sight.size, table, colors);
    const Mesh mesh(sight, samples);
    std::vector<Corner> row = mesh.row(0);
    for (int n = 1; n < mesh.rows(); ++n) {
        std::vector<Corner> next = mesh.row(n);
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            canvas.triangle(row[i], row[i + 1], next[i]);
            canvas.triangle(next[i], row[i + 1], next[i + 1]);
        }
        row = std::move(next);
    }
    mesh.drawLines(canvas, lines);
    return canvas.image();
}

} // namespace axiscomp::ui
