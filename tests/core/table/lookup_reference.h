// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/lookup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>

namespace axiscomp::test {

inline constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Starts and distances that binary numbers cannot hold exactly.
inline Grid awkwardGrid(int dimensions)
{
    const std::array<GridAxis, 3> axes{GridAxis{"X", "mm", 0.1, 0.1, 7},
        GridAxis{"Y", "mm", -1234.7, 0.7, 5}, GridAxis{"Z", "mm", 1e6 / 3.0, 1.0 / 3.0, 4}};
    return {{axes.begin(), axes.begin() + dimensions}};
}

inline CompensationTable randomTable(const Grid& grid, unsigned seed = 1)
{
    CompensationTable table;
    table.grid = grid;
    table.values.resize(grid.pointCount());
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> value(-1.0F, 1.0F);
    std::ranges::generate(table.values, [&] { return value(generator); });
    return table;
}

using Positions = std::array<double, 3>;

inline double at(const Lookup& lookup, const Positions& positions)
{
    return lookup.at(std::span(positions).first(static_cast<std::size_t>(lookup.dimensions())));
}

inline double valueAt(const CompensationTable& table, const std::array<std::size_t, 3>& point)
{
    const auto& axes = table.grid.axes;
    std::size_t index = 0;
    for (std::size_t i = axes.size(); i-- > 0;)
        index = index * axes[i].size + point[i];
    return static_cast<double>(table.values[index]);
}

/// The textbook: the sum over the corners of the cell, each weighted by the opposite volume.
inline double naiveLookup(const CompensationTable& table, Positions positions, Outside outside)
{
    const auto& axes = table.grid.axes;
    std::array<std::size_t, 3> cell{};
    std::array<double, 3> fraction{};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const GridAxis& axis = axes[i];
        if (std::isnan(positions[i]))
            return notANumber;
        const double stroke = axis.last() - axis.start;
        if (outside == Outside::Hold)
            positions[i] = std::clamp(positions[i], axis.start, axis.last());
        const bool isOutside = positions[i] < axis.start || positions[i] > axis.last();
        if (isOutside && outside == Outside::Zero)
            return 0.0;
        if (isOutside && outside == Outside::Error)
            return notANumber;
        if (isOutside && outside == Outside::Wrap)
            positions[i] -= std::floor((positions[i] - axis.start) / stroke) * stroke;
        const double index = (positions[i] - axis.start) / axis.distance;
        cell[i] = static_cast<std::size_t>(
            std::clamp(std::floor(index), 0.0, static_cast<double>(axis.size - 2)));
        fraction[i] = index - static_cast<double>(cell[i]);
    }
    double sum = 0.0;
    for (std::size_t corner = 0; corner < std::size_t{1} << axes.size(); ++corner) {
        double weight = 1.0;
        auto point = cell;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const bool isUpper = (corner >> i & 1U) != 0;
            weight *= isUpper ? fraction[i] : 1.0 - fraction[i];
            point[i] += isUpper ? 1 : 0;
        }
        sum += weight * valueAt(table, point);
    }
    return sum;
}

template <typename Visit> void forEachPoint(const Grid& grid, Visit visit)
{
    std::array<std::size_t, 3> size{1, 1, 1};
    for (std::size_t i = 0; i < grid.axes.size(); ++i)
        size[i] = grid.axes[i].size;
    for (std::size_t z = 0; z < size[2]; ++z) {
        for (std::size_t y = 0; y < size[1]; ++y) {
            for (std::size_t x = 0; x < size[0]; ++x)
                visit(std::array{x, y, z});
        }
    }
}

inline Positions positionsOf(const Grid& grid, const std::array<std::size_t, 3>& point)
{
    Positions positions{};
    for (std::size_t i = 0; i < grid.axes.size(); ++i)
        positions[i] = grid.axes[i].position(point[i]);
    return positions;
}

} // namespace axiscomp::test
