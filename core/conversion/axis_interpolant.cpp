// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/axis_interpolant.h"

#include "core/curve/cubic_curve.h"
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
    if (m_wrap)
        line.values.back() = line.values.front();
    if (m_method == ResamplingMethod::MonotoneCubic)
        line.slopes = monotoneSlopes(m_knots, line.values, m_wrap.has_value());
    if (m_method == ResamplingMethod::SmoothingSpline)
        smooth(line);
    if (followsCurve(m_method))
        line.slopes = splineSlopes(m_knots, line.values, m_wrap.has_value());
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
    if (m_method != ResamplingMethod::MonotoneCubic)
        return value;
    // rounding must not overshoot either
    return std::clamp(value, std::min(from, to), std::max(from, to));
}

} // namespace axiscomp
