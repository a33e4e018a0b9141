// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid.h"

#include <array>
#include <vector>

namespace axiscomp {

/// Which part of a table has been seen at work: a cell lies between neighbouring grid points, and
/// is seen when a position was in it.
class ProvedPart {
public:
    explicit ProvedPart(const Grid& grid);

    /// positions: within the grid, one per dimension; others are left out.
    void add(const std::array<double, 3>& positions);

    [[nodiscard]] const Grid& grid() const { return m_grid; }
    /// 0 to 1, of all cells.
    [[nodiscard]] double share() const;
    /// Those that were seen, in the order in which they were: the cell above grid point i, j, k is
    /// i + cells(1) * (j + cells(2) * k).
    [[nodiscard]] const std::vector<std::size_t>& seen() const { return m_seen; }
    /// The middle of a cell.
    [[nodiscard]] std::array<double, 3> middleOf(std::size_t cell) const;

private:
    [[nodiscard]] std::size_t cellsAlong(std::size_t dimension) const;

    Grid m_grid;
    std::vector<bool> m_isSeen;
    std::vector<std::size_t> m_seen;
};

} // namespace axiscomp
