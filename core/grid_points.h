// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grid.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace axiscomp {

/// False where the distance is below the resolution of the positions, so that neighbours are one
/// place, or below that of numbers at all.
[[nodiscard]] inline bool pointsAreDistinct(const GridAxis& axis)
{
    return std::isnormal(axis.distance) && axis.position(1) > axis.start
        && axis.last() > axis.position(axis.size - 2);
}

/// Calls visit(index in the file, index in CompensationTable::values) for every element of a file
/// in which the last dimension is the fastest.
template <typename Visit> void visitLastDimensionFastest(const Grid& grid, Visit visit)
{
    std::array<std::size_t, 3> size{1, 1, 1};
    for (std::size_t i = 0; i < grid.axes.size(); ++i)
        size[i] = grid.axes[i].size;
    std::size_t fileIndex = 0;
    for (std::size_t i1 = 0; i1 < size[0]; ++i1) {
        for (std::size_t i2 = 0; i2 < size[1]; ++i2) {
            for (std::size_t i3 = 0; i3 < size[2]; ++i3)
                visit(fileIndex++, i1 + size[0] * (i2 + size[1] * i3));
        }
    }
}

} // namespace axiscomp
