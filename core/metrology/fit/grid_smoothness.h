// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/grid_points.h"

#include <stop_token>
#include <vector>

namespace axiscomp {

struct ChosenSmoothness {
    double smoothness = 1.0; ///< S
    double crossValidation = 0.0; ///< rms at points that were left out
};

/// S by cross-validation, as fitGrid describes it. points: in the order of locate. Errors:
/// InvalidArgument for too few points; NotConverged; Cancelled.
[[nodiscard]] Result<ChosenSmoothness> chooseSmoothness(
    const Grid& grid, const std::vector<GridPoint>& points, std::stop_token stop);

} // namespace axiscomp
