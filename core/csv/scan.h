// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/calibration_csv.h"
#include "core/csv/cells.h"
#include "core/csv/columns.h"
#include "core/csv/grid_lines.h"
#include "core/text/text_file.h"

#include <vector>

namespace axiscomp::csv {

/// A column's header: "X [mm]".
struct ColumnName {
    std::string name;
    std::string unit;
};

/// A file's content before it is looked at as a grid.
struct Scan {
    int dimensions = 1;
    std::size_t headerLine = 0;
    std::vector<ColumnName> columns; ///< dimensions, then tables
    std::vector<std::string> notes;
    std::vector<Piece> pieces; ///< in the order of the file
    std::vector<ValueRange> ranges; ///< per table, of all pieces
    std::size_t rows = 0; ///< of all pieces
    RowLines rowLines;
    bool complete = false; ///< every data line is among the rows
    bool cancelled = false;

    [[nodiscard]] std::size_t tables() const
    {
        return columns.size() - static_cast<std::size_t>(dimensions);
    }
    /// The positions of a dimension in all pieces, by their id: the id in a piece, and its firstId.
    [[nodiscard]] std::vector<SortedPositions::Place> positionsOf(std::size_t dimension) const;
    /// The first row with the position of this id.
    [[nodiscard]] std::size_t rowOf(std::size_t dimension, std::size_t id) const;
    /// The finest decimal that is printed in a dimension.
    [[nodiscard]] int lastDecimalOf(std::size_t dimension) const;
};

/// Reads all lines. Problems go to diagnostics.
[[nodiscard]] Scan scan(
    const TextInspection& text, const CsvOptions& options, DiagnosticList& diagnostics);

} // namespace axiscomp::csv
