// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/input/table_input.h"
#include "core/metrology/fit/known_tables.h"

namespace axiscomp::app {

/// The tables of a file in the unit of the measurement, mm or deg. Notes say what is assumed of
/// units. Errors: those of reading the file, UnitMismatch.
[[nodiscard]] Result<KnownTables> tablesOfFile(
    Environment& environment, const TableInputOptions& options, const std::string& unit);

/// "note: ..." for each on standard error.
void noteRemarks(Environment& environment, const std::vector<Text>& remarks);

} // namespace axiscomp::app
