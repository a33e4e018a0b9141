// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_math.h"

#include "core/table/lookup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace axiscomp {

namespace {

std::vector<double> pointsOfBoth(const GridAxis& one, const GridAxis* other)
{
    std::vector<double> points;
    for (const GridAxis* axis : {&one, other})
        for (std::size_t i = 0; axis && i < axis->size; ++i)
            points.push_back(axis->position(i));
    std::ranges::sort(points);
    const auto repeated = std::ranges::unique(points);
    points.erase(repeated.begin(), repeated.end());
    return points;
}

} // namespace

std::optional<CompensationTable> tableDifference(
    const CompensationTable& selected, const CompensationTable& onDrive)
{
    if (selected.grid.dimensions() != onDrive.grid.dimensions())
        return std::nullopt;
    const Lookup lookup(onDrive);
    CompensationTable difference = selected;
    const std::size_t dimensions = selected.grid.axes.size();
    std::array<std::size_t, 3> index{};
    std::array<double, 3> position{};
    for (float& value : difference.values) {
        for (std::size_t n = 0; n < dimensions; ++n)
            position[n] = selected.grid.axes[n].position(index[n]);
        const double before = lookup.at(std::span<const double>(position.data(), dimensions));
        value = static_cast<float>(static_cast<double>(value) - before);
        for (std::size_t n = 0; n < dimensions && ++index[n] == selected.grid.axes[n].size; ++n)
            index[n] = 0;
    }
    return difference;
}

CompensationTable tableSlice(
    const CompensationTable& table, std::size_t dimension, std::size_t index)
{
    CompensationTable slice;
    slice.name = table.name;
    slice.unit = table.unit;
    std::array<std::size_t, 3> strides{
        1, table.grid.axes[0].size, std::size_t{table.grid.axes[0].size} * table.grid.axes[1].size};
    std::array<std::size_t, 2> kept{};
    for (std::size_t n = 0, next = 0; n < 3; ++n) {
        if (n == dimension)
            continue;
        kept[next++] = n;
        slice.grid.axes.push_back(table.grid.axes[n]);
    }
    slice.values.reserve(slice.grid.pointCount());
    for (std::size_t j = 0; j < slice.grid.axes[1].size; ++j) {
        for (std::size_t i = 0; i < slice.grid.axes[0].size; ++i) {
            const std::size_t point =
                index * strides[dimension] + i * strides[kept[0]] + j * strides[kept[1]];
            if (std::ranges::binary_search(table.filled, point))
                slice.filled.push_back(static_cast<std::uint32_t>(slice.values.size()));
            slice.values.push_back(table.values[point]);
        }
    }
    return slice;
}

std::size_t nearestIndex(const GridAxis& axis, double position)
{
    const double index = std::round((position - axis.start) / axis.distance);
    return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(axis.size - 1)));
}

LargestChange largestChange(const CompensationTable& newTable, const CompensationTable* oldTable)
{
    const std::size_t dimensions = newTable.grid.axes.size();
    if (oldTable && oldTable->grid.axes.size() != dimensions)
        oldTable = nullptr;
    const Lookup now(newTable);
    const std::optional<Lookup> before = oldTable ? std::optional<Lookup>(*oldTable) : std::nullopt;
    // Between the points of both tables the difference is linear along each dimension, and beyond
    // all of them it is held: it is largest at one of them.
    std::array<std::vector<double>, 3> places{{{0.0}, {0.0}, {0.0}}};
    for (std::size_t n = 0; n < dimensions; ++n)
        places[n] =
            pointsOfBoth(newTable.grid.axes[n], oldTable ? &oldTable->grid.axes[n] : nullptr);
    LargestChange largest;
    bool isFirst = true;
    for (const double z : places[2])
        for (const double y : places[1])
            for (const double x : places[0]) {
                const std::array<double, 3> position{x, y, z};
                const auto used = std::span(position).first(dimensions);
                const double change = now.at(used) - (before ? before->at(used) : 0.0);
                if (isFirst || std::abs(change) > std::abs(largest.change))
                    largest = {change, position};
                isFirst = false;
            }
    return largest;
}

} // namespace axiscomp
