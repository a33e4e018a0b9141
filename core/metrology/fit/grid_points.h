// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/grid_fit.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace axiscomp {

/// The sizes of a grid, with 1 for dimensions that it lacks.
struct GridShape {
    std::size_t dimensions = 1;
    std::array<std::size_t, 3> size{1, 1, 1};
    std::array<std::size_t, 3> stride{1, 1, 1};

    explicit GridShape(const Grid& grid);
    [[nodiscard]] std::size_t nodes() const { return size[0] * size[1] * size[2]; }
    [[nodiscard]] std::size_t corners() const { return std::size_t{1} << dimensions; }
    [[nodiscard]] std::size_t place(std::size_t node, std::size_t axis) const
    {
        return node / stride[axis] % size[axis];
    }
    /// Of a corner of a cell from its first node; bit a of corner: the far end of axis a.
    [[nodiscard]] std::size_t cornerOffset(std::size_t corner) const
    {
        std::size_t offset = 0;
        for (std::size_t axis = 0; axis < dimensions; ++axis)
            offset += (corner >> axis & 1U) * stride[axis];
        return offset;
    }
};

/// A value in the cell of a grid.
struct GridPoint {
    std::uint32_t node = 0; ///< the first corner of the cell
    std::uint32_t fold = 0; ///< made of the position alone: repeated points have the same
    std::array<double, 3>
        fraction{}; ///< of the way to the next node; 0 where there is no dimension
    double value = 0.0;
    double weight = 1.0;

    /// The weights of the corners, by which the drive interpolates.
    [[nodiscard]] std::array<double, 8> cornerWeights(std::size_t dimensions) const
    {
        std::array<double, 8> weights{1.0 - fraction[0], fraction[0]};
        std::size_t count = 2;
        for (std::size_t axis = 1; axis < dimensions; ++axis, count *= 2) {
            for (std::size_t i = 0; i < count; ++i) {
                weights[count + i] = weights[i] * fraction[axis];
                weights[i] *= 1.0 - fraction[axis];
            }
        }
        return weights;
    }
};

/// Those within the grid, ordered by cell, position, value and weight, so that no result depends on
/// the order of the input. sources[i]: the index of point i in the input.
struct GridPoints {
    std::vector<GridPoint> points;
    std::vector<std::uint32_t> sources;
};
[[nodiscard]] GridPoints locate(const Grid& grid, const ScatteredValues& values);

/// What the drive makes of nodes at a point.
[[nodiscard]] double interpolated(
    const GridShape& shape, std::span<const double> nodes, const GridPoint& point);

} // namespace axiscomp
