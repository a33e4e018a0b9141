// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/scan.h"

#include "core/csv/cell_reader.h"
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
        , m_cells(m_encoding, diagnostics, m_lines.end())
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
    bool readPositions(RowStore::Block& block);
    void readValues(std::size_t lineNumber, RowStore::Block& block);
    [[nodiscard]] std::size_t maximumRows() const
    {
        return m_options.maximumCells / m_scan.columns.size();
    }

    const CsvOptions& m_options;
    DiagnosticList& m_diagnostics;
    Encoding m_encoding;
    std::string_view m_text;
    LineReader m_lines;
    CellReader m_cells;
    bool m_stop = false;
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
    m_cells.begin(header->separator, header->columns.size(), lineNumber);
    m_scan.columns = std::move(header->columns);
    m_scan.ranges.resize(m_scan.tables());
    const auto dimensions = static_cast<std::size_t>(m_scan.dimensions);
    m_cells.setNoValueHint(dimensions + 1,
        AXISCOMP_TEXT("Error",
            "{expected}; points without a value can be filled or left out (--fill, --crop, or "
            "Missing points in the import)"));
    m_scan.positions.assign(dimensions, PositionColumn(m_text));
    m_scan.rows = RowStore(dimensions == 1 ? 0 : dimensions, m_scan.tables());
    return true;
}

void Scanner::readPlainRowsUntil(const char* until)
{
    const std::size_t row = m_scan.rows.size();
    const char* const position = readPlainRows(
        m_scan, m_cells.format(), m_lines.position(), until, m_lines.end(), maximumRows());
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
    RowStore::Block& block = m_scan.rows.open();
    const bool wellFormed = m_cells.take(line, lineNumber);
    const bool placed = wellFormed && readPositions(block);
    if (wellFormed)
        readValues(lineNumber, block);
    if (!placed) {
        m_scan.complete = false;
        return;
    }
    m_scan.rowLines.add(m_scan.rows.size(), lineNumber);
    ++block.rows;
}

bool Scanner::readPositions(RowStore::Block& block)
{
    bool good = true;
    if (m_scan.dimensions == 1) {
        Number position;
        good = m_cells.readNumber(1, position);
        if (good)
            m_scan.positions[0].append(position);
        return good;
    }
    for (std::size_t d = 0; d < m_scan.positions.size(); ++d) {
        NumberFault fault = NumberFault::None;
        std::optional<std::uint32_t> id;
        if (m_cells.decideDecimal(d + 1)) {
            id = m_scan.positions[d].intern(m_cells.text(d + 1), m_cells.format().decimal, fault);
            m_cells.reportFault(fault, d + 1);
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
        if (m_options.missing != MissingPoints::Refuse
            && m_cells.hasNoValue(positions + table + 1)) {
            stored = std::numeric_limits<float>::quiet_NaN();
        } else if (m_cells.readNumber(positions + table + 1, number)) {
            stored = static_cast<float>(number.value);
            if (!std::isfinite(stored))
                m_diagnostics.error(DiagnosticCode::NotFinite, lineNumber, positions + table + 1,
                    Verbatim{excerpt(m_cells.cell(positions + table + 1).text, m_encoding)},
                    AXISCOMP_TEXT("Error", "a value that fits float32 (below 3.4e38)"));
            m_scan.ranges[table].add(number.value, stored, m_scan.rows.size());
        }
        block.values[table * m_scan.rows.blockRows() + block.rows] = stored;
    }
}

} // namespace

Scan scan(const TextInspection& text, const CsvOptions& options, DiagnosticList& diagnostics)
{
    return Scanner(text, options, diagnostics).run();
}

} // namespace axiscomp::csv
