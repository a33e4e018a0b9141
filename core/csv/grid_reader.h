// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/scan.h"

namespace axiscomp::csv {

/// The distinct positions of one dimension.
struct GridLines {
    std::vector<double> positions; ///< increasing; closer ones are merged
    std::vector<double> reach; ///< by which the merged ones lie to both sides of it
    std::vector<std::uint32_t> lineOf; ///< by the id of a position
};

/// The rows as a grid.
struct GridReading {
    Grid grid;
    std::vector<GridLines> lines; ///< per dimension
    std::vector<std::vector<double>>
        knots; ///< per dimension: those of the grid, or the uneven ones
    bool even = false; ///< every dimension has enough lines and is evenly spaced, or need not be
};

/// Calls visit(block, index in the block, row) for every row until it returns false.
template <typename Visit> void forEachRow(const Scan& scan, Visit&& visit)
{
    std::size_t row = 0;
    for (const RowStore::Block& block : scan.rows.blocks())
        for (std::size_t i = 0; i < block.rows; ++i, ++row)
            if (!visit(block, i, row))
                return;
}

/// "X", or "position 1"
[[nodiscard]] Text columnText(const ColumnName& column, std::size_t dimension);

/// "X = 2.5 mm"
[[nodiscard]] Text positionText(const ColumnName& column, std::size_t dimension, double position);

/// Finds the grid lines and their spacing. Not for an empty scan. Problems go to diagnostics.
[[nodiscard]] GridReading readGrid(
    const Scan& scan, const CsvOptions& options, DiagnosticList& diagnostics);

/// Checks that every grid point occurs once, or at most once where points may be missing. Returns
/// the place of each row in the tables (dimension 1 fastest), empty if that is not so.
[[nodiscard]] std::vector<std::uint32_t> readPoints(const Scan& scan, const GridReading& grid,
    const CsvOptions& options, DiagnosticList& diagnostics);

} // namespace axiscomp::csv
