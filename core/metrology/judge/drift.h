// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measurement.h"

namespace axiscomp {

// How far the runs of one direction lie beside each other: what warms up or slips during a
// measurement.

/// The runs of one direction, in mm or deg.
struct DirectionDrift {
    std::vector<int> runs; ///< their numbers, ascending
    std::vector<double> offset; ///< of run j: mean over the targets of x_ij - xm_i
    std::vector<double> slope; ///< of x_ij - xm_i over the targets, least squares; per mm or deg
    std::optional<double> trendPerRun; ///< of the offsets over the number of the run, least squares
    std::optional<double> firstToLast; ///< offset of the last run minus that of the first
    /// The spread that remains without the offsets: sqrt(sum (x_ij - xm_i - o_j)^2 / ((m-1)(n-1))).
    std::optional<double> sWithoutOffsets;
    std::optional<double> trendPerHour; ///< of the offsets over time, where the values have it
    std::optional<double> trendPerKelvin; ///< over temperature, where the values have it
    /// |first to last| > 3 sqrt(2) sWithoutOffsets / sqrt(m), and above a tenth of the direction's
    /// R.
    bool isSuspected = false;
};

/// Of the values in use. Needs two runs and two targets; otherwise there is nothing to tell.
[[nodiscard]] DirectionDrift driftOf(const Measurement& measurement, Approach direction);

enum class DriftRemoval {
    Offset, ///< each run's own offset
    Trend, ///< the straight line through the offsets, 0 at their mean
};
/// The values without the drift of each direction: for a table, and to see what the drift costs.
/// Never for the figures of an acceptance.
[[nodiscard]] Measurement withoutDrift(Measurement measurement, DriftRemoval removal);

} // namespace axiscomp
