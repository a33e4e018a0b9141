// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_reader.h"
#include "core/store/backup.h"
#include "core/write/unfinished_write.h"
#include "core/write/write_plan.h"

namespace axiscomp {

/// As many sources as a backup may have.
inline constexpr int dimensionsOfBackup = 3;

/// Table, sources and table file of every axis with compensation registers.
[[nodiscard]] Result<DriveBackup> readBackupOf(const RegisterAccess& access,
    const DriveIdentity& drive, SourceDirectory& sources, WallTime now);

/// OtherDrive unless force, AxisNotFound when the backup has more axes than the drive,
/// InvalidBackup when it does not say which table an axis had.
[[nodiscard]] Result<void> checkRestorable(const RegisterAccess& access, const DriveBackup& backup,
    const DriveIdentity& drive, bool force);

/// The write that brings an axis back to its backup. Errors: those of checkSameAxis.
[[nodiscard]] Result<WriteRequest> restoreRequest(
    const RegisterAccess& access, SourceDirectory& sources, const AxisBackup& backup);

/// The source of dimension n in a list of registers; 0: none is set.
[[nodiscard]] std::uint32_t sourceAddress(
    const RegisterAccess& access, const std::vector<RegisterWrite>& registers, int axis, int n);

/// The register of that source; empty: not known, as of a backup of an older version.
[[nodiscard]] std::string sourcePath(const AxisBackup& backup, int n);

/// The sources of dimensions 1 .. count of a backup, as paths where it has them, otherwise as hex
/// addresses; "" where none is set.
[[nodiscard]] std::vector<std::string> sourceTexts(
    const RegisterAccess& access, const AxisBackup& backup, int count);

/// Which state an axis has after a write that did not end.
[[nodiscard]] Result<UnfinishedOutcome> unfinishedOutcome(const RegisterAccess& access,
    const DriveStore& store, const DriveIdentity& drive, const JournalEntry& entry,
    SourceDirectory& sources);

/// The files of a backup that no axis used then, but for those whose slot an axis uses once these
/// plans are written: its table went to a free slot, which may have been theirs.
[[nodiscard]] std::vector<AxisBackup::File> filesBesides(
    const DriveBackup& backup, std::span<const WritePlan> plans);

} // namespace axiscomp
