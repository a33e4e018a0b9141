// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <span>
#include <string>
#include <string_view>

namespace axiscomp::app {

enum class TableFormat { Csv, TamTable };

/// What a table format is called and what it can hold.
struct TableFormatInfo {
    TableFormat format = TableFormat::Csv;
    std::string_view name; ///< "tamtbl": for --from and --to
    std::string_view extension; ///< ".TAMtbl"
    bool severalTables = false;
    bool holdsNames = false; ///< of the dimensions
    bool holdsUnits = false;
    bool holdsNotes = false;
    bool holdsPersistency = false;
    bool isText = false;
    std::string_view numbers; ///< how the values are kept
    std::string_view description;
};

[[nodiscard]] std::span<const TableFormatInfo> tableFormats();
[[nodiscard]] const TableFormatInfo& formatInfo(TableFormat format);

/// By name when one is given, else by the extension of the file, upper or lower case. Errors:
/// UnknownFormat.
[[nodiscard]] Result<TableFormat> chooseFormat(const std::string& file, const std::string& name);

} // namespace axiscomp::app
