// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace axiscomp {

/// A curve of cubic pieces, by its values y(i) and slopes y'(i) at knots x(i). With
/// h = x(i+1) - x(i) and t = (x - x(i)) / h it is in each piece (Hermite's form)
///
///     y(i) (1 - 3 t^2 + 2 t^3) + y(i+1) (3 t^2 - 2 t^3)
///         + h y'(i) t (1 - t)^2 - h y'(i+1) t^2 (1 - t)
///
/// Positions in one unit, values in another, slopes in values per position.
struct CubicCurve {
    std::vector<double> knots; ///< at least 2, strictly ascending; of a modulo axis one period
    std::vector<double> values;
    std::vector<double> slopes; ///< empty: straight lines between the knots
    std::optional<double> wrap = {}; ///< the period of a modulo axis: last knot - first knot

    /// Beyond the knots the ends are held, as the drive does it; on a modulo axis the curve
    /// repeats.
    [[nodiscard]] double at(double position) const;
    /// The same, faster where positions follow one another. piece: where the last one was found, 0
    /// for the first.
    [[nodiscard]] double at(double position, std::size_t& piece) const;
    /// Of a curve with slopes that is no turn, between its knots and at them.
    [[nodiscard]] double slopeAt(double position, std::size_t& piece) const;
};

/// The mean of two curves with slopes, none of a turn, that have more than a position in common.
/// Where one has ended the other goes on, and half of what was between them at that end stays.
[[nodiscard]] CubicCurve meanOf(const CubicCurve& one, const CubicCurve& other);

/// Repeats the first knot at the end of a curve with a period.
void closeIfWrapped(CubicCurve& curve);

/// Slopes of the natural cubic spline, as findSplineSlopes (curve_slopes.h) has them.
[[nodiscard]] std::vector<double> splineSlopes(
    std::span<const double> knots, std::span<const double> values, bool isClosed);

/// Slopes of the monotone cubic, as findMonotoneSlopes has them.
[[nodiscard]] std::vector<double> monotoneSlopes(
    std::span<const double> knots, std::span<const double> values, bool isClosed);

} // namespace axiscomp
