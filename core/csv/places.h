// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/grid_lines.h"
#include "core/csv/scan.h"

#include <array>
#include <span>
#include <vector>

namespace axiscomp::csv {

/// Where the rows stand in the tables, dimension 1 fastest. Computed again whenever it is asked
/// for: that takes less time than reading it from memory.
class Places {
public:
    /// Both are kept by reference.
    Places(const Scan& scan, const std::vector<GridLines>& lines);

    /// Calls visit(row of the file, block, places) for one block of the piece after the other,
    /// until it returns false. Places are whole numbers, in a file that is no grid beyond any
    /// integer.
    template <typename Visit> void forEachBlock(const Piece& piece, Visit&& visit) const
    {
        std::vector<double> places(piece.rows.blockRows());
        std::size_t row = 0;
        for (const RowStore::Block& block : piece.rows.blocks()) {
            const std::span<double> own = std::span(places).first(block.rows);
            find(piece, block, row, own);
            if (!visit(piece.firstRow + row, block, std::span<const double>(own)))
                return;
            row += block.rows;
        }
    }

    /// The first row that stands there; the number of rows if there is none.
    [[nodiscard]] std::size_t rowOf(double place) const;

private:
    void find(const Piece& piece, const RowStore::Block& block, std::size_t row,
        std::span<double> places) const;

    const Scan& m_scan;
    std::array<std::vector<double>, 3> m_strides; ///< of a position, by its id
};

} // namespace axiscomp::csv
