// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/resampling/resampling.h"
#include "core/curve/eight_lines.h"
#include "core/curve/fitted_curve.h"

#include <span>

namespace axiscomp {

/// Values along one axis of a table, line by line. Beyond the knots the ends are held; on a modulo
/// axis the values repeat.
class AxisInterpolant {
public:
    AxisInterpolant(const SourceAxis& axis, ResamplingMethod method);

    struct Place {
        std::size_t knot = 0; ///< at or before the place
        double fraction = 0.0; ///< of the way to the next one; exactly 0 at a knot
    };
    [[nodiscard]] Place placeOf(double position) const;

    /// The values at the knots of one line, or of eight, and what the method makes of them.
    template <typename Number> struct LineOf {
        std::vector<Number> values;
        std::vector<Number> slopes; ///< of curves
    };
    using Line = LineOf<double>;
    using EightLines = LineOf<Eight>;
    /// first: the line's first value; the others follow at distances of stride.
    /// A line that cannot be smoothed becomes not-a-number.
    void load(const double* first, std::size_t stride, Line& line) const;
    [[nodiscard]] double at(const Line& line, const Place& place) const;
    [[nodiscard]] FittedCurve curve(const Line& line) const;

    /// The same for eight lines at once, and with the same bits. firsts: of the lines' first values
    /// from values on.
    void load(const double* values, const EightPlaces& firsts, std::size_t stride,
        EightLines& lines) const;
    void at(const EightLines& lines, const Place& place, Eight& found) const
    {
        interpolate(lines, place, found);
    }

private:
    void smooth(Line& line) const;
    void smooth(EightLines& lines) const;
    template <typename Number> void prepare(LineOf<Number>& line) const;
    template <typename Number>
    void interpolate(const LineOf<Number>& line, const Place& place, Number& found) const;

    std::size_t m_count; ///< of the axis's own knots
    std::vector<double> m_knots; ///< those of a modulo axis end with the first one again
    std::optional<double> m_wrap;
    ResamplingMethod m_method;
    double m_rounding; ///< of positions
};

template <typename Number>
inline void AxisInterpolant::interpolate(
    const LineOf<Number>& line, const Place& place, Number& found) const
{
    const Number& from = line.values[place.knot];
    found = from;
    if (place.fraction == 0.0)
        return;
    const Number& to = line.values[place.knot + 1];
    const double t = place.fraction;
    const Number rise = to - from;
    if (m_method == ResamplingMethod::Linear) {
        found = from + t * rise;
        return;
    }
    const double width = m_knots[place.knot + 1] - m_knots[place.knot];
    const Number begin = width * line.slopes[place.knot];
    const Number end = width * line.slopes[place.knot + 1];
    found =
        from + t * (begin + t * (3.0 * rise - 2.0 * begin - end + t * (begin + end - 2.0 * rise)));
    if (m_method != ResamplingMethod::MonotoneCubic)
        return;
    // rounding must not overshoot either
    const Number least = to < from ? to : from;
    const Number most = from < to ? to : from;
    const Number held = most < found ? most : found;
    found = found < least ? least : held;
}

} // namespace axiscomp
