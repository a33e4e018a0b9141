// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/columns.h"

#include <algorithm>
#include <functional>

namespace axiscomp::csv {

std::optional<std::uint32_t> PositionColumn::intern(
    std::string_view cell, char decimal, NumberFault& fault)
{
    fault = NumberFault::None;
    // The same position again is what breaks the order of the slow dimensions.
    if (!m_entries.empty() && textOf(m_last) == cell) {
        m_entries[m_last].follower = m_last;
        return m_last;
    }
    if ((m_entries.size() + 1) * 2 > m_slots.size())
        grow();
    std::uint32_t* slot = slotOf(cell);
    if (*slot == none) {
        Number number;
        fault = parseNumber(cell, decimal, number);
        if (fault != NumberFault::None)
            return std::nullopt;
        *slot = add(cell, number);
    }
    m_entries[m_last].follower = *slot;
    m_last = *slot;
    return *slot;
}

std::uint32_t* PositionColumn::slotOf(std::string_view cell)
{
    const std::size_t mask = m_slots.size() - 1;
    std::size_t i = std::hash<std::string_view>{}(cell)&mask;
    while (m_slots[i] != none && textOf(m_slots[i]) != cell)
        i = (i + 1) & mask;
    return &m_slots[i];
}

std::uint32_t PositionColumn::add(std::string_view cell, const Number& number)
{
    const auto id = static_cast<std::uint32_t>(m_entries.size());
    // A new text most likely stays (slow dimensions); the fast one learns its order in one round.
    Entry entry{{0, 0}, static_cast<std::uint32_t>(cell.data() - m_text.data()), id,
        static_cast<std::uint32_t>(cell.size())};
    std::memcpy(entry.head, cell.data(), std::min(cell.size(), inlineLength));
    m_entries.push_back(entry);
    append(number);
    return id;
}

void PositionColumn::grow()
{
    m_slots.assign(std::max<std::size_t>(64, m_slots.size() * 2), none);
    for (std::uint32_t id = 0; id < m_entries.size(); ++id)
        *slotOf(textOf(id)) = id;
}

RowStore::RowStore(std::size_t idsPerRow, std::size_t valuesPerRow)
    : m_idsPerRow(idsPerRow)
    , m_valuesPerRow(valuesPerRow)
{
    constexpr std::size_t blockCells = 65536;
    m_blockRows = std::max<std::size_t>(blockCells / (idsPerRow + valuesPerRow), 16);
}

RowStore::Block& RowStore::open()
{
    if (m_blocks.empty() || m_blocks.back().rows == m_blockRows) {
        m_finished += lastRows();
        // Not initialised: every row is written before it is counted.
        m_blocks.push_back(
            {std::unique_ptr<std::uint32_t[]>(new std::uint32_t[m_idsPerRow * m_blockRows]),
                std::unique_ptr<float[]>(new float[m_valuesPerRow * m_blockRows]), 0});
    }
    return m_blocks.back();
}

} // namespace axiscomp::csv
