// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/register_access.h"
#include "core/axis/source_directory.h"
#include "core/store/backup.h"

namespace axiscomp {

/// Fills in which axis a backup is of, in which units its table is, and how its bytes are read:
/// name, unit, the units of the sources, which its registers name, and the profile. Without them
/// nobody could tell later that the same numbers mean something else.
[[nodiscard]] Result<void> describeAxis(
    const RegisterAccess& access, SourceDirectory& sources, AxisBackup& backup);

/// The axis of a backup, as it is on the drive.
struct RestoredAxis {
    bool hasSameName = false; ///< as when the backup was made
    std::vector<Text> doubts; ///< what cannot be told for sure, for whoever decides
};

/// That the axis is still the one of the backup, and that the numbers of its table mean what they
/// meant. Errors: TargetMismatch, UnitMismatch, InvalidArgument for another layout of table files.
[[nodiscard]] Result<RestoredAxis> checkSameAxis(
    const RegisterAccess& access, SourceDirectory& sources, const AxisBackup& backup);

} // namespace axiscomp
