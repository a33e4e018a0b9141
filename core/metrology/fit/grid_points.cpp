// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/grid_points.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace axiscomp {

namespace {

/// The finalizer of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixedBits(std::uint64_t bits)
{
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31);
}

/// By positions counted in millionths of the grid's distances, so that units do not matter.
std::uint32_t foldOf(const std::array<double, 3>& numbers)
{
    std::uint64_t hash = 0x9e3779b97f4a7c15U;
    for (const double number : numbers)
        hash = mixedBits(hash + static_cast<std::uint64_t>(std::llround(number * 1048576.0)));
    return static_cast<std::uint32_t>(hash >> 32);
}

/// False when the point lies outside.
bool placeInCell(const Grid& grid, const GridShape& shape, const ScatteredValues& values,
    std::size_t index, GridPoint& point)
{
    std::size_t node = 0;
    std::array<double, 3> numbers{};
    for (std::size_t axis = 0; axis < shape.dimensions; ++axis) {
        const GridAxis& along = grid.axes[axis];
        const double rounding = 1e-9 * static_cast<double>(along.size);
        const double number = (values.coordinates[axis][index] - along.start) / along.distance;
        const auto last = static_cast<double>(along.size - 1);
        if (!(number >= -rounding && number <= last + rounding))
            return false;
        numbers[axis] = number;
        const double cell = std::clamp(std::floor(number), 0.0, last - 1.0);
        double fraction = std::clamp(number - cell, 0.0, 1.0);
        if (std::abs(fraction) <= rounding)
            fraction = 0.0;
        if (std::abs(fraction - 1.0) <= rounding)
            fraction = 1.0;
        point.fraction[axis] = fraction;
        node += static_cast<std::size_t>(cell) * shape.stride[axis];
    }
    point.node = static_cast<std::uint32_t>(node);
    point.fold = foldOf(numbers);
    point.value = values.values[index];
    point.weight = values.weights.empty() ? 1.0 : values.weights[index];
    return true;
}

/// The order of points by their cells (counting sort).
std::vector<std::uint32_t> byCells(const std::vector<GridPoint>& points, std::size_t nodes)
{
    std::vector<std::uint32_t> begins(nodes + 1, 0);
    for (const GridPoint& point : points)
        ++begins[point.node + 1];
    for (std::size_t node = 0; node < nodes; ++node)
        begins[node + 1] += begins[node];
    std::vector<std::uint32_t> order(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        order[begins[points[i].node]++] = static_cast<std::uint32_t>(i);
    return order;
}

} // namespace

GridShape::GridShape(const Grid& grid) : dimensions(grid.axes.size())
{
    for (std::size_t axis = 0; axis < dimensions; ++axis)
        size[axis] = grid.axes[axis].size;
    stride = {1, size[0], size[0] * size[1]};
}

GridPoints locate(const Grid& grid, const ScatteredValues& values)
{
    const GridShape shape(grid);
    std::vector<GridPoint> found;
    std::vector<std::uint32_t> indices;
    found.reserve(values.values.size());
    indices.reserve(values.values.size());
    for (std::size_t i = 0; i < values.values.size(); ++i) {
        GridPoint point;
        if (!placeInCell(grid, shape, values, i, point))
            continue;
        found.push_back(point);
        indices.push_back(static_cast<std::uint32_t>(i));
    }
    std::vector<std::uint32_t> order = byCells(found, shape.nodes());
    const auto key = [&found](std::uint32_t i) {
        const GridPoint& point = found[i];
        return std::tie(point.fraction, point.value, point.weight);
    };
    for (auto begin = order.begin(); begin != order.end();) {
        const std::uint32_t node = found[*begin].node;
        const auto end = std::find_if(
            begin, order.end(), [&](std::uint32_t i) { return found[i].node != node; });
        std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        begin = end;
    }
    GridPoints result;
    result.points.reserve(order.size());
    result.sources.reserve(order.size());
    for (const std::uint32_t i : order) {
        result.points.push_back(found[i]);
        result.sources.push_back(indices[i]);
    }
    return result;
}

double interpolated(const GridShape& shape, std::span<const double> nodes, const GridPoint& point)
{
    const std::array<double, 8> weights = point.cornerWeights(shape.dimensions);
    double sum = 0.0;
    for (std::size_t corner = 0; corner < shape.corners(); ++corner) {
        if (weights[corner] != 0.0)
            sum += weights[corner] * nodes[point.node + shape.cornerOffset(corner)];
    }
    return sum;
}

} // namespace axiscomp
