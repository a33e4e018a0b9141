// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace axiscomp {

/// False where the distance is below some thirty times the resolution of the positions: neighbours
/// would be one place, or at uneven places, and a lookup could not tell which of them is meant. Or
/// below the resolution of numbers at all.
[[nodiscard]] inline bool pointsAreDistinct(const GridAxis& axis)
{
    const double largest = std::max(std::abs(axis.start), std::abs(axis.last()));
    return std::isnormal(axis.distance)
        && axis.distance > 32.0 * std::numeric_limits<double>::epsilon() * largest;
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
