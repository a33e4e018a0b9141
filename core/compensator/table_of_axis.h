// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/drive/drive_profile.h"
#include "core/table/compensation_table.h"

#include <span>
#include <string>
#include <vector>

namespace axiscomp {

// What a drive knows of the table of an axis beside its numbers: a table file keeps none of it.

/// States the units in which the drive takes values and positions, where these are of a length or
/// an angle, and what the axis is among the sources; dimensions and target have the names of the
/// axes where these are letters. axes: all of the drive.
void describeTable(CompensationTable& table, const AxisStatus& status,
    std::span<const AxisInfo> axes, const DriveProfile& profile);

/// For a file that people read: dimensions and values that have no name get one.
void nameParts(CompensationTable& table);

/// For the same file: where the axis looks its table up, as far as that is known.
[[nodiscard]] std::vector<std::string> lookupNotes(
    const AxisStatus& status, const DriveProfile& profile);

} // namespace axiscomp
