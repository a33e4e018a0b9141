// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// One dimension of an even grid: position(i) = start + i * distance, i = 0 .. size - 1.
struct GridAxis {
    std::string name; ///< the column's header without its unit, may be empty
    std::string unit; ///< "mm" of "X [mm]"; may be empty
    double start = 0.0; ///< finite
    double distance = 1.0; ///< > 0
    std::uint32_t size = 2; ///< >= 2

    [[nodiscard]] double position(std::size_t index) const
    {
        return start + static_cast<double>(index) * distance;
    }
    [[nodiscard]] double last() const { return position(size - 1); }
    friend bool operator==(const GridAxis&, const GridAxis&) = default;
};

/// The positions that are inside of a table along one axis, for every lookup. start + (size - 1) *
/// distance may be some units in the last place off the last position that a file gives, so that
/// what differs from an end by the rounding of doubles alone is that end.
class InsideRange {
public:
    InsideRange() = default;
    InsideRange(double first, double last);

    /// false for NaN
    [[nodiscard]] bool contains(double position) const
    {
        return position >= m_from && position <= m_to;
    }

private:
    double m_from = 0.0;
    double m_to = 0.0;
};

/// 1 to 3 grid axes. Element order: dimension 1 fastest (docs/tamtbl.md, "Order of the elements").
struct Grid {
    std::vector<GridAxis> axes;

    [[nodiscard]] int dimensions() const { return static_cast<int>(axes.size()); }
    [[nodiscard]] std::size_t pointCount() const
    {
        std::size_t count = axes.empty() ? 0 : 1;
        for (const GridAxis& axis : axes)
            count *= axis.size;
        return count;
    }
    friend bool operator==(const Grid&, const Grid&) = default;
};

/// As part of the distance: as much as a point may move where start and distance are rounded to
/// single precision, and be the same point.
inline constexpr double largestPointShift = 1e-3;

/// The same sizes, starts and distances, NaN included, whatever the names and units.
[[nodiscard]] bool sameSpans(const Grid& a, const Grid& b);

/// Whether a position is on the grid or between its points (InsideRange), in every dimension.
/// positions: one per dimension.
[[nodiscard]] bool isWithin(const Grid& grid, std::span<const double> positions);

/// The position of a point of a table, dimension 1 fastest; one number per dimension.
[[nodiscard]] std::vector<double> positionOf(const Grid& grid, std::size_t point);

/// False where the distance is below some thirty times the resolution of the positions: neighbours
/// would be one place, or at uneven places, and a lookup could not tell which of them is meant. Or
/// below the resolution of numbers at all.
[[nodiscard]] bool pointsAreDistinct(const GridAxis& axis);

/// Calls visit(index in the file, index in the values of a table, dimension 1 fastest) for every
/// element of a file in which the last dimension is the fastest.
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
