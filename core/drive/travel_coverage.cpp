// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/travel_coverage.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// Beyond this a limit stands for none.
constexpr double largestLimit = 1e30;

/// What is shorter is a rounding of the table's positions.
constexpr double rounding = 1e-6;

double shareOf(const Travel& travel, const Travel& table)
{
    const double range = travel.high - travel.low;
    const double covered = std::min(travel.high, table.high) - std::max(travel.low, table.low);
    const double share = std::max(0.0, covered / range);
    return share > 1.0 - rounding ? 1.0 : share;
}

} // namespace

std::optional<Travel> travelBetween(double low, double high)
{
    if (!(low < high && -largestLimit < low && high < largestLimit))
        return std::nullopt;
    return Travel{low, high};
}

Result<std::vector<DimensionCoverage>> travelCoverage(const DriveProfile& profile,
    std::span<const DimSource> sources, const Grid& grid,
    const std::function<Result<std::optional<Travel>>(int axis)>& travelOf)
{
    std::vector<DimensionCoverage> dimensions;
    for (std::size_t n = 0; n < std::min(sources.size(), grid.axes.size()); ++n) {
        const auto axis = profile.axisOfPosition(sources[n].path);
        if (!axis)
            continue;
        AXISCOMP_TRY(const auto travel, travelOf(*axis));
        if (!travel)
            continue;
        const Travel table{grid.axes[n].start, grid.axes[n].last()};
        dimensions.push_back({n, *axis, *travel, table, shareOf(*travel, table)});
    }
    return dimensions;
}

} // namespace axiscomp
