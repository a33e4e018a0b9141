// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/contours.h"
#include "core/base/portable_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace axiscomp {

namespace {

/// An edge of the grid: twice the index of its first point, plus 1 when it runs along dimension 2.
using Edge = std::uint32_t;
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A line through one cell, from edge to edge.
struct Segment {
    std::array<Edge, 2> ends{};
    std::uint32_t cell = 0; ///< index of its first point
};

/// The values at a cell's corners, as a function of u and v, 0 to 1 along dimension 1 and 2.
struct Bilinear {
    double base, alongU, alongV, twist;

    [[nodiscard]] double at(double u, double v) const
    {
        return base + alongU * u + alongV * v + twist * u * v;
    }
};

class Tracer {
public:
    explicit Tracer(const CompensationTable& table)
        : m_table(table)
        , m_width(table.grid.axes[0].size)
        , m_height(table.grid.axes[1].size)
        , m_segmentsAt(2 * table.values.size(), {none, none})
        , m_pieces(piecesFor(std::max(m_width, m_height)))
    {
    }

    /// All segments of all levels, in one pass over the table.
    void collect(const std::vector<double>& levels)
    {
        m_levels = levels;
        m_segments.assign(levels.size(), {});
        std::vector<std::uint8_t> row = classesOf(0);
        for (std::uint32_t j = 0; j + 1 < m_height; ++j) {
            std::vector<std::uint8_t> next = classesOf(j + 1);
            for (std::uint32_t i = 0; i + 1 < m_width; ++i) {
                const auto [low, high] = std::minmax({row[i], row[i + 1], next[i], next[i + 1]});
                for (std::size_t level = low; level < high; ++level)
                    addCell(level, i + j * m_width);
            }
            row = std::move(next);
        }
    }

    [[nodiscard]] Contour contour(std::size_t level)
    {
        m_level = m_levels[level];
        m_current = &m_segments[level];
        const auto count = static_cast<std::uint32_t>(m_current->size());
        m_isUsed.assign(count, false);
        for (std::uint32_t n = 0; n < count; ++n)
            for (const Edge edge : (*m_current)[n].ends)
                m_segmentsAt[edge][m_segmentsAt[edge][0] == none ? 0 : 1] = n;
        Contour result{m_level, {}};
        // Lines that end at the border first: what is left then are rings.
        for (const bool isBorder : {true, false}) {
            for (std::uint32_t n = 0; n < count; ++n)
                for (const Edge edge : (*m_current)[n].ends)
                    if (!m_isUsed[n] && (!isBorder || m_segmentsAt[edge][1] == none))
                        trace(n, edge, result);
        }
        for (const Segment& segment : *m_current)
            for (const Edge edge : segment.ends)
                m_segmentsAt[edge] = {none, none};
        return result;
    }

private:
    /// A cell of a coarse table is large on the screen, and its lines are curved.
    static int piecesFor(std::uint32_t size)
    {
        constexpr std::uint32_t wanted = 256;
        return static_cast<int>(std::clamp(wanted / size, 1U, 32U));
    }

    [[nodiscard]] double value(std::size_t point) const
    {
        return static_cast<double>(m_table.values[point]);
    }

    /// For each point of a row, how many levels are not above its value.
    [[nodiscard]] std::vector<std::uint8_t> classesOf(std::uint32_t j) const
    {
        std::vector<std::uint8_t> classes(m_width, 0);
        const float* values = m_table.values.data() + std::size_t{j} * m_width;
        for (const double level : m_levels)
            for (std::uint32_t i = 0; i < m_width; ++i)
                classes[i] = static_cast<std::uint8_t>(
                    classes[i] + (static_cast<double>(values[i]) >= level ? 1 : 0));
        return classes;
    }

    void addCell(std::size_t level, std::uint32_t cell)
    {
        const double at = m_levels[level];
        const bool a = value(cell) >= at;
        const bool b = value(cell + 1) >= at;
        const bool c = value(cell + m_width) >= at;
        const bool d = value(cell + m_width + 1) >= at;
        const Edge bottom = 2 * cell;
        const Edge left = 2 * cell + 1;
        const Edge top = 2 * (cell + m_width);
        const Edge right = 2 * (cell + 1) + 1;
        std::vector<Segment>& segments = m_segments[level];
        if (a == d && b == c && a != b) {
            // Two lines, around the two corners that the middle of the saddle is not joined to.
            const bool isMiddleAbove = saddleValue(cell) >= at;
            if (isMiddleAbove == a) {
                segments.push_back({{bottom, right}, cell});
                segments.push_back({{left, top}, cell});
            } else {
                segments.push_back({{bottom, left}, cell});
                segments.push_back({{right, top}, cell});
            }
            return;
        }
        std::array<Edge, 4> crossed{};
        std::size_t count = 0;
        for (const auto& [edge, isCrossed] : {std::pair(bottom, a != b), std::pair(left, a != c),
                 std::pair(right, b != d), std::pair(top, c != d)})
            if (isCrossed)
                crossed.at(count++) = edge;
        segments.push_back({{crossed[0], crossed[1]}, cell});
    }

    [[nodiscard]] Bilinear bilinear(std::uint32_t cell) const
    {
        const double a = value(cell);
        const double b = value(cell + 1);
        const double c = value(cell + m_width);
        const double d = value(cell + m_width + 1);
        return {a, b - a, c - a, a - b - c + d};
    }

    /// Where the surface of a cell is level, its two lines of a saddle meet.
    [[nodiscard]] double saddleValue(std::uint32_t cell) const
    {
        const Bilinear f = bilinear(cell);
        return f.base
            - f.alongU * f.alongV / f.twist; // the corners differ crosswise: no twist of 0
    }

    /// In grid points.
    [[nodiscard]] ContourPoint crossing(Edge edge) const
    {
        const std::uint32_t point = edge / 2;
        const bool isUp = edge % 2 == 1;
        const double from = value(point);
        const double to = value(isUp ? point + m_width : point + 1);
        const double part = std::clamp((m_level - from) / (to - from), 0.0, 1.0);
        return {static_cast<double>(point % m_width) + (isUp ? 0.0 : part),
            static_cast<double>(point / m_width) + (isUp ? part : 0.0)};
    }

    void add(ContourLine& line, const ContourPoint& place) const
    {
        const GridAxis& x = m_table.grid.axes[0];
        const GridAxis& y = m_table.grid.axes[1];
        const ContourPoint point{x.start + place.x * x.distance, y.start + place.y * y.distance};
        if (line.points.empty() || line.points.back() != point)
            line.points.push_back(point);
    }

    /// The points between the ends of a segment: those of the straight line, moved across it until
    /// the surface has the level.
    void addBetween(ContourLine& line, const Segment& segment, const ContourPoint& from,
        const ContourPoint& to) const
    {
        const Bilinear f = bilinear(segment.cell);
        const auto left = static_cast<double>(segment.cell % m_width);
        const auto below = static_cast<double>(segment.cell / m_width);
        const double du = to.x - from.x;
        const double dv = to.y - from.y;
        for (int n = 1; n < m_pieces && f.twist != 0.0; ++n) {
            const double part = static_cast<double>(n) / m_pieces;
            const double u = from.x - left + part * du;
            const double v = from.y - below + part * dv;
            // f at (u - s dv, v + s du) is level: a quadratic equation, its root nearest to 0.
            const double c0 = f.at(u, v) - m_level;
            const double c1 = -(f.alongU + f.twist * v) * dv + (f.alongV + f.twist * u) * du;
            const double c2 = -f.twist * du * dv;
            const double root = c1 * c1 - 4.0 * c0 * c2;
            const double divisor = c1 + std::copysign(std::sqrt(std::max(root, 0.0)), c1);
            if (root < 0.0 || divisor == 0.0)
                continue;
            const double s = -2.0 * c0 / divisor;
            add(line,
                {left + std::clamp(u - s * dv, 0.0, 1.0),
                    below + std::clamp(v + s * du, 0.0, 1.0)});
        }
    }

    void trace(std::uint32_t segment, Edge from, Contour& result)
    {
        ContourLine line;
        ContourPoint last = crossing(from);
        add(line, last);
        while (segment != none && !m_isUsed[segment]) {
            m_isUsed[segment] = true;
            const Segment& current = (*m_current)[segment];
            const Edge to = current.ends[0] == from ? current.ends[1] : current.ends[0];
            const ContourPoint next = crossing(to);
            addBetween(line, current, last, next);
            add(line, next);
            last = next;
            from = to;
            const auto& [first, second] = m_segmentsAt[to];
            segment = first == segment ? second : first;
        }
        if (line.points.size() > 1)
            result.lines.push_back(std::move(line));
    }

    const CompensationTable& m_table;
    std::uint32_t m_width;
    std::uint32_t m_height;
    std::vector<double> m_levels;
    std::vector<std::vector<Segment>> m_segments; ///< by level
    std::vector<std::array<std::uint32_t, 2>> m_segmentsAt; ///< by edge, those of one level
    std::vector<Segment>* m_current = nullptr;
    std::vector<bool> m_isUsed;
    double m_level = 0.0;
    int m_pieces;
};

} // namespace

std::vector<double> roundLevels(double low, double high, int most)
{
    if (!(high > low) || !std::isfinite(high - low))
        return {};
    // Multiples of a whole number of powers of ten: 3 * 0.1 is not 0.3.
    int exponent = static_cast<int>(std::floor(portable::log10((high - low) / most)));
    double factor = 1.0;
    const auto step = [&] { return factor * portable::pow(10.0, exponent); };
    while ((high - low) / step() > static_cast<double>(most)) {
        factor = factor == 1.0 ? 2.0 : factor == 2.0 ? 5.0 : 10.0;
        if (factor == 10.0) {
            factor = 1.0;
            ++exponent;
        }
    }
    const double power = portable::pow(10.0, std::abs(exponent));
    std::vector<double> levels;
    for (double n = std::floor(low / step()) - 1.0; n <= high / step() + 1.0; ++n) {
        const double level = exponent < 0 ? n * factor / power : n * factor * power;
        if (level > low && level < high)
            levels.push_back(level);
    }
    return levels;
}

std::vector<double> contourLevels(const CompensationTable& table)
{
    constexpr int most = 10;
    const auto [lowest, highest] = std::ranges::minmax(table.values);
    return roundLevels(static_cast<double>(lowest), static_cast<double>(highest), most);
}

std::vector<Contour> contours(const CompensationTable& table, const std::vector<double>& levels)
{
    Tracer tracer(table);
    tracer.collect(levels);
    std::vector<Contour> result;
    for (std::size_t level = 0; level < levels.size(); ++level)
        result.push_back(tracer.contour(level));
    return result;
}

} // namespace axiscomp
