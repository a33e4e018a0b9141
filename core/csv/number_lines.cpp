// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/number_lines.h"

#include "core/base/parallel.h"
#include "core/text/line_reader.h"

namespace axiscomp::csv {

namespace {

constexpr std::size_t pieceSize = std::size_t{256} << 10;
constexpr std::size_t piecesAtOnce = 64;

bool readLine(std::string_view line, const CellFormat& format, const char* textEnd,
    std::size_t columns, std::vector<double>& values)
{
    Cell cell;
    Number number;
    bool more = true;
    for (std::size_t column = 0; column < columns; ++column) {
        if (!more || !takeShortNumber(line, format, textEnd, cell, number, more))
            return false;
        values.push_back(number.value);
    }
    return !more;
}

void readPiece(
    NumberLines& piece, const CellFormat& format, const char* textEnd, std::size_t columns)
{
    LineReader reader({piece.end, static_cast<std::size_t>(piece.limit - piece.end)});
    while (!reader.atEnd()) {
        if (!readLine(reader.next(), format, textEnd, columns, piece.values))
            break;
        piece.end = reader.position();
        ++piece.lines;
    }
    piece.values.resize(piece.lines * columns);
}

} // namespace

std::vector<NumberLines> readNumberLines(
    std::string_view text, const CellFormat& format, std::size_t columns)
{
    std::vector<NumberLines> pieces;
    const char* const textEnd = text.data() + text.size();
    const char* begin = text.data();
    for (const char* const end : pieceEnds(text, pieceSize, piecesAtOnce)) {
        pieces.push_back({.values = {}, .lines = 0, .begin = begin, .end = begin, .limit = end});
        begin = end;
    }
    shareWork(
        pieces.size(), 0, [&](std::size_t n) { readPiece(pieces[n], format, textEnd, columns); });
    return pieces;
}

} // namespace axiscomp::csv
