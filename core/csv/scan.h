// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/calibration_csv.h"
#include "core/csv/cells.h"
#include "core/csv/columns.h"
#include "core/text/text_file.h"

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
    std::vector<PositionColumn> positions;
    RowStore rows;
    RowLines rowLines;
    std::vector<ValueRange> ranges; ///< per table
    bool complete = false; ///< every data line is among the rows
    bool cancelled = false;

    [[nodiscard]] std::size_t tables() const
    {
        return columns.size() - static_cast<std::size_t>(dimensions);
    }
    /// The id of a position; i: the row's index in its block.
    [[nodiscard]] std::size_t id(
        const RowStore::Block& block, std::size_t i, std::size_t row, std::size_t dimension) const
    {
        return dimensions == 1 ? row : block.ids[dimension * rows.blockRows() + i];
    }
};

/// Reads all lines. Problems go to diagnostics.
[[nodiscard]] Scan scan(
    const TextInspection& text, const CsvOptions& options, DiagnosticList& diagnostics);

} // namespace axiscomp::csv
