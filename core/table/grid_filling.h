// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace axiscomp {

/// Coordinates of the points of a grid, per dimension, ascending, of comparable size.
using GridCoordinates = std::vector<std::vector<double>>;

/// Each of these gives values to the points that are NaN; the first dimension is the fastest. At
/// least one point has a value.
void fillNearest(const GridCoordinates& coordinates, std::span<double> values);

/// False: the measured points lie on a line (in 1D: are one, in 3D: on a plane), so that there is
/// no one plane through them.
[[nodiscard]] bool fillPlane(const GridCoordinates& coordinates, std::span<double> values);
[[nodiscard]] bool fillSmooth(const GridCoordinates& coordinates, std::span<double> values);

/// What fillSmooth can do in seconds.
[[nodiscard]] std::size_t mostSmoothPoints(std::size_t dimensions);

} // namespace axiscomp
