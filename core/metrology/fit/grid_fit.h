// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/table/grid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace axiscomp {

/// Values that were measured anywhere; a position may occur more than once.
struct ScatteredValues {
    std::array<std::span<const double>, 3> coordinates; ///< of as many dimensions as the grid has
    std::span<const double> values;
    std::span<const double> weights = {}; ///< > 0, as numbers of values; empty: 1 each
};

/// What becomes of points of the grid that are far from any measured one.
enum class FarPoints {
    Refuse,
    Smooth, ///< as the smoothness has it
    Nearest, ///< the value of the nearest point of the grid that is not far
};

struct GridFitRequest {
    Grid grid;
    std::optional<double> smoothness = {}; ///< S >= 0; none: by cross-validation
    bool isRobust = false; ///< gross errors are given less weight
    FarPoints farPoints = FarPoints::Refuse;
    /// Values of the nodes that a curve has: not fitted, but filled and described alike. Empty:
    /// none. They go with neither a smoothness nor weights of a robust fit.
    std::vector<double> nodes = {};
    std::stop_token stop = {};
};

/// A point whose weight a robust fit made small.
struct DoubtfulPoint {
    std::size_t index = 0; ///< in ScatteredValues
    double residual = 0.0;
    double weight = 1.0; ///< 0 to 1
};

struct GridFit {
    std::vector<double> values; ///< one for each point of the grid, dimension 1 fastest
    std::vector<std::uint32_t> filled; ///< ascending: no measured point in a neighbouring cell
    std::size_t usedPoints = 0;
    std::size_t outside = 0; ///< points outside the grid, left out
    double smoothness = 0.0; ///< S
    std::optional<double> crossValidation = {}; ///< rms at points that were left out, each once
    double residualRms = 0.0; ///< at the points, weighted: what the drive will leave
    double residualLargest = 0.0;
    std::size_t largestAt = 0; ///< index in ScatteredValues
    std::optional<double> repeatability = {}; ///< sigma within repeated points
    double explained = 0.0; ///< share of the variance of the values, 0 to 1
    double valueRms = 0.0; ///< of the values about their mean
    std::vector<DoubtfulPoint> doubtful; ///< by index; weight below 0.3

    /// Left-out points are foretold little better than by the mean.
    [[nodiscard]] bool explainsLittle() const
    {
        return crossValidation && *crossValidation > 0.8 * valueRms;
    }
};

/// Scattered values onto an even grid of 1 to 3 dimensions by penalised least squares under the
/// drive's own interpolation: the c that makes
///     sum_k w_k (v_k - B_k c)^2 + L |D c|^2
/// smallest, with B_k the linear, bilinear or trilinear weights at point k, and D the second
/// differences along each axis a times (h / h_a)^2 and the mixed ones of two axes times
/// sqrt(2) h^2 / (h_a h_b); h_a are the distances, h their geometric mean. L = S points / nodes,
/// so that S has no unit (known as gridfit or regularizeNd; the penalty is that of a thin plate).
///
/// S is chosen by 5-fold cross-validation, in which repeated points stay together: by half decades,
/// then finer. Above 50 000 points, or many nodes, that is done with some of the points on a
/// coarser grid, carried over by S points h^4, and compared with 3 S and S / 3 on a tenth of all
/// points that is left out. Huber's weights (1.345 sigma) where it is robust.
///
/// The result does not depend on the order of the points. With S = 0 and all points on nodes it is
/// exactly their means. Errors: InvalidArgument; NoDataThere for nodes without a point within 3
/// distances along every axis; NotConverged; Cancelled.
[[nodiscard]] Result<GridFit> fitGrid(const ScatteredValues& values, const GridFitRequest& request);

} // namespace axiscomp
