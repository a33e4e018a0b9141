// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/scan.h"

#include "core/csv/fast_rows.h"
#include "core/csv/header.h"
#include "core/table/target_axis.h"
#include "core/text/line_reader.h"

#include <cmath>
#include <limits>

namespace axiscomp::csv {

namespace {

class Scanner {
public:
    Scanner(const TextInspection& text, const CsvOptions& options, DiagnosticList& diagnostics)
        : m_options(options)
        , m_diagnostics(diagnostics)
        , m_encoding(text.encoding())
        , m_text(text.body())
        , m_lines(m_text)
    {
        m_scan.dimensions = options.dimensions;
    }

    Scan run();

private:
    void readLine();
    void keepNote(std::string_view comment, std::size_t lineNumber);
    void reportDroppedNotes();
    bool useHeader(std::string_view line, std::size_t lineNumber);
    void readPlainRowsUntil(const char* until);
    void readDataLine(std::string_view line, std::size_t lineNumber);
    bool checkCells(std::string_view line, std::size_t lineNumber, std::size_t count);
    void reportColumnCount(std::string_view line, std::size_t lineNumber, std::size_t count);
    bool readPositions(std::size_t lineNumber, RowStore::Block& block);
    void readValues(std::size_t lineNumber, RowStore::Block& block);
    bool readNumber(std::size_t lineNumber, std::size_t column, Number& number);
    bool decideDecimal(std::string_view cell, std::size_t lineNumber, std::size_t column);
    [[nodiscard]] bool isMissing(std::size_t column) const
    {
        return column > m_scan.positions.size() && isNoValue(m_cells[column - 1].text);
    }
    void reportFault(NumberFault fault, std::size_t lineNumber, std::size_t column);
    [[nodiscard]] std::size_t maximumRows() const
    {
        return m_options.maximumCells / m_scan.columns.size();
    }

    const CsvOptions& m_options;
    DiagnosticList& m_diagnostics;
    Encoding m_encoding;
    std::string_view m_text;
    LineReader m_lines;
    CellFormat m_format;
    std::size_t m_decimalLine = 0; ///< where the first decimal sign stands
    bool m_stop = false;
    std::vector<Cell> m_cells;
    std::size_t m_noteBytes = 0;
    std::size_t m_droppedNotes = 0;
    std::size_t m_firstDroppedLine = 0;
    Scan m_scan;
};

Scan Scanner::run()
{
    constexpr std::size_t steps = 256;
    const std::size_t step = std::max<std::size_t>(m_text.size() / steps, std::size_t{1} << 16U);
    const char* const begin = m_text.data();
    m_scan.complete = true;
    while (!m_lines.atEnd() && !m_stop) {
        if (m_options.stop.stop_requested()) {
            m_scan.cancelled = true;
            return std::move(m_scan);
        }
        if (m_options.progress)
            m_options.progress(static_cast<double>(m_lines.position() - begin)
                / static_cast<double>(m_text.size()));
        const auto left = static_cast<std::size_t>(m_lines.end() - m_lines.position());
        const char* const until = m_lines.position() + std::min(step, left);
        while (m_lines.position() < until && !m_stop) {
            if (m_scan.headerLine != 0)
                readPlainRowsUntil(until);
            if (m_lines.position() < until)
                readLine();
        }
    }
    reportDroppedNotes();
    return std::move(m_scan);
}

void Scanner::readLine()
{
    const std::size_t lineNumber = m_lines.lineNumber();
    const std::string_view line = m_lines.next();
    const std::string_view content = trimmed(line);
    if (content.starts_with("//"))
        keepNote(trimmed(content.substr(2)), lineNumber);
    else if (content.empty())
        return;
    else if (m_scan.headerLine == 0)
        m_stop = !useHeader(line, lineNumber);
    else
        readDataLine(line, lineNumber);
}

/// A file may have more comments than data; the target, which changes numbers, is never among those
/// that are left out.
void Scanner::keepNote(std::string_view comment, std::size_t lineNumber)
{
    constexpr std::size_t maximumNoteBytes = std::size_t{1} << 20U;
    if (m_noteBytes + comment.size() <= maximumNoteBytes || targetInComment(comment)) {
        m_noteBytes += comment.size();
        m_scan.notes.push_back(toUtf8(comment, m_encoding));
    } else if (m_droppedNotes++ == 0) {
        m_firstDroppedLine = lineNumber;
    }
}

void Scanner::reportDroppedNotes()
{
    if (m_droppedNotes > 0)
        m_diagnostics.warning(DiagnosticCode::DroppedComments, m_firstDroppedLine, 0,
            AXISCOMP_COUNTED("Error", "{count} more comment lines", "1 more comment line")
                .with("count", m_droppedNotes),
            AXISCOMP_TEXT("Error", "at most 1 MiB of comments"));
}

bool Scanner::useHeader(std::string_view line, std::size_t lineNumber)
{
    m_scan.headerLine = lineNumber;
    std::optional<Header> header =
        readHeader(line, lineNumber, m_scan.dimensions, m_encoding, m_diagnostics);
    if (!header)
        return false;
    m_format.separator = header->separator;
    m_format.decimal = header->separator == ';' ? '\0' : '.';
    m_scan.columns = std::move(header->columns);
    m_scan.ranges.resize(m_scan.tables());
    const auto dimensions = static_cast<std::size_t>(m_scan.dimensions);
    m_scan.positions.assign(dimensions, PositionColumn(m_text));
    m_scan.rows = RowStore(dimensions == 1 ? 0 : dimensions, m_scan.tables());
    return true;
}

void Scanner::readPlainRowsUntil(const char* until)
{
    const std::size_t row = m_scan.rows.size();
    const char* const position =
        readPlainRows(m_scan, m_format, m_lines.position(), until, m_lines.end(), maximumRows());
    const std::size_t rows = m_scan.rows.size() - row;
    if (rows == 0)
        return;
    m_scan.rowLines.add(row, m_lines.lineNumber());
    m_lines.skipTo(position, rows);
}

void Scanner::readDataLine(std::string_view line, std::size_t lineNumber)
{
    if (m_scan.rows.size() >= maximumRows()) {
        m_diagnostics.error(DiagnosticCode::TooLarge, lineNumber, 0,
            AXISCOMP_TEXT("Error", "more than {rows} data lines of {columns} columns")
                .with("rows", maximumRows())
                .with("columns", m_scan.columns.size()),
            AXISCOMP_TEXT("Error", "at most {cells} cells (lines x columns)")
                .with("cells", m_options.maximumCells));
        m_stop = true;
        m_scan.complete = false;
        return;
    }
    const std::size_t count = splitCells(line, m_format.separator, m_scan.columns.size(), m_cells);
    RowStore::Block& block = m_scan.rows.open();
    const bool wellFormed = checkCells(line, lineNumber, count);
    const bool placed = wellFormed && readPositions(lineNumber, block);
    if (wellFormed)
        readValues(lineNumber, block);
    if (!placed) {
        m_scan.complete = false;
        return;
    }
    m_scan.rowLines.add(m_scan.rows.size(), lineNumber);
    ++block.rows;
}

bool Scanner::checkCells(std::string_view line, std::size_t lineNumber, std::size_t count)
{
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        if (m_cells[i].quoting != Quoting::NotClosed && m_cells[i].quoting != Quoting::TextBehind)
            continue;
        m_diagnostics.error(DiagnosticCode::UnterminatedQuote, lineNumber, i + 1,
            Verbatim{excerpt(m_cells[i].text, m_encoding)},
            m_cells[i].quoting == Quoting::NotClosed
                ? AXISCOMP_TEXT("Error", "a closing \" in the same line")
                : AXISCOMP_TEXT(
                    "Error", "a separator or the end of the line after the closing \""));
        return false;
    }
    if (count == m_scan.columns.size())
        return true;
    reportColumnCount(line, lineNumber, count);
    return false;
}

void Scanner::reportColumnCount(std::string_view line, std::size_t lineNumber, std::size_t count)
{
    const std::size_t due = m_scan.columns.size();
    const char other = m_format.separator == ',' ? ';' : ',';
    const std::string separator(1, m_format.separator);
    Text expected = AXISCOMP_TEXT("Error", "{count} as in the header (line {line})")
                        .with("count", due)
                        .with("line", m_scan.headerLine);
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
    m_diagnostics.error(DiagnosticCode::ColumnCount, lineNumber, 0,
        AXISCOMP_COUNTED("Error", "{count} columns", "1 column").with("count", count),
        std::move(expected));
}

bool Scanner::readPositions(std::size_t lineNumber, RowStore::Block& block)
{
    bool good = true;
    if (m_scan.dimensions == 1) {
        Number position;
        good = readNumber(lineNumber, 1, position);
        if (good)
            m_scan.positions[0].append(position);
        return good;
    }
    for (std::size_t d = 0; d < m_scan.positions.size(); ++d) {
        const std::string_view cell = trimmed(m_cells[d].text);
        NumberFault fault = NumberFault::None;
        std::optional<std::uint32_t> id;
        if (decideDecimal(cell, lineNumber, d + 1)) {
            id = m_scan.positions[d].intern(cell, m_format.decimal, fault);
            reportFault(fault, lineNumber, d + 1);
        }
        good = good && id;
        block.ids[d * m_scan.rows.blockRows() + block.rows] = id.value_or(0);
    }
    return good;
}

void Scanner::readValues(std::size_t lineNumber, RowStore::Block& block)
{
    const std::size_t positions = m_scan.positions.size();
    for (std::size_t table = 0; table < m_scan.tables(); ++table) {
        Number number;
        float stored = 0.0F;
        if (isMissing(positions + table + 1) && m_options.missing != MissingPoints::Refuse) {
            stored = std::numeric_limits<float>::quiet_NaN();
        } else if (readNumber(lineNumber, positions + table + 1, number)) {
            stored = static_cast<float>(number.value);
            if (!std::isfinite(stored))
                m_diagnostics.error(DiagnosticCode::NotFinite, lineNumber, positions + table + 1,
                    Verbatim{excerpt(m_cells[positions + table].text, m_encoding)},
                    AXISCOMP_TEXT("Error", "a value that fits float32 (below 3.4e38)"));
            m_scan.ranges[table].add(number.value, stored, m_scan.rows.size());
        }
        block.values[table * m_scan.rows.blockRows() + block.rows] = stored;
    }
}

bool Scanner::readNumber(std::size_t lineNumber, std::size_t column, Number& number)
{
    const std::string_view cell = trimmed(m_cells[column - 1].text);
    if (!decideDecimal(cell, lineNumber, column))
        return false;
    const NumberFault fault = parseNumber(cell, m_format.decimal, number);
    reportFault(fault, lineNumber, column);
    return fault == NumberFault::None;
}

bool Scanner::decideDecimal(std::string_view cell, std::size_t lineNumber, std::size_t column)
{
    const bool comma = cell.find(',') != std::string_view::npos;
    const bool point = cell.find('.') != std::string_view::npos;
    if (m_format.separator == ',' || (!comma && !point)
        || cell.find_first_not_of("0123456789+-.,eE") != std::string_view::npos)
        return true;
    const char sign = comma ? ',' : '.';
    if (m_format.decimal == '\0') {
        m_format.decimal = sign;
        m_decimalLine = lineNumber;
    }
    if (sign == m_format.decimal && !(comma && point))
        return true;
    const TextPattern expected = comma && point
        ? AXISCOMP_TEXT("Error", "no sign between the thousands")
        : m_format.decimal == ',' ? AXISCOMP_TEXT("Error", "a decimal comma as in line {line}")
                                  : AXISCOMP_TEXT("Error", "a decimal point as in line {line}");
    m_diagnostics.error(DiagnosticCode::MixedDecimals, lineNumber, column,
        Verbatim{excerpt(cell, m_encoding)}, expected.with("line", m_decimalLine));
    return false;
}

void Scanner::reportFault(NumberFault fault, std::size_t lineNumber, std::size_t column)
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
    if (isMissing(column))
        expected = AXISCOMP_TEXT("Error",
            "{expected}; points without a value can be filled or left out (--fill, --crop, or "
            "Missing points in the import)")
                       .with("expected", expected);
    m_diagnostics.error(
        fault == NumberFault::NotFinite ? DiagnosticCode::NotFinite : DiagnosticCode::NotANumber,
        lineNumber, column, Verbatim{excerpt(cell, m_encoding)}, std::move(expected));
}

} // namespace

Scan scan(const TextInspection& text, const CsvOptions& options, DiagnosticList& diagnostics)
{
    return Scanner(text, options, diagnostics).run();
}

} // namespace axiscomp::csv
