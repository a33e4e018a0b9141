// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"
#include "core/store/store_folder.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace axiscomp {

/// A name that no file has yet: "2026-11-21T08-02-23.5Z-axis0.json", "...-axis0-2.json"; without an
/// axis "...-file.json"; after the clock was set back "...-axis0-clock2.json".
[[nodiscard]] std::filesystem::path newBackupFile(
    const StoreFolder& folder, WallTime time, std::optional<int> axis);

/// The backups of the axis, the one that was made last first, whatever the clock said.
[[nodiscard]] std::vector<std::filesystem::path> backupFiles(
    const StoreFolder& folder, std::optional<int> axis);

/// By the name of a backup of the axis; none: it is not such a name.
[[nodiscard]] std::optional<WallTime> timeOfBackup(const std::filesystem::path& file, int axis);

/// Deletes what a crash left behind, and the backups of the axis beyond the newest 50; not the one
/// that was just made, nor the one that the axis's journal names (may be empty). What cannot be
/// deleted stays.
void pruneBackups(const StoreFolder& folder, std::optional<int> axis,
    const std::filesystem::path& justMade, const std::filesystem::path& inJournal);

} // namespace axiscomp
