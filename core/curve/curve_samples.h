// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// Values that were found at positions, in any order; a position may occur more than once.
struct CurveSamples {
    std::span<const double> positions; ///< finite
    std::span<const double> values; ///< finite, one for each position
    std::span<const double> weights = {}; ///< > 0, as numbers of values; empty: 1 each
    std::string unit = {}; ///< of the positions, for what is said about them
};

/// The same, one value for each place.
struct CurveKnots {
    std::vector<double> positions; ///< strictly ascending; on a modulo axis within one period
    std::vector<double> means; ///< weighted
    std::vector<double> weights; ///< their sums
};

/// Positions that differ by less than 1e-9 of the range (of the period, on a modulo axis) are one
/// place. The result does not depend on the order of the samples. Errors: InvalidArgument for
/// numbers that make no sense, and for fewer places than `fewest`.
[[nodiscard]] Result<CurveKnots> curveKnots(
    const CurveSamples& samples, std::optional<double> wrap, std::size_t fewest);

} // namespace axiscomp
