// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/cells.h"
#include "core/csv/fast_rows.h"
#include "core/text/number_parser.h"

#include <optional>

namespace axiscomp::csv {

/// The cells of one data line after the other, and what is wrong with them. Columns count from 1.
class CellReader {
public:
    /// textEnd: of the text that the lines are part of.
    CellReader(Encoding encoding, DiagnosticList& diagnostics, const char* textEnd)
        : m_encoding(encoding)
        , m_diagnostics(diagnostics)
        , m_textEnd(textEnd)
    {
    }

    /// After the header: how it separates its columns, how many it has, and where it stands.
    void begin(char separator, std::size_t columns, std::size_t headerLine);
    /// Before the first line. False: points may stand between thousands (thousands_point.h), which
    /// is reported. With commas between columns nobody prints such.
    bool checkThousands(std::string_view lines, std::size_t firstLine);
    /// What is added to "expected" when a cell of this column or a later one has no value; has
    /// {expected}.
    void setNoValueHint(std::size_t firstColumn, const TextPattern& hint);

    /// Takes the cells of a line. False: it has not as many as the header, or is not quoted as it
    /// should be, which is reported.
    bool take(std::string_view line, std::size_t lineNumber);

    [[nodiscard]] const CellFormat& format() const { return m_format; }
    [[nodiscard]] std::string_view text(std::size_t column) const
    {
        const Cell& cell = m_cells[column - 1];
        return cell.quoting == Quoting::None ? cell.text : trimmed(cell.text);
    }
    [[nodiscard]] const Cell& cell(std::size_t column) const { return m_cells[column - 1]; }
    [[nodiscard]] bool hasNoValue(std::size_t column) const
    {
        return isNoValue(m_cells[column - 1].text);
    }

    /// False: the cell is no number, which is reported.
    bool readNumber(std::size_t column, Number& number);
    /// Learns from a number which decimal sign the file has. False: it has another one than the
    /// lines before, which is reported.
    bool decideDecimal(std::size_t column);
    /// Nothing for NumberFault::None.
    void reportFault(NumberFault fault, std::size_t column);

private:
    std::size_t split(std::string_view line);
    bool checkQuotes(std::size_t cells);
    void reportColumnCount(std::string_view line, std::size_t count);

    Encoding m_encoding;
    DiagnosticList& m_diagnostics;
    const char* m_textEnd;
    CellFormat m_format;
    std::size_t m_columns = 0;
    std::size_t m_headerLine = 0;
    std::size_t m_decimalLine = 0; ///< where the first decimal sign stands
    std::size_t m_line = 0;
    std::vector<Cell> m_cells; ///< one for each column
    std::vector<std::optional<Number>> m_numbers; ///< of the cells that turned out to be short ones
    std::size_t m_hintColumn = 0;
    TextPattern m_hint;
};

} // namespace axiscomp::csv
