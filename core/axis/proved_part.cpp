// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/proved_part.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

ProvedPart::ProvedPart(const Grid& grid) : m_grid(grid)
{
    std::size_t cells = 1;
    for (std::size_t n = 0; n < m_grid.axes.size(); ++n)
        cells *= cellsAlong(n);
    m_isSeen.resize(cells);
}

std::size_t ProvedPart::cellsAlong(std::size_t dimension) const
{
    return m_grid.axes[dimension].size - 1;
}

void ProvedPart::add(const std::array<double, 3>& positions)
{
    if (!isWithin(m_grid, positions))
        return;
    std::size_t cell = 0;
    std::size_t stride = 1;
    for (std::size_t n = 0; n < m_grid.axes.size(); ++n) {
        const GridAxis& axis = m_grid.axes[n];
        // what rounding puts before the start is the start
        const double index = std::floor(std::max(0.0, positions[n] - axis.start) / axis.distance);
        cell += stride * std::min(static_cast<std::size_t>(index), cellsAlong(n) - 1);
        stride *= cellsAlong(n);
    }
    if (m_isSeen[cell])
        return;
    m_isSeen[cell] = true;
    m_seen.push_back(cell);
}

double ProvedPart::share() const
{
    return static_cast<double>(m_seen.size()) / static_cast<double>(m_isSeen.size());
}

std::array<double, 3> ProvedPart::middleOf(std::size_t cell) const
{
    std::array<double, 3> middle{};
    for (std::size_t n = 0; n < m_grid.axes.size(); ++n) {
        middle[n] = m_grid.axes[n].position(cell % cellsAlong(n)) + 0.5 * m_grid.axes[n].distance;
        cell /= cellsAlong(n);
    }
    return middle;
}

} // namespace axiscomp
