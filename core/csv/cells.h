// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/number_parser.h"
#include "core/text/text_file.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace axiscomp::csv {

/// Which line each data row stands in. Rows follow each other without a gap mostly.
class RowLines {
public:
    void add(std::size_t row, std::size_t line);
    [[nodiscard]] std::size_t lineOf(std::size_t row) const;

private:
    struct Run {
        std::uint32_t row;
        std::uint32_t line;
    };
    std::vector<Run> m_runs;
};

struct CellFormat {
    char separator = ',';
    char decimal = '\0'; ///< '\0' while no number of the file has decimals
};

enum class Quoting {
    None,
    Quoted,
    NotClosed,
    TextBehind, ///< something other than a separator follows the closing quote
};

struct Cell {
    std::string_view text; ///< without blanks round it and without its quotes
    Quoting quoting = Quoting::None;
};

/// Takes one cell off the line; more is false when it was the last.
[[nodiscard]] Cell takeCell(std::string_view& line, char separator, bool& more);

/// The same for a cell that is a number as most are: digits with or without decimals. textEnd: of
/// the text that the line is part of. False: nothing was taken, and it needs takeCell to tell what
/// the cell is.
[[nodiscard]] bool takeShortNumber(std::string_view& line, const CellFormat& format,
    const char* textEnd, Cell& cell, Number& number, bool& more);

/// Splits a line. Returns the number of its cells; the first `maximum` are put into cells.
std::size_t splitCells(
    std::string_view line, char separator, std::size_t maximum, std::vector<Cell>& cells);

/// As programs write a point that was not measured: nothing, nan, #N/A.
[[nodiscard]] bool isNoValue(std::string_view cell);

/// A cell as it may be shown: UTF-8, doubled quotes made single, no byte-order mark.
[[nodiscard]] std::string cellText(const Cell& cell, Encoding encoding);

} // namespace axiscomp::csv
