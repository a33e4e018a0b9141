// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/import_choices.h"
#include "core/table/compensation_table.h"
#include "core/table/table_layout.h"

#include <string>
#include <vector>

namespace axiscomp {

/// A table of the drive as a file of another controller.
struct TableExport {
    std::string bytes; ///< of the file
    std::vector<Text> report;
};

/// What is known of a table of the drive beside its numbers.
struct TableFacts {
    std::vector<std::string> notes; ///< of its file; a format that has notes gets them
    bool isComputed = false; ///< as in ConversionRequest
};

/// choices: of the new file, its format is one that can be written; where the drive looks the table
/// up overrules the notes. fileName: without folder, for texts that name their own file. Takes
/// long; to be called off the window's thread. Errors: those of convertTables.
[[nodiscard]] Result<TableExport> exportTable(const CompensationTable& table,
    const ImportChoices& choices, const std::string& fileName, const TableLayout& layout,
    const TableFacts& facts = {});

} // namespace axiscomp
