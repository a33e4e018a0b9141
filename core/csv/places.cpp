// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/places.h"

#include <algorithm>

namespace axiscomp::csv {

Places::Places(const Scan& scan, const std::vector<GridLines>& lines) : m_scan(scan)
{
    // Doubles hold every place that is looked at exactly, and do not overflow beyond.
    double stride = 1.0;
    for (std::size_t d = 0; d < lines.size(); ++d) {
        m_strides[d].reserve(lines[d].lineOf.size());
        for (const std::uint32_t line : lines[d].lineOf)
            m_strides[d].push_back(stride * line);
        stride *= static_cast<double>(lines[d].positions.size());
    }
}

void Places::find(const Piece& piece, const RowStore::Block& block, std::size_t row,
    std::span<double> places) const
{
    const double* const first = m_strides[0].data() + piece.firstId[0];
    if (m_scan.dimensions == 1) {
        std::copy_n(first + row, places.size(), places.begin());
        return;
    }
    const std::size_t stride = piece.rows.blockRows();
    const std::uint16_t* const ids = block.ids.get();
    const double* const second = m_strides[1].data() + piece.firstId[1];
    if (m_scan.dimensions == 2) {
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i] = first[ids[i]] + second[ids[stride + i]];
        return;
    }
    const double* const third = m_strides[2].data() + piece.firstId[2];
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = first[ids[i]] + second[ids[stride + i]] + third[ids[2 * stride + i]];
}

std::size_t Places::rowOf(double place) const
{
    std::size_t found = m_scan.rows;
    for (std::size_t n = 0; n < m_scan.pieces.size() && found == m_scan.rows; ++n)
        forEachBlock(m_scan.pieces[n],
            [&](std::size_t row, const RowStore::Block&, std::span<const double> places) {
                const auto at = std::ranges::find(places, place);
                if (at != places.end())
                    found = row + static_cast<std::size_t>(at - places.begin());
                return found == m_scan.rows;
            });
    return found;
}

} // namespace axiscomp::csv
