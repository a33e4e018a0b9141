// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/fast_rows.h"

#include <limits>

namespace axiscomp::csv {

namespace {

constexpr std::size_t reach = std::max(PositionColumn::matchReach, shortNumberReach);

/// One data line at a time; Dimensions is known at compile time to keep the loop over them flat.
template <int Dimensions> class PlainRowReader {
public:
    PlainRowReader(Scan& scan, const CellFormat& format, const char* end)
        : m_scan(scan)
        , m_format(format)
        , m_end(end)
        , m_tables(scan.tables())
    {
    }

    /// Fills the next row of the block and moves p behind the line; on false both stay.
    bool read(const char*& p, RowStore::Block& block)
    {
        const char* q = p;
        Number position;
        std::uint32_t* ids = block.ids.get() + block.rows;
        if constexpr (Dimensions == 1) {
            if (!number(q, position) || !separator(q))
                return false;
        } else {
            for (std::size_t d = 0; d < Dimensions; ++d)
                if (!positionId(q, d, ids[d * m_scan.rows.blockRows()]))
                    return false;
        }
        float* values = block.values.get() + block.rows;
        for (std::size_t table = 0; table < m_tables; ++table) {
            Number value;
            if ((table > 0 && !separator(q)) || !number(q, value))
                return false;
            const auto stored = static_cast<float>(value.value);
            if (!(stored <= largest && stored >= -largest))
                return false;
            values[table * m_scan.rows.blockRows()] = stored;
            m_scan.ranges[table].add(value.value, stored, m_row);
        }
        if (!lineEnd(q))
            return false;
        if constexpr (Dimensions == 1)
            m_scan.positions[0].append(position);
        ++block.rows;
        ++m_row;
        p = q;
        return true;
    }

private:
    static constexpr float largest = std::numeric_limits<float>::max();

    bool separator(const char*& p) const { return p != m_end && *p++ == m_format.separator; }
    bool lineEnd(const char*& p) const
    {
        if (p == m_end)
            return false;
        if (*p == '\n') {
            ++p;
            return true;
        }
        if (*p != '\r')
            return false;
        p += m_end - p > 1 && p[1] == '\n' ? 2 : 1;
        return true;
    }
    std::string_view numberText(const char* p) const
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
    bool number(const char*& p, Number& result) const
    {
        if (m_end - p < static_cast<std::ptrdiff_t>(reach))
            return false;
        const char* after = parseShortNumber(p, m_format.decimal, result);
        if (after != nullptr && (*after < '0' || *after > '9')) {
            p = after;
            return true;
        }
        const std::string_view text = numberText(p);
        p += text.size();
        return parseNumber(text, m_format.decimal, result) == NumberFault::None;
    }
    bool positionId(const char*& p, std::size_t dimension, std::uint32_t& id) const
    {
        if (m_end - p < static_cast<std::ptrdiff_t>(reach))
            return false;
        PositionColumn& column = m_scan.positions[dimension];
        if (column.match(p, m_end, m_format.separator, id))
            return true;
        const std::string_view text = numberText(p);
        NumberFault fault = NumberFault::None;
        if (p + text.size() == m_end || p[text.size()] != m_format.separator)
            return false;
        const std::optional<std::uint32_t> found = column.intern(text, m_format.decimal, fault);
        p += text.size() + 1;
        id = found.value_or(0);
        return found.has_value();
    }

    Scan& m_scan;
    const CellFormat m_format;
    const char* const m_end;
    const std::size_t m_tables;
    std::size_t m_row = m_scan.rows.size();
};

template <int Dimensions>
const char* readRows(Scan& scan, const CellFormat& format, const char* p, const char* until,
    const char* end, std::size_t maximumRows)
{
    PlainRowReader<Dimensions> reader(scan, format, end);
    while (p < until && scan.rows.size() < maximumRows) {
        RowStore::Block& block = scan.rows.open();
        std::size_t room =
            std::min(scan.rows.blockRows() - block.rows, maximumRows - scan.rows.size());
        for (; room > 0 && p < until; --room)
            if (!reader.read(p, block))
                return p;
    }
    return p;
}

} // namespace

const char* readPlainRows(Scan& scan, const CellFormat& format, const char* begin,
    const char* until, const char* end, std::size_t maximumRows)
{
    switch (scan.dimensions) {
    case 1:
        return readRows<1>(scan, format, begin, until, end, maximumRows);
    case 2:
        return readRows<2>(scan, format, begin, until, end, maximumRows);
    default:
        return readRows<3>(scan, format, begin, until, end, maximumRows);
    }
}

} // namespace axiscomp::csv
