// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/import_choices.h"
#include "core/table/compensation_table.h"
#include "core/table/table_layout.h"

namespace axiscomp {

/// A table of the drive as a file of another controller.
struct TableExport {
    std::string bytes; ///< of the file
    std::vector<Text> report;
};

/// choices: of the new file, its format is one that can be written. fileName: without folder, for
/// texts that name their own file. isComputed: as in ConversionRequest. Takes long; to be called
/// off the window's thread. Errors: those of convertTables.
[[nodiscard]] Result<TableExport> exportTable(const CompensationTable& table,
    const ImportChoices& choices, const std::string& fileName, const TableLayout& layout,
    bool isComputed = false);

} // namespace axiscomp
