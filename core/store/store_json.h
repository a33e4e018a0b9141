// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/drive_store.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// Why a file of the store cannot be understood: "newCrc: this is missing".
using DocumentFault = Text;
template <typename T> using DocumentResult = tl::expected<T, DocumentFault>;

/// Bytes that such a file may have.
inline constexpr std::uint64_t maximumDocumentSize = 1024 * 1024;

/// Bytes that a kept table may have: several times what the largest slot of a drive holds.
inline constexpr std::uint64_t maximumKeptTableSize = 16 * 1024 * 1024;

/// A backup inside the folder is named relative to it, so that the store can be moved.
[[nodiscard]] std::string writeJournal(
    const JournalEntry& entry, const std::filesystem::path& folder);
[[nodiscard]] DocumentResult<JournalEntry> readJournal(
    std::string_view text, const std::filesystem::path& folder);

[[nodiscard]] std::string writeFlashHistory(const DriveStore::FlashHistory& history);
[[nodiscard]] DocumentResult<DriveStore::FlashHistory> readFlashHistory(std::string_view text);

/// A table that the program put into a slot for an axis.
struct WrittenTable {
    int axis = 0;
    DriveStore::OwnTable table;
    friend bool operator==(const WrittenTable&, const WrittenTable&) = default;
};
[[nodiscard]] std::string writeTables(const std::vector<WrittenTable>& tables);
[[nodiscard]] DocumentResult<std::vector<WrittenTable>> readTables(std::string_view text);

[[nodiscard]] std::string writeSavedState(const SavedState& state);
[[nodiscard]] DocumentResult<SavedState> readSavedState(std::string_view text);

} // namespace axiscomp
