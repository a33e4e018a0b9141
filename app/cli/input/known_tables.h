// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/input/table_input.h"
#include "core/metrology/fit/known_tables.h"

namespace axiscomp::app {

/// The tables of a file in the unit of the measurement, mm or deg. Notes say what is assumed of
/// units. lookupAt: where the drive looks them up, as far as that is stated. Errors: those of
/// reading the file and of the other tablesOfFile.
[[nodiscard]] Result<KnownTables> tablesOfFile(Environment& environment,
    const TableInputOptions& options, const std::string& unit, std::optional<LookupAt> lookupAt);

/// "note: ..." for each on standard error.
void noteRemarks(Environment& environment, const std::vector<Text>& remarks);

} // namespace axiscomp::app
