// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/store/sqlite.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace axiscomp {

inline constexpr std::string_view databaseName = "axiscomp.db";
/// What SQLite may put beside a database: taken for that of another one with its name, it damages
/// it.
inline constexpr std::array<const char*, 3> databaseCompanions{"-shm", "-wal", "-journal"};
/// The file beside this one whose name has one more ending.
[[nodiscard]] std::filesystem::path withEnding(std::filesystem::path file, std::string_view ending);

/// Before a database is opened, where SQLite would take an empty file for a new database, and
/// delete a log without one: throws sqlite::Failure. No file and no log are in order.
void checkStoreFile(const std::filesystem::path& database);
/// Reads all pages; throws sqlite::Failure, as damage where it is that.
void checkStorePages(sqlite::Connection& database);

/// Makes an empty database where there is none. It appears whole, so that an empty file is a
/// damaged one. To be called under the lock. Throws sqlite::Failure; errors: FileNotWritable.
[[nodiscard]] Result<void> makeStore(const std::filesystem::path& database);

/// Puts a database in place of a damaged one: with everything that can still be read of it, and
/// with a note that flash operations may be missing (flash_loss). The damaged one is kept as
/// axiscomp.db.damaged-TIME. To be called under the lock. Throws sqlite::Failure; errors:
/// FileNotWritable.
[[nodiscard]] Result<void> replaceDamagedStore(const std::filesystem::path& database);

/// What a replacement that was interrupted has built: it counts in place of the database.
[[nodiscard]] std::optional<std::filesystem::path> recoveredFile(
    const std::filesystem::path& database);
/// Ends a replacement that was interrupted.
[[nodiscard]] Result<void> finishStoreReplacement(const std::filesystem::path& database);

/// The damaged databases that were kept, the oldest first.
[[nodiscard]] std::vector<std::filesystem::path> storesSetAside(
    const std::filesystem::path& database);

} // namespace axiscomp
