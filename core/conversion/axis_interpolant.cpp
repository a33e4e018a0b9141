// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/axis_interpolant.h"

#include "core/neutral/table_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

/// The slope at a knot between two cells: a harmonic mean, weighted so that the cubic is monotone
/// where the knots are (Fritsch and Butland 1984, as in SLATEC's PCHIM).
double innerSlope(double leftWidth, double left, double rightWidth, double right)
{
    if (!(left * right > 0.0))
        return 0.0;
    const double leftWeight = 2.0 * rightWidth + leftWidth;
    const double rightWeight = rightWidth + 2.0 * leftWidth;
    return (leftWeight + rightWeight) / (leftWeight / left + rightWeight / right);
}

/// The slope at an end: that of the parabola through three knots, bent as far as monotony demands.
double endSlope(double width, double slope, double nextWidth, double nextSlope)
{
    const double parabola =
        ((2.0 * width + nextWidth) * slope - width * nextSlope) / (width + nextWidth);
    if (!(parabola * slope > 0.0))
        return 0.0;
    const bool turns = slope * nextSlope < 0.0;
    return turns && std::abs(parabola) > 3.0 * std::abs(slope) ? 3.0 * slope : parabola;
}

} // namespace

AxisInterpolant::AxisInterpolant(const SourceAxis& axis, ResamplingMethod method)
    : m_count(axis.knots.size())
    , m_knots(axis.knots)
    , m_wrap(axis.wrap)
    , m_method(method)
{
    if (m_wrap && !isFullTurn(axis))
        m_knots.push_back(m_knots.front() + *m_wrap);
    m_rounding = 8.0 * std::numeric_limits<double>::epsilon()
        * std::max(std::abs(m_knots.front()), std::abs(m_knots.back()));
}

AxisInterpolant::Place AxisInterpolant::placeOf(double position) const
{
    if (m_wrap)
        position -= std::floor((position - m_knots.front()) / *m_wrap) * *m_wrap;
    if (position <= m_knots.front() + m_rounding)
        return {0, 0.0};
    if (position >= m_knots.back() - m_rounding)
        return {m_knots.size() - 1, 0.0};
    const auto above = std::ranges::upper_bound(m_knots, position);
    const auto knot = static_cast<std::size_t>(above - m_knots.begin()) - 1;
    // A position that is computed belongs to the knot that it is meant to meet.
    if (position - m_knots[knot] <= m_rounding)
        return {knot, 0.0};
    if (m_knots[knot + 1] - position <= m_rounding)
        return {knot + 1, 0.0};
    return {knot, (position - m_knots[knot]) / (m_knots[knot + 1] - m_knots[knot])};
}

void AxisInterpolant::load(const double* first, std::size_t stride, Line& line) const
{
    line.values.resize(m_knots.size());
    for (std::size_t i = 0; i < m_count; ++i)
        line.values[i] = first[i * stride];
    if (m_wrap)
        line.values.back() = line.values.front();
    if (m_method == ResamplingMethod::MonotoneCubic)
        findSlopes(line);
}

void AxisInterpolant::findSlopes(Line& line) const
{
    const std::size_t last = m_knots.size() - 1;
    const auto width = [this](std::size_t cell) { return m_knots[cell + 1] - m_knots[cell]; };
    const auto slope = [&](std::size_t cell) {
        return (line.values[cell + 1] - line.values[cell]) / width(cell);
    };
    line.slopes.resize(m_knots.size());
    for (std::size_t i = 1; i < last; ++i)
        line.slopes[i] = innerSlope(width(i - 1), slope(i - 1), width(i), slope(i));
    if (m_wrap) {
        line.slopes.front() = innerSlope(width(last - 1), slope(last - 1), width(0), slope(0));
        line.slopes.back() = line.slopes.front();
    } else if (last == 1) {
        line.slopes.front() = slope(0);
        line.slopes.back() = slope(0);
    } else {
        line.slopes.front() = endSlope(width(0), slope(0), width(1), slope(1));
        line.slopes.back() =
            endSlope(width(last - 1), slope(last - 1), width(last - 2), slope(last - 2));
    }
}

double AxisInterpolant::at(const Line& line, const Place& place) const
{
    const double from = line.values[place.knot];
    if (place.fraction == 0.0)
        return from;
    const double to = line.values[place.knot + 1];
    const double t = place.fraction;
    if (m_method == ResamplingMethod::Linear)
        return from + t * (to - from);
    const double rise = to - from;
    const double width = m_knots[place.knot + 1] - m_knots[place.knot];
    const double begin = width * line.slopes[place.knot];
    const double end = width * line.slopes[place.knot + 1];
    const double value =
        from + t * (begin + t * (3.0 * rise - 2.0 * begin - end + t * (begin + end - 2.0 * rise)));
    // rounding must not overshoot either
    return std::clamp(value, std::min(from, to), std::max(from, to));
}

} // namespace axiscomp
