// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive/journal_entry.h"
#include "core/store/sqlite.h"

#include <filesystem>
#include <optional>
#include <vector>

/// The JSON files in which older versions kept what is in the database now.
namespace axiscomp {

/// Whether there is anything in the state folder: a database, one that is being replaced, or files
/// of older versions.
[[nodiscard]] bool hasStore(const std::filesystem::path& root);

/// Takes the files of older versions over, all in one transaction, and then renames them to
/// *.imported. A damaged one becomes *.broken; when that was a flash history, it is noted that
/// flash operations of the drive may be missing. A damaged journal stays where it is: see
/// journalOfOlderVersion. To be called under the lock. Throws sqlite::Failure; errors:
/// FileNotReadable, FileNotWritable.
[[nodiscard]] Result<void> takeOverJson(
    sqlite::Connection& database, const std::filesystem::path& root);

/// nullopt: there is none. Errors: FileNotReadable: it is damaged, with what to do about it.
[[nodiscard]] Result<std::optional<JournalEntry>> journalOfOlderVersion(
    const std::filesystem::path& root, std::int32_t serialNumber, int axis);

/// Those of all drives and axes; what is damaged is an error as above.
[[nodiscard]] std::vector<Result<JournalEntry>> journalsOfOlderVersion(
    const std::filesystem::path& root);

/// Renames it, so that it counts no more.
[[nodiscard]] Result<void> dropJournalOfOlderVersion(
    const std::filesystem::path& root, std::int32_t serialNumber, int axis);

} // namespace axiscomp
