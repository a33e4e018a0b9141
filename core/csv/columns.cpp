// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/columns.h"

#include <functional>

namespace axiscomp::csv {

PositionColumn::PositionColumn(std::string_view text, char separator)
    : m_text(text)
    , m_separators(everyByte(static_cast<std::uint8_t>(separator)))
    , m_entries(1, Entry{{1, 0}, {0, 0}, 0, 0, 0})
    , m_slots(64)
{
}

std::optional<std::uint16_t> PositionColumn::intern(
    std::string_view cell, char decimal, NumberFault& fault)
{
    fault = cell.empty() ? NumberFault::NotANumber : NumberFault::None;
    if (cell.empty())
        return std::nullopt;
    if (m_entries.size() * 2 >= m_slots.size() && expectsRepeats())
        grow();
    const Key key = keyOf(cell);
    std::uint16_t* const entry = expectsRepeats() ? &m_slots[slotOf(key, cell)] : nullptr;
    if (entry != nullptr && *entry != 0)
        return follow(*entry);
    Number number;
    fault = parse(cell, decimal, number);
    if (fault != NumberFault::None)
        return std::nullopt;
    const std::uint16_t id = append(number);
    if (entry != nullptr)
        follow(*entry = add(key, cell));
    return id;
}

void PositionColumn::expectNoRepeats()
{
    // Nothing is expected of the entry that is no text.
    m_entries.assign(1, m_entries.front());
    m_last = m_expected = m_entries.front().follower = 0;
    m_slots = std::vector<std::uint16_t>();
}

void PositionColumn::close()
{
    // What = {} assigns is an empty list, for which they would keep their memory.
    m_entries = std::vector<Entry>();
    m_slots = std::vector<std::uint16_t>();
    m_values.shrink_to_fit();
}

NumberFault PositionColumn::parse(std::string_view cell, char decimal, Number& number) const
{
    const char* const end = cell.data() + cell.size();
    const auto readable = m_text.data() + m_text.size() - cell.data();
    if (readable >= static_cast<std::ptrdiff_t>(shortNumberReach)
        && parseShortNumber(cell.data(), decimal, number) == end)
        return NumberFault::None;
    return parseNumber(cell, decimal, number);
}

PositionColumn::Key PositionColumn::keyOf(std::string_view cell) const
{
    if (cell.size() > keyLength)
        return {1, 0};
    std::array<char, matchReach> copy{};
    const char* p = cell.data();
    if (m_text.data() + m_text.size() - p < static_cast<std::ptrdiff_t>(matchReach)) {
        std::ranges::copy(cell, copy.begin());
        p = copy.data();
    }
    Key key = loaded(p);
    const std::size_t word = cell.size() / 8;
    const std::size_t bits = cell.size() % 8 * 8;
    const std::uint64_t below = (std::uint64_t{1} << bits) - 1;
    key[word] = (key[word] & below) | ((m_separators & 0xFFU) << bits);
    if (word == 0)
        key[1] = 0;
    return key;
}

/// Of any text.
std::size_t PositionColumn::slotOf(const Key& key, std::string_view cell) const
{
    if (cell.size() <= keyLength)
        return slotOf(key);
    const std::size_t mask = m_slots.size() - 1;
    std::size_t slot = std::hash<std::string_view>{}(cell)&mask;
    while (m_slots[slot] != 0 && textOf(m_slots[slot]) != cell)
        slot = (slot + 1) & mask;
    return slot;
}

std::uint16_t PositionColumn::add(const Key& key, std::string_view cell)
{
    const auto index = static_cast<std::uint16_t>(m_entries.size());
    // A new text most likely stays (slow dimensions); the fast one learns its order in one round.
    Entry entry{key, {0, 0}, static_cast<std::uint32_t>(cell.data() - m_text.data()),
        static_cast<std::uint32_t>(cell.size()), index};
    if (cell.size() <= keyLength) {
        const std::size_t bits = cell.size() % 8 * 8 + 8;
        const std::uint64_t last = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
        entry.mask = cell.size() < 8 ? Key{last, 0} : Key{~std::uint64_t{0}, last};
    }
    m_entries.push_back(entry);
    return index;
}

void PositionColumn::grow()
{
    m_slots.assign(m_slots.size() * 2, 0);
    for (std::uint32_t n = 1; n < m_entries.size(); ++n)
        m_slots[slotOf(m_entries[n].text, textOf(n))] = static_cast<std::uint16_t>(n);
}

RowStore::RowStore(std::size_t idsPerRow, std::size_t valuesPerRow)
    : m_idsPerRow(idsPerRow)
    , m_valuesPerRow(valuesPerRow)
{
    // A block of a piece is never much larger than the piece: a wide line is one by itself.
    constexpr std::size_t blockCells = 16384;
    m_blockRows = std::max<std::size_t>(blockCells / (idsPerRow + valuesPerRow), 1);
}

RowStore::Block& RowStore::open()
{
    if (m_blocks.empty() || m_blocks.back().rows == m_blockRows)
        // Not initialised: every row is written before it is counted.
        m_blocks.push_back(
            {std::unique_ptr<std::uint16_t[]>(new std::uint16_t[m_idsPerRow * m_blockRows]),
                std::unique_ptr<float[]>(new float[m_valuesPerRow * m_blockRows]), 0});
    return m_blocks.back();
}

} // namespace axiscomp::csv
