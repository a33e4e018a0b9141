// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/sqlite.h"

#include <array>
#include <string_view>

namespace axiscomp {

/// Whose database a file is.
enum class StoreIdentity {
    Ours, ///< of this version
    Older, ///< of an older version
    Newer, ///< of a newer version of this program
    Foreign, ///< of another program
};
[[nodiscard]] StoreIdentity storeIdentity(sqlite::Connection& database);

/// Makes the tables of this version, in a transaction; for a new one and for Older.
void migrateStore(sqlite::Connection& database);

/// What is recovered from a damaged database.
inline constexpr std::array<std::string_view, 10> storeTables{"drive", "flash_operation",
    "flash_loss", "journal", "own_table", "saved_use", "covered_slot", "certificate", "measured",
    "measured_figure"};

} // namespace axiscomp
