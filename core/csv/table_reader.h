// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/scan.h"
#include "core/table/compensation_table.h"

#include <cstdint>
#include <vector>

namespace axiscomp::csv {

/// Puts the values in their places and looks at the tables. points: as from readPoints.
[[nodiscard]] std::vector<CompensationTable> readTables(const Scan& scan, const Grid& grid,
    const std::vector<std::uint32_t>& points, DiagnosticList& diagnostics);

} // namespace axiscomp::csv
