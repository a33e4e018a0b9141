// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/compensation_setup.h"
#include "core/drive/drive_profile.h"
#include "core/table/table_units.h"

#include <functional>
#include <span>

namespace axiscomp {

/// In what a drive takes the table of an axis: values in the unit of the axis, positions in that of
/// the axis whose position a source is. unitOf: the PositionUnit of an axis, empty where the drive
/// does not say it. sources: one for each dimension. Errors: those of unitOf.
[[nodiscard]] Result<TableUnits> driveUnits(const DriveProfile& profile,
    std::span<const DimSource> sources, int axis,
    const std::function<Result<std::string>(int axis)>& unitOf);

} // namespace axiscomp
