// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive/compensation_setup.h"
#include "core/drive/drive_profile.h"
#include "core/table/grid.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace axiscomp {

/// How far an axis may travel, in its position unit; low < high.
struct Travel {
    double low = 0.0;
    double high = 0.0;
    friend bool operator==(const Travel&, const Travel&) = default;
};

/// The limits as a drive says them: none where they are no range, such as 0 and 0 of an axis
/// without limits.
[[nodiscard]] std::optional<Travel> travelBetween(double low, double high);

/// A dimension of a table against the travel of the axis whose position selects the value.
struct DimensionCoverage {
    std::size_t dimension = 0; ///< from 0
    int axis = 0;
    Travel travel;
    Travel table; ///< its first and last position
    double share = 0.0; ///< of the travel for which the table has values, 0 to 1
};

/// For each dimension whose source is a position of an axis that says how far it travels. grid: in
/// the units of the drive. sources: one for each dimension. Errors: those of travelOf.
[[nodiscard]] Result<std::vector<DimensionCoverage>> travelCoverage(const DriveProfile& profile,
    std::span<const DimSource> sources, const Grid& grid,
    const std::function<Result<std::optional<Travel>>(int axis)>& travelOf);

} // namespace axiscomp
