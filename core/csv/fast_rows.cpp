// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/fast_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace axiscomp::csv {

namespace {

constexpr float largestFloat = std::numeric_limits<float>::max();
constexpr std::size_t lineEndReach = 2;

/// One data line at a time; Dimensions is known at compile time to keep the loop over them flat.
template <int Dimensions> class PlainRowReader {
public:
    PlainRowReader(Piece& piece, const CellFormat& format, const char* end)
        : m_columns(piece.positions.data())
        , m_ranges(piece.ranges.data())
        , m_tables(piece.ranges.size())
        , m_stride(piece.rows.blockRows())
        , m_format(format)
        , m_end(end)
        , m_reach(static_cast<std::ptrdiff_t>(
              (Dimensions + m_tables) * (shortNumberReach + 1) + lineEndReach))
        , m_appends(Dimensions == 1 || !piece.positions.front().expectsRepeats())
        , m_batchRows(std::clamp<std::size_t>(64 / m_tables, 1, 64))
        , m_values(m_tables * m_batchRows)
    {
    }

    /// Fills rows of the block from block.rows on, at most up to lastRow. firstRow: the row of the
    /// piece that is the block's first. Returns where it stopped.
    const char* fill(RowStore::Block& block, std::size_t firstRow, std::size_t lastRow,
        const char* p, const char* until)
    {
        bool isPlain = true;
        while (isPlain && p < until && block.rows < lastRow) {
            const std::size_t batch = std::min(m_batchRows, lastRow - block.rows);
            std::uint16_t* const ids = block.ids.get() + block.rows;
            std::size_t rows = 0;
            while (p < until && rows < batch) {
                const char* const next = read(p, ids + rows, rows);
                isPlain = next != nullptr;
                if (!isPlain)
                    break;
                p = next;
                ++rows;
            }
            finish(block.values.get() + block.rows, rows, firstRow + block.rows);
            block.rows += rows;
            expectWhatCameUp(firstRow + block.rows);
        }
        return p;
    }

private:
    /// Returns the beginning of the next line; nullptr: this one is not taken.
    const char* read(const char* p, std::uint16_t* ids, std::size_t row)
    {
        if (!hasRoom(p))
            return nullptr;
        std::array<Number, Dimensions> appended;
        p = m_appends ? numbers(p, appended) : knownPositions(p, ids);
        if (p == nullptr)
            return nullptr;
        for (std::size_t table = 0; table < m_tables; ++table) {
            if (table > 0 && *p++ != m_format.separator)
                return nullptr;
            p = value(p, m_values[table * m_batchRows + row]);
            if (p == nullptr)
                return nullptr;
        }
        p = lineEnd(p);
        if (m_appends && p != nullptr)
            append(appended, ids);
        return p;
    }

    const char* knownPositions(const char* p, std::uint16_t* ids) const
    {
        for (std::size_t d = 0; d < Dimensions; ++d) {
            std::uint16_t& id = ids[d * m_stride];
            const char* const next = m_columns[d].match(p, id);
            p = next != nullptr ? next : otherPosition(p, m_columns[d], id);
            if (p == nullptr)
                return nullptr;
        }
        return p;
    }
    const char* numbers(const char* p, std::array<Number, Dimensions>& found) const
    {
        for (Number& each : found) {
            p = number(p, each);
            if (p == nullptr || *p++ != m_format.separator)
                return nullptr;
        }
        return p;
    }
    /// When the whole line is taken: the thorough reader would append its positions once more.
    void append(const std::array<Number, Dimensions>& found, std::uint16_t* ids)
    {
        for (std::size_t d = 0; d < Dimensions; ++d) {
            const std::uint16_t id = m_columns[d].append(found[d]);
            if constexpr (Dimensions > 1)
                ids[d * m_stride] = id;
        }
    }

    /// The divisions of several rows beside each other: one would wait for the text of its row, and
    /// the next row for it.
    void finish(float* values, std::size_t rows, std::size_t firstRow)
    {
        for (std::size_t table = 0; table < m_tables; ++table) {
            const ShortNumber* const numbers = m_values.data() + table * m_batchRows;
            ValueRange range = m_ranges[table];
            for (std::size_t i = 0; i < rows; ++i) {
                const double value = numbers[i].value();
                const auto stored = static_cast<float>(value);
                values[table * m_stride + i] = stored;
                range.add(value, stored, firstRow + i);
            }
            m_ranges[table] = range;
        }
    }
    /// In a grid at least one position repeats soon, whatever the order of the rows.
    void expectWhatCameUp(std::size_t rows)
    {
        constexpr std::size_t fewRows = 256;
        const std::span columns(m_columns, Dimensions);
        if (m_appends || rows < fewRows)
            return;
        m_appends = std::ranges::all_of(
            columns, [&](const PositionColumn& each) { return each.values().size() == rows; });
        if (m_appends)
            std::ranges::for_each(columns, &PositionColumn::expectNoRepeats);
    }
    const char* value(const char* p, ShortNumber& result) const
    {
        const char* const after = parseShortNumber(p, m_format.decimal, result);
        return after != nullptr ? after : longValue(p, result);
    }
    [[gnu::noinline]] const char* longValue(const char* p, ShortNumber& result) const
    {
        Number number;
        p = longNumber(p, number);
        result = {number.value, 0};
        return p != nullptr && std::fabs(static_cast<float>(number.value)) <= largestFloat
            ? p
            : nullptr;
    }

    /// For a line of short cells from here on; so nothing else has to look for the end.
    [[nodiscard]] bool hasRoom(const char* p) const { return m_end - p >= m_reach; }
    static const char* lineEnd(const char* p)
    {
        if (*p == '\n')
            return p + 1;
        if (*p != '\r')
            return nullptr;
        return p + (p[1] == '\n' ? 2 : 1);
    }
    [[nodiscard]] std::string_view numberText(const char* p) const
    {
        const char* q = p;
        const auto belongs = [this](char c) {
            return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == 'e' || c == 'E'
                || (c == m_format.decimal && c != '\0');
        };
        while (q != m_end && belongs(*q))
            ++q;
        return {p, static_cast<std::size_t>(q - p)};
    }
    const char* number(const char* p, Number& result) const
    {
        const char* const after = parseShortNumber(p, m_format.decimal, result);
        return after != nullptr ? after : longNumber(p, result);
    }
    [[gnu::noinline]] const char* longNumber(const char* p, Number& result) const
    {
        const std::string_view text = numberText(p);
        p += text.size();
        const bool isNumber =
            hasRoom(p) && parseNumber(text, m_format.decimal, result) == NumberFault::None;
        return isNumber ? p : nullptr;
    }
    const char* otherPosition(const char* p, PositionColumn& column, std::uint16_t& id) const
    {
        const std::optional<std::size_t> length = column.shortLength(p);
        const auto known = length ? column.known(p, *length) : std::nullopt;
        if (!known)
            return newPosition(p, length ? *length : numberText(p).size(), column, id);
        id = *known;
        return p + *length + 1;
    }
    [[gnu::noinline]] const char* newPosition(
        const char* p, std::size_t length, PositionColumn& column, std::uint16_t& id) const
    {
        const std::string_view text(p, length);
        p += text.size();
        NumberFault fault = NumberFault::None;
        if (!hasRoom(p) || *p != m_format.separator)
            return nullptr;
        const std::optional<std::uint16_t> found = column.intern(text, m_format.decimal, fault);
        id = found.value_or(0);
        return found ? p + 1 : nullptr;
    }

    PositionColumn* const m_columns;
    ValueRange* const m_ranges;
    const std::size_t m_tables;
    const std::size_t m_stride;
    const CellFormat m_format;
    const char* const m_end;
    const std::ptrdiff_t m_reach;
    bool m_appends; ///< positions do not repeat
    const std::size_t m_batchRows;
    std::vector<ShortNumber> m_values; ///< [table * m_batchRows + row], not divided yet
};

template <int Dimensions>
const char* readRows(Piece& piece, const CellFormat& format, const char* p, const char* until,
    const char* end, std::size_t maximumRows)
{
    PlainRowReader<Dimensions> reader(piece, format, end);
    while (p < until && piece.rows.size() < maximumRows) {
        RowStore::Block& block = piece.rows.open();
        const std::size_t firstRow = piece.rows.size() - block.rows;
        const std::size_t lastRow = std::min(piece.rows.blockRows(), maximumRows - firstRow);
        p = reader.fill(block, firstRow, lastRow, p, until);
        if (block.rows < lastRow)
            break;
    }
    return p;
}

} // namespace

const char* readPlainRows(Piece& piece, const CellFormat& format, const char* begin,
    const char* until, const char* end, std::size_t maximumRows)
{
    static_assert(PositionColumn::matchReach <= shortNumberReach);
    switch (piece.positions.size()) {
    case 1:
        return readRows<1>(piece, format, begin, until, end, maximumRows);
    case 2:
        return readRows<2>(piece, format, begin, until, end, maximumRows);
    default:
        return readRows<3>(piece, format, begin, until, end, maximumRows);
    }
}

} // namespace axiscomp::csv
