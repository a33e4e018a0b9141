// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

/// One of the tables of a file, as people name it.
struct TableName {
    std::string name;
    std::string text; ///< as a list of them shows it
};

/// "1 (X error), 2 (Y error)"
[[nodiscard]] std::string tableList(std::span<const TableName> tables);

/// The index of the table that "Table 2", "2", "#2" or "name:2" means, or its text in the list.
/// Errors: TableNotFound; TableAmbiguous for the number of one table that is the name of another,
/// and for a name of several.
[[nodiscard]] Result<std::size_t> chooseTable(
    std::span<const TableName> tables, std::string_view asked);

} // namespace axiscomp
