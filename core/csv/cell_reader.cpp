// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/cell_reader.h"

#include "core/text/thousands_point.h"

#include <algorithm>

namespace axiscomp::csv {

void CellReader::begin(char separator, std::size_t columns, std::size_t headerLine)
{
    m_format.separator = separator;
    m_format.decimal = separator == ';' ? '\0' : '.';
    m_columns = columns;
    m_cells.resize(columns);
    m_numbers.resize(columns);
    m_headerLine = headerLine;
}

void CellReader::setNoValueHint(std::size_t firstColumn, const TextPattern& hint)
{
    m_hintColumn = firstColumn;
    m_hint = hint;
}

bool CellReader::take(std::string_view line, std::size_t lineNumber)
{
    m_line = lineNumber;
    const std::size_t count = split(line);
    if (!checkQuotes(std::min(count, m_columns)))
        return false;
    if (count == m_columns)
        return true;
    reportColumnCount(line, count);
    return false;
}

/// As splitCells, but a number is read where its cell would be looked through for its end.
std::size_t CellReader::split(std::string_view line)
{
    std::size_t count = 0;
    for (bool more = true; more; ++count) {
        Cell cell;
        Number number;
        const bool isNumber = takeShortNumber(line, m_format, m_textEnd, cell, number, more);
        if (!isNumber)
            cell = takeCell(line, m_format.separator, more);
        if (count < m_columns) {
            m_cells[count] = cell;
            m_numbers[count] = isNumber ? std::optional(number) : std::nullopt;
        }
    }
    return count;
}

bool CellReader::checkQuotes(std::size_t cells)
{
    for (std::size_t i = 0; i < cells; ++i) {
        if (m_cells[i].quoting != Quoting::NotClosed && m_cells[i].quoting != Quoting::TextBehind)
            continue;
        m_diagnostics.error(DiagnosticCode::UnterminatedQuote, m_line, i + 1,
            Verbatim{excerpt(m_cells[i].text, m_encoding)},
            m_cells[i].quoting == Quoting::NotClosed
                ? AXISCOMP_TEXT("Error", "a closing \" in the same line")
                : AXISCOMP_TEXT(
                    "Error", "a separator or the end of the line after the closing \""));
        return false;
    }
    return true;
}

void CellReader::reportColumnCount(std::string_view line, std::size_t count)
{
    const std::size_t due = m_columns;
    const char other = m_format.separator == ',' ? ';' : ',';
    const std::string separator(1, m_format.separator);
    Text expected = AXISCOMP_TEXT("Error", "{count} as in the header (line {line})")
                        .with("count", due)
                        .with("line", m_headerLine);
    if (m_format.separator == ',' && count > due)
        expected = AXISCOMP_TEXT("Error",
            "{expected}; if the commas are decimal commas, separate the columns with ; in every "
            "line")
                       .with("expected", expected);
    else if (count < due && line.find(other) != std::string_view::npos)
        expected = AXISCOMP_TEXT("Error",
            "{expected}; the header separates its columns with {separator}, so every line must")
                       .with("expected", expected)
                       .with("separator", separator);
    else if (count < due && line.find('\t') != std::string_view::npos)
        expected = AXISCOMP_TEXT(
            "Error", "{expected}; separate the columns with {separator} instead of tabs")
                       .with("expected", expected)
                       .with("separator", separator);
    m_diagnostics.error(DiagnosticCode::ColumnCount, m_line, 0,
        AXISCOMP_COUNTED("Error", "{count} columns", "1 column").with("count", count),
        std::move(expected));
}

bool CellReader::checkThousands(std::string_view lines, std::size_t firstLine)
{
    if (m_format.separator == ',')
        return true;
    const auto doubt = thousandsDoubt(lines, firstLine, m_format.separator);
    if (!doubt)
        return true;
    m_diagnostics.error(DiagnosticCode::MixedDecimals, doubt->line, doubt->column,
        AXISCOMP_TEXT("Error", "{number} in a column with {whole}")
            .with("number", Verbatim{std::string(doubt->number)})
            .with("whole", Verbatim{std::string(doubt->whole)}),
        AXISCOMP_TEXT("Error",
            "numbers that show whether the point stands between thousands: no point in {number}, "
            "or the same decimals in {whole}")
            .with("number", Verbatim{std::string(doubt->number)})
            .with("whole", Verbatim{std::string(doubt->whole)}));
    return false;
}

bool CellReader::readNumber(std::size_t column, Number& number)
{
    if (const std::optional<Number>& known = m_numbers[column - 1]) {
        number = *known;
        return true;
    }
    if (!decideDecimal(column))
        return false;
    const NumberFault fault = parseNumber(text(column), m_format.decimal, number);
    reportFault(fault, column);
    return fault == NumberFault::None;
}

bool CellReader::decideDecimal(std::size_t column)
{
    const std::string_view cell = text(column);
    const bool comma = cell.find(',') != std::string_view::npos;
    const bool point = cell.find('.') != std::string_view::npos;
    if (m_format.separator == ',' || (!comma && !point)
        || cell.find_first_not_of("0123456789+-.,eE") != std::string_view::npos)
        return true;
    const char sign = comma ? ',' : '.';
    if (m_format.decimal == '\0') {
        m_format.decimal = sign;
        m_decimalLine = m_line;
    }
    if (sign == m_format.decimal && !(comma && point))
        return true;
    const TextPattern expected = comma && point
        ? AXISCOMP_TEXT("Error", "no sign between the thousands")
        : m_format.decimal == ',' ? AXISCOMP_TEXT("Error", "a decimal comma as in line {line}")
                                  : AXISCOMP_TEXT("Error", "a decimal point as in line {line}");
    m_diagnostics.error(DiagnosticCode::MixedDecimals, m_line, column,
        Verbatim{excerpt(cell, m_encoding)}, expected.with("line", m_decimalLine));
    return false;
}

void CellReader::reportFault(NumberFault fault, std::size_t column)
{
    if (fault == NumberFault::None)
        return;
    const std::string_view cell = m_cells[column - 1].text;
    const std::string example = m_format.decimal == ',' ? "0,5" : "0.5";
    Text expected = AXISCOMP_TEXT("Error", "a number such as {example}").with("example", example);
    if (fault == NumberFault::NotFinite)
        expected =
            AXISCOMP_TEXT("Error", "a finite number such as {example}").with("example", example);
    else if (fault == NumberFault::TooSmall)
        expected = AXISCOMP_TEXT("Error", "0 or a number that is not as close to it");
    else if (m_format.separator == ',' && cell.find(',') != std::string_view::npos)
        expected =
            AXISCOMP_TEXT("Error", "{expected}; decimal commas need the separator ; in every line")
                .with("expected", expected);
    if (m_hintColumn != 0 && column >= m_hintColumn && hasNoValue(column))
        expected = m_hint.with("expected", expected);
    m_diagnostics.error(
        fault == NumberFault::NotFinite ? DiagnosticCode::NotFinite : DiagnosticCode::NotANumber,
        m_line, column, Verbatim{excerpt(cell, m_encoding)}, std::move(expected));
}

} // namespace axiscomp::csv
