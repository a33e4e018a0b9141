// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/resampling/axis_interpolant.h"

#include "core/curve/curve_slopes.h"
#include "core/curve/smoothing_spline.h"
#include "core/neutral/table_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

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
    prepare(line);
}

void AxisInterpolant::load(
    const double* values, const EightPlaces& firsts, std::size_t stride, EightLines& lines) const
{
    lines.values.resize(m_knots.size());
    for (std::size_t i = 0; i < m_count; ++i)
        firsts.load(values + i * stride, lines.values[i]);
    prepare(lines);
}

template <typename Number> void AxisInterpolant::prepare(LineOf<Number>& line) const
{
    if (m_wrap)
        line.values.back() = line.values.front();
    const auto values = std::span<const Number>(line.values);
    if (m_method == ResamplingMethod::MonotoneCubic)
        findMonotoneSlopes<Number>(m_knots, values, m_wrap.has_value(), line.slopes);
    if (m_method == ResamplingMethod::SmoothingSpline)
        smooth(line);
    if (followsCurve(m_method))
        findSplineSlopes<Number>(m_knots, values, m_wrap.has_value(), line.slopes);
}

void AxisInterpolant::smooth(EightLines& lines) const
{
    Line line;
    for (std::size_t n = 0; n < 8; ++n) {
        line.values.clear();
        for (const Eight& values : lines.values)
            line.values.push_back(values[n]);
        smooth(line);
        for (std::size_t i = 0; i < line.values.size(); ++i)
            lines.values[i][n] = line.values[i];
    }
}

/// A smoothing spline is the natural spline through its own values at the knots.
void AxisInterpolant::smooth(Line& line) const
{
    const std::size_t places = m_knots.size() - (m_wrap ? 1 : 0); // the last one is the first
    const auto smoothed =
        smoothingSpline({std::span(m_knots).first(places), std::span(line.values).first(places)},
            {.smoothness = {}, .wrap = m_wrap, .periods = {}});
    for (std::size_t i = 0; i < places; ++i)
        line.values[i] =
            smoothed ? smoothed->curve.at(m_knots[i]) : std::numeric_limits<double>::quiet_NaN();
    if (m_wrap)
        line.values.back() = line.values.front();
}

FittedCurve AxisInterpolant::curve(const Line& line) const
{
    return {{m_knots, line.values, line.slopes, m_wrap}, {}};
}

double AxisInterpolant::at(const Line& line, const Place& place) const
{
    double found = 0.0;
    interpolate(line, place, found);
    return found;
}

} // namespace axiscomp
