// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/resampling.h"
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

    /// The values at the knots of one line, and what the method makes of them.
    struct Line {
        std::vector<double> values;
        std::vector<double> slopes; ///< of curves
    };
    /// first: the line's first value; the others follow at distances of stride.
    /// A line that cannot be smoothed becomes not-a-number.
    void load(const double* first, std::size_t stride, Line& line) const;
    [[nodiscard]] double at(const Line& line, const Place& place) const;
    [[nodiscard]] FittedCurve curve(const Line& line) const;

private:
    void smooth(Line& line) const;

    std::size_t m_count; ///< of the axis's own knots
    std::vector<double> m_knots; ///< those of a modulo axis end with the first one again
    std::optional<double> m_wrap;
    ResamplingMethod m_method;
    double m_rounding; ///< of positions
};

} // namespace axiscomp
