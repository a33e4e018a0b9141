// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/drive_units.h"

namespace axiscomp {

Result<TableUnits> driveUnits(const DriveProfile& profile, std::span<const DimSource> sources,
    int axis, const std::function<Result<std::string>(int axis)>& unitOf)
{
    AXISCOMP_TRY(auto own, unitOf(axis));
    TableUnits units{std::move(own), {}};
    for (const DimSource& source : sources) {
        std::string& unit = units.positions.emplace_back();
        if (const auto owner = profile.axisOfPosition(source.path)) {
            AXISCOMP_TRY(unit, unitOf(*owner));
        }
    }
    return units;
}

} // namespace axiscomp
