// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/register_access.h"
#include "core/axis/source_directory.h"
#include "core/drive/drive_profile.h"
#include "core/store/backup.h"

#include <cstdint>
#include <vector>

namespace axiscomp {

/// Fills in which axis a backup is of, in which units its table is, and how its bytes are read:
/// name, unit, paths and units of the sources, which its registers name, and the profile. Without
/// them nobody could tell later that the same numbers mean something else. Errors: those of
/// keptSources.
[[nodiscard]] Result<void> describeAxis(
    const RegisterAccess& access, SourceDirectory& sources, AxisBackup& backup);

/// The sources of a backup, dimension by dimension: the registers of its paths, where it has them,
/// since a replaced drive or another version of its firmware may have others at the same addresses.
/// Errors: SourceNotFound where a register is not there any more.
[[nodiscard]] Result<std::vector<DimSource>> keptSources(
    const RegisterAccess& access, SourceDirectory& sources, const AxisBackup& backup);
/// Its registers, with the addresses that these sources have on the drive. Errors: likewise.
[[nodiscard]] Result<std::vector<RegisterWrite>> keptRegisters(
    const RegisterAccess& access, SourceDirectory& sources, const AxisBackup& backup);

/// That the profile reads the files of a backup as they were meant, as far as the backup says.
/// Where nothing but the profile of that drive has changed, as when it was put right, they are the
/// drive's own all the same. serialNumber: of the drive that gets them. Errors: InvalidArgument.
[[nodiscard]] Result<void> checkLayout(
    const AxisBackup& backup, const DriveProfile& profile, std::int32_t serialNumber);

/// Who brings the state of a backup back, and says so in a refusal.
enum class BroughtBackBy { Restore, Recovery };

/// The axis of a backup, as it is on the drive.
struct RestoredAxis {
    bool hasSameName = false; ///< as when the backup was made
    std::vector<Text> doubts; ///< what cannot be told for sure, for whoever decides
};

/// That the axis is still the one of the backup, and that the numbers of its table mean what they
/// meant. Errors: TargetMismatch, UnitMismatch, InvalidArgument for another layout of table files.
[[nodiscard]] Result<RestoredAxis> checkSameAxis(const RegisterAccess& access,
    SourceDirectory& sources, const AxisBackup& backup, BroughtBackBy by = BroughtBackBy::Restore);

} // namespace axiscomp
