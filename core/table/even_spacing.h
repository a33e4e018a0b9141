// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace axiscomp {

/// Positions as an even line start + i * distance (docs/calibration-csv.md, "Grid").
struct EvenSpacing {
    double start = 0.0;
    double distance = 0.0;
    double tolerance = 0.0; ///< how far positions may be off the line
    double deviation = 0.0; ///< how far they are off
    std::size_t worst = 0; ///< the position that is off most
    bool even = false;
    bool rounded = false; ///< even, but only within what was printed
};

/// For lastDecimal: the positions were not printed, and only the rounding of doubles is left.
inline constexpr int noDecimals = -30;

/// lines: at least 2, strictly increasing, finite; lastDecimal: the exponent of ten of the last
/// decimal printed. The line is the least-squares line; where the positions are even but for the
/// rounding of doubles, it begins at the first of them and its distance is a short number. Fitting
/// start + i * distance again gives the same line.
[[nodiscard]] EvenSpacing fitEvenSpacing(std::span<const double> lines, int lastDecimal);

} // namespace axiscomp
