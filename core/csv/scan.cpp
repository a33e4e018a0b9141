// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/scan.h"

#include "core/base/parallel.h"
#include "core/csv/cell_reader.h"
#include "core/csv/header.h"
#include "core/csv/scattered.h"
#include "core/neutral/drive_note.h"
#include "core/neutral/lookup_note.h"
#include "core/neutral/sign_note.h"
#include "core/table/target_axis.h"
#include "core/text/line_reader.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace axiscomp::csv {

namespace {

/// Ids have 16 bits; a line of two positions and a value, which may be an empty cell, has at least
/// five characters.
constexpr std::size_t mostPieceBytes = std::size_t{1} << 18U;
/// After which it is asked whether what is read can be a grid.
constexpr std::size_t firstBytes = std::size_t{1} << 18U;
static_assert(mostPieceBytes / 5 + 1 < std::numeric_limits<std::uint16_t>::max());

/// A comment that changes numbers, or says to which drive they may go.
bool isStatement(std::string_view comment)
{
    return targetInComment(comment) || statedIn(comment, signKey) || statedIn(comment, lookupKey)
        || statedIn(comment, driveKey);
}

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
    bool goesOn();
    void readLine();
    void keepNote(std::string_view comment, std::size_t lineNumber);
    void reportDroppedNotes();
    bool useHeader(std::string_view line, std::size_t lineNumber);
    void readPieces();
    void readPiece(const char* plainUntil, const char* end);
    void takePlainRows(const char* position, std::size_t rows);
    [[nodiscard]] std::vector<const char*> pieceEnds() const;
    void refuseScattered();
    void readDataLine(std::string_view line, std::size_t lineNumber);
    void refuseMoreRows(std::size_t lineNumber);
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
    std::size_t m_nextReport = 0; ///< of the progress, in bytes
    std::array<std::size_t, 3> m_nextId{};
    Piece* m_piece = nullptr; ///< which is being read
    const char* m_firstEnd = nullptr; ///< of the first bytes; null: they have been looked at
    Scan m_scan;
};

Scan Scanner::run()
{
    m_scan.complete = true;
    while (!m_lines.atEnd() && !m_stop && goesOn()) {
        if (m_scan.headerLine == 0) {
            readLine();
        } else {
            readPieces();
            refuseScattered();
        }
    }
    reportDroppedNotes();
    return std::move(m_scan);
}

/// Says how far it is. False: the reading is to stop.
bool Scanner::goesOn()
{
    constexpr std::size_t steps = 256;
    if (m_options.stop.stop_requested()) {
        m_scan.cancelled = true;
        return false;
    }
    const auto done = static_cast<std::size_t>(m_lines.position() - m_text.data());
    if (m_options.progress && done >= m_nextReport) {
        m_options.progress(static_cast<double>(done) / static_cast<double>(m_text.size()));
        m_nextReport = done + std::max(m_text.size() / steps, std::size_t{1} << 16U);
    }
    return true;
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

/// A file may have more comments than data; no statement is among those that are left out.
void Scanner::keepNote(std::string_view comment, std::size_t lineNumber)
{
    constexpr std::size_t maximumNoteBytes = std::size_t{1} << 20U;
    if (m_noteBytes + comment.size() <= maximumNoteBytes || isStatement(comment)) {
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
    const std::string_view data(
        m_lines.position(), static_cast<std::size_t>(m_lines.end() - m_lines.position()));
    if (!m_cells.checkThousands(data, m_lines.lineNumber()))
        return false;
    m_scan.columns = std::move(header->columns);
    m_scan.ranges.resize(m_scan.tables());
    if (!data.empty() && m_scan.dimensions > 1)
        m_firstEnd = axiscomp::pieceEnds(data, firstBytes, 1).front();
    const auto dimensions = static_cast<std::size_t>(m_scan.dimensions);
    m_cells.setNoValueHint(dimensions + 1,
        AXISCOMP_TEXT("Error",
            "{expected}; points without a value can be filled or left out (--fill, --crop, or "
            "Missing points in the import)"));
    return true;
}

/// Where the next pieces end, each at the end of a line. While nobody knows which decimal sign the
/// file has, there is only one: it stops at the first number with a sign.
std::vector<const char*> Scanner::pieceEnds() const
{
    constexpr std::size_t mostPieces = 64;
    const std::size_t count = m_cells.format().decimal == '\0' ? 1 : mostPieces;
    const std::size_t bytes = std::clamp<std::size_t>(m_options.pieceBytes, 1, mostPieceBytes);
    const char* const end = m_firstEnd ? m_firstEnd : m_lines.end();
    return axiscomp::pieceEnds(
        {m_lines.position(), static_cast<std::size_t>(end - m_lines.position())}, bytes, count);
}

/// Once, when the first bytes have been read: a file of scattered positions is not read to its end.
void Scanner::refuseScattered()
{
    if (!m_firstEnd || m_lines.position() < m_firstEnd || m_stop || m_scan.cancelled)
        return;
    m_firstEnd = nullptr;
    if (!isScattered(m_scan, m_options.snap, maximumRows(), m_diagnostics))
        return;
    m_stop = true;
    m_scan.complete = false;
}

/// All threads read pieces as far as their lines are plain; the rest of each is read here, in the
/// order of the file.
void Scanner::readPieces()
{
    const std::vector<const char*> ends = pieceEnds();
    const std::size_t first = m_scan.pieces.size();
    std::vector<const char*> stops(ends.size(), m_lines.position());
    std::copy(ends.begin(), ends.end() - 1, stops.begin() + 1);
    for (std::size_t i = 0; i < ends.size(); ++i)
        m_scan.pieces.emplace_back(m_text, m_cells.format().separator,
            static_cast<std::size_t>(m_scan.dimensions), m_scan.tables());
    shareWork(ends.size(), m_options.threads, [&](std::size_t i) {
        if (m_options.stop.stop_requested())
            return;
        Piece& piece = m_scan.pieces[first + i];
        stops[i] =
            readPlainRows(piece, m_cells.format(), stops[i], ends[i], m_lines.end(), maximumRows());
        // What it knows of texts is larger than the piece where positions scatter.
        if (stops[i] == ends[i])
            std::ranges::for_each(piece.positions, &PositionColumn::close);
    });
    for (std::size_t i = 0; i < ends.size() && !m_stop && !m_scan.cancelled; ++i) {
        m_piece = &m_scan.pieces[first + i];
        readPiece(stops[i], ends[i]);
    }
}

/// plainUntil: up to where its lines have been read.
void Scanner::readPiece(const char* plainUntil, const char* end)
{
    m_piece->firstRow = m_scan.rows;
    m_piece->firstId = m_nextId;
    takePlainRows(plainUntil, m_piece->rows.size());
    while (m_lines.position() < end && !m_stop && goesOn()) {
        readLine();
        if (m_lines.position() >= end || m_stop)
            break;
        const std::size_t rows = m_piece->rows.size();
        const char* const position = readPlainRows(*m_piece, m_cells.format(), m_lines.position(),
            end, m_lines.end(), rows + maximumRows() - m_scan.rows);
        takePlainRows(position, m_piece->rows.size() - rows);
    }
    for (std::size_t d = 0; d < m_piece->positions.size(); ++d) {
        m_piece->positions[d].close();
        m_nextId[d] += m_piece->positions[d].values().size();
    }
    for (std::size_t table = 0; table < m_piece->ranges.size(); ++table)
        m_scan.ranges[table].add(m_piece->ranges[table], m_piece->firstRow);
    // Of a few wide lines they take more than the lines.
    m_piece->ranges = std::vector<ValueRange>();
    goesOn();
}

/// position: behind them.
void Scanner::takePlainRows(const char* position, std::size_t rows)
{
    const std::size_t room = maximumRows() - m_scan.rows;
    if (rows == 0)
        return;
    if (rows > room)
        return refuseMoreRows(m_lines.lineNumber() + room);
    m_scan.rowLines.add(m_scan.rows, m_lines.lineNumber());
    m_scan.rows += rows;
    m_lines.skipTo(position, rows);
}

void Scanner::refuseMoreRows(std::size_t lineNumber)
{
    m_diagnostics.error(DiagnosticCode::TooLarge, lineNumber, 0,
        AXISCOMP_TEXT("Error", "more than {rows} data lines of {columns} columns")
            .with("rows", maximumRows())
            .with("columns", m_scan.columns.size()),
        AXISCOMP_TEXT("Error", "at most {cells} cells (lines x columns)")
            .with("cells", m_options.maximumCells));
    m_stop = true;
    m_scan.complete = false;
}

void Scanner::readDataLine(std::string_view line, std::size_t lineNumber)
{
    if (m_scan.rows >= maximumRows())
        return refuseMoreRows(lineNumber);
    RowStore::Block& block = m_piece->rows.open();
    const bool wellFormed = m_cells.take(line, lineNumber);
    const bool placed = wellFormed && readPositions(block);
    if (wellFormed)
        readValues(lineNumber, block);
    if (!placed) {
        m_scan.complete = false;
        return;
    }
    m_scan.rowLines.add(m_scan.rows, lineNumber);
    ++m_scan.rows;
    ++block.rows;
}

bool Scanner::readPositions(RowStore::Block& block)
{
    bool good = true;
    if (m_scan.dimensions == 1) {
        Number position;
        good = m_cells.readNumber(1, position);
        if (good)
            m_piece->positions[0].append(position);
        return good;
    }
    for (std::size_t d = 0; d < m_piece->positions.size(); ++d) {
        NumberFault fault = NumberFault::None;
        std::optional<std::uint16_t> id;
        if (m_cells.decideDecimal(d + 1)) {
            id = m_piece->positions[d].intern(m_cells.text(d + 1), m_cells.format().decimal, fault);
            m_cells.reportFault(fault, d + 1);
        }
        good = good && id;
        block.ids[d * m_piece->rows.blockRows() + block.rows] = id.value_or(0);
    }
    return good;
}

void Scanner::readValues(std::size_t lineNumber, RowStore::Block& block)
{
    const std::size_t positions = m_piece->positions.size();
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
            m_piece->ranges[table].add(number.value, stored, m_piece->rows.size());
        }
        block.values[table * m_piece->rows.blockRows() + block.rows] = stored;
    }
}

} // namespace

std::vector<SortedPositions::Place> Scan::positionsOf(std::size_t dimension) const
{
    std::vector<SortedPositions::Place> positions;
    positions.reserve(
        pieces.back().firstId[dimension] + pieces.back().positions[dimension].values().size());
    for (const Piece& piece : pieces)
        for (const double value : piece.positions[dimension].values())
            positions.push_back({value, static_cast<std::uint32_t>(positions.size())});
    return positions;
}

std::size_t Scan::rowOf(std::size_t dimension, std::size_t id) const
{
    if (dimensions == 1)
        return id;
    const auto isBefore = [&](const Piece& piece) { return piece.firstId[dimension] <= id; };
    const Piece& piece = *(std::ranges::partition_point(pieces, isBefore) - 1);
    const std::size_t stride = piece.rows.blockRows();
    std::size_t row = piece.firstRow;
    for (const RowStore::Block& block : piece.rows.blocks()) {
        const std::uint16_t* const ids = block.ids.get() + dimension * stride;
        const auto* const found = std::find(ids, ids + block.rows, id - piece.firstId[dimension]);
        row += static_cast<std::size_t>(found - ids);
        if (found != ids + block.rows)
            break;
    }
    return row;
}

int Scan::lastDecimalOf(std::size_t dimension) const
{
    int decimal = std::numeric_limits<int>::max();
    for (const Piece& piece : pieces)
        decimal = std::min(decimal, piece.positions[dimension].lastDecimal());
    return decimal;
}

Scan scan(const TextInspection& text, const CsvOptions& options, DiagnosticList& diagnostics)
{
    return Scanner(text, options, diagnostics).run();
}

} // namespace axiscomp::csv
