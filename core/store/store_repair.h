// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

namespace axiscomp {

/// What SQLite may put beside a database: taken for that of another one with its name, it damages
/// it.
inline constexpr std::array<const char*, 3> databaseCompanions{"-shm", "-wal", "-journal"};
/// The file beside this one whose name has one more ending.
[[nodiscard]] std::filesystem::path withEnding(std::filesystem::path file, std::string_view ending);

/// Makes an empty database where there is none. It appears whole, so that an empty file is a
/// damaged one. To be called under the lock. Throws sqlite::Failure; errors: FileNotWritable.
[[nodiscard]] Result<void> makeStore(const std::filesystem::path& database);

/// Puts a database in place of a damaged one: with everything that can still be read of it, and
/// with a note that flash operations may be missing (flash_loss). The damaged one is kept as
/// axiscomp.db.damaged-TIME. To be called under the lock. Throws sqlite::Failure; errors:
/// FileNotWritable.
[[nodiscard]] Result<void> replaceDamagedStore(const std::filesystem::path& database);

/// Ends a replacement that was interrupted.
[[nodiscard]] Result<void> finishStoreReplacement(const std::filesystem::path& database);

/// The damaged databases that were kept, the oldest first.
[[nodiscard]] std::vector<std::filesystem::path> storesSetAside(
    const std::filesystem::path& database);

} // namespace axiscomp
