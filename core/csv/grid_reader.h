// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/places.h"

namespace axiscomp::csv {

/// The rows as a grid.
struct GridReading {
    Grid grid;
    std::vector<GridLines> lines; ///< per dimension
    std::vector<std::vector<double>>
        knots; ///< per dimension: those of the grid, or the uneven ones
    bool even = false; ///< every dimension has enough lines and is evenly spaced, or need not be

    /// May be beyond any integer in a file that is no grid.
    [[nodiscard]] double pointCount() const;
};

/// "X", or "position 1"
[[nodiscard]] Text columnText(const ColumnName& column, std::size_t dimension);

/// "X = 2.5 mm"
[[nodiscard]] Text positionText(const ColumnName& column, std::size_t dimension, double position);

/// Finds the grid lines and their spacing. Not for an empty scan. Problems go to diagnostics.
[[nodiscard]] GridReading readGrid(
    const Scan& scan, const CsvOptions& options, DiagnosticList& diagnostics);

/// Checks that every grid point occurs once, or at most once where points may be missing; otherwise
/// diagnostics say which do not.
void checkPoints(const Scan& scan, const GridReading& grid, const Places& places,
    const CsvOptions& options, DiagnosticList& diagnostics);

} // namespace axiscomp::csv
