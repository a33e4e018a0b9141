// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/grid_reader.h"
#include "core/table/compensation_table.h"

#include <vector>

namespace axiscomp::csv {

/// Puts the values in their places, makes up those that are missing or cuts the grid to those that
/// are not, and looks at the tables. None after an error, also of the grid.
[[nodiscard]] std::vector<CompensationTable> readTables(const Scan& scan, GridReading& reading,
    const Places& places, const CsvOptions& options, DiagnosticList& diagnostics);

} // namespace axiscomp::csv
