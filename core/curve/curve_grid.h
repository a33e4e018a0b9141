// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/curve/fitted_curve.h"

#include <cstddef>
#include <string>

namespace axiscomp {

/// What a drive that interpolates linearly between even points makes of a curve.
struct CurveGrid {
    std::size_t points = 0;
    double largestDistance = 0.0; ///< of the straight lines from the curve, in the unit of values
    double distanceAt = 0.0; ///< the position of it
    /// The largest change of slope at a point, in values per position: times the speed it is the
    /// step of the velocity there.
    double largestSlopeChange = 0.0;
};

/// points >= 2 over from..to, the curve at each of them joined by straight lines. The largest
/// distance is looked for at all knots of the curve and of the grid and at 8 places between each
/// two, and then between these.
[[nodiscard]] CurveGrid curveGrid(
    const FittedCurve& curve, double from, double to, std::size_t points);

/// The fewest points of such a grid whose largest distance is not above `within`; every number
/// from 2 on is tried. Errors: ResamplingImpossible, with the distance that `most` points leave.
[[nodiscard]] Result<CurveGrid> fewestCurvePoints(const FittedCurve& curve, double from, double to,
    double within, std::size_t most, const std::string& valueUnit);

} // namespace axiscomp
