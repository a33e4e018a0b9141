// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/csv_rows.h"

#include <algorithm>

namespace axiscomp::csv {

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
