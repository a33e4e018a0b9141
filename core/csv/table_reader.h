// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/grid_reader.h"
#include "core/table/compensation_table.h"

#include <cstdint>
#include <vector>

namespace axiscomp::csv {

/// Puts the values in their places, makes up those that are missing or cuts the grid to those that
/// are not, and looks at the tables. points: as from readPoints. None after an error.
[[nodiscard]] std::vector<CompensationTable> readTables(const Scan& scan, GridReading& reading,
    const std::vector<std::uint32_t>& points, MissingPoints missing, DiagnosticList& diagnostics);

} // namespace axiscomp::csv
