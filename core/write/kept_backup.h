// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/drive/drive_profile.h"
#include "core/store/drive_store.h"
#include "core/table/compensation_table.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace axiscomp {

/// One axis of a backup file, as a person chooses among several.
struct KeptBackup {
    std::filesystem::path file;
    int axis = 0;
    /// Why it cannot be restored: it is damaged. Nothing below is known then, but perhaps the time.
    std::optional<Error> problem;
    std::optional<WallTime> time;
    DriveIdentity drive;
    std::string axisName;
    std::string unit; ///< as in AxisBackup
    std::string slot; ///< that the axis used
    std::shared_ptr<const CompensationTable> table; ///< null: the axis had none
    std::uint32_t tableCrc = 0; ///< of its elements, as the drive says it
    bool isPersistent = false;
    std::vector<RegisterWrite> registers; ///< as in AxisBackup
    /// What the write did that it was made for.
    enum class Write { NewTable, NoTable, Settings, Nothing };
    std::optional<Write> write; ///< none: only the next backup of the axis will tell
};

/// What each axis of a backup file had: its registers, and of the files only the table that it
/// used. Errors: those of loadOrdinaryFile and readBackup.
[[nodiscard]] Result<std::vector<AxisBackup>> axisBackupsIn(
    const std::filesystem::path& file, const DriveProfile& profile);

/// Those of a file for a person to choose among; of a damaged file one, with its problem.
[[nodiscard]] std::vector<KeptBackup> backupsToChoose(
    const std::filesystem::path& file, const DriveProfile& profile);

/// Of all axes of the drive, newest first.
[[nodiscard]] std::vector<KeptBackup> backupsToChoose(
    const DriveStore& store, const DriveIdentity& drive, const DriveProfile& profile);

} // namespace axiscomp
