// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/resampling.h"

namespace axiscomp {

/// What a grid may have, in memory and in any format.
constexpr std::size_t mostGridPoints = 4'000'000;

/// What becomes of one axis.
struct PlannedAxis {
    AxisGrid grid;
    std::vector<double> knots; ///< the grid's positions
    double from = 0.0; ///< the wanted range, in which deviations count
    double to = 0.0;
    bool isKept = false; ///< the knots are the source's own, and so are the values along them
    std::string remark; ///< empty: the grid is as wanted
};

/// points positions over a range: the first and the last exactly at its ends.
[[nodiscard]] PlannedAxis planPoints(
    const SourceAxis& axis, double from, double to, std::size_t points);

/// Errors: InvalidArgument, ResamplingImpossible.
[[nodiscard]] Result<PlannedAxis> planAxis(
    const NeutralTable& table, std::size_t axis, const AxisRequest& request, bool holdsEnds);

/// The distance of such a grid: a short number where that leads to the same end.
[[nodiscard]] double evenDistance(double from, double to, std::size_t points);

/// That the table is consistent and the values of modulo axes the same at both ends. Errors:
/// InvalidArgument, ResamplingImpossible.
[[nodiscard]] Result<void> checkResamplable(const NeutralTable& table);

/// table: resamplable; plan: one for each axis. Errors: ResamplingImpossible (numbers too large).
[[nodiscard]] Result<ResampledTable> resampleOnto(
    const NeutralTable& table, const std::vector<PlannedAxis>& plan, ResamplingMethod method);

} // namespace axiscomp
