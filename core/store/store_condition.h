// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/wall_time.h"
#include "core/drive/journal_entry.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace axiscomp {

/// What a state folder holds, and in which condition.
struct StoreCondition {
    enum class Database {
        None, ///< nothing was kept yet
        Usable,
        Older, ///< of an older version: whoever opens it next brings it up to date
        Newer, ///< of a newer version of this program
        Foreign, ///< of another program
        Damaged, ///< whoever opens it next sets it aside and recovers what can be read
        Busy, ///< programs write to it all the time, so that it could not be looked at
        NotCopied, ///< it could not be looked at, for the copy could not be written
        Unreadable,
    };
    Database database = Database::None;
    Text reason{}; ///< of Damaged, NotCopied and Unreadable
    std::uint64_t bytes = 0; ///< of the database and its log
    std::optional<WallTime> lastChange{}; ///< of the database
    bool isWritable = true; ///< by this user, where there is one

    struct Write {
        JournalEntry entry; ///< serial number, axis, time and step
        bool isBeingDone = false; ///< a program is writing to this drive now
    };
    std::vector<Write> unfinished{}; ///< writes that have begun and not ended
    std::vector<Error> damagedJournals{}; ///< of older versions, with what to do
    std::vector<std::int32_t> flashLoss{}; ///< drives whose flash operations count as used up
    std::vector<std::filesystem::path> setAside{}; ///< earlier databases that were damaged
    std::size_t drives = 0; ///< that have a folder
    std::size_t backups = 0;
    std::uint64_t backupBytes = 0;
};

/// Looks without changing anything in the state folder: the database is checked on a copy, which is
/// made in scratch, an empty folder that nobody else uses. What the copy holds may then be read as
/// a state folder of its own.
[[nodiscard]] StoreCondition lookAtStore(
    const std::filesystem::path& root, const std::filesystem::path& scratch);

} // namespace axiscomp
