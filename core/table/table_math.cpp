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
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

/// The positions of a row along dimension 1, as Lookup::atEach takes them.
class RowPositions {
public:
    RowPositions(const std::vector<double>& along, std::size_t dimensions)
        : m_positions(along.size() * dimensions)
        , m_dimensions(dimensions)
    {
        for (std::size_t i = 0; i < along.size(); ++i)
            m_positions[i * dimensions] = along[i];
    }
    /// The position of the whole row in another dimension, 1 or 2; of one that the table lacks,
    /// nothing happens.
    void set(std::size_t dimension, double position)
    {
        for (std::size_t i = dimension; dimension < m_dimensions && i < m_positions.size();
             i += m_dimensions)
            m_positions[i] = position;
    }
    [[nodiscard]] std::span<const double> positions() const { return m_positions; }

private:
    std::vector<double> m_positions;
    std::size_t m_dimensions;
};

/// Each place of the one table may be met at any place of the other.
LargestChange changeBound(const CompensationTable& newTable, const CompensationTable& oldTable)
{
    const TableStatistics now = statistics(newTable);
    const TableStatistics before = statistics(oldTable);
    const double highest = now.maximum - before.minimum;
    const double lowest = now.minimum - before.maximum;
    return {std::abs(lowest) > std::abs(highest) ? lowest : highest, {}, true};
}

} // namespace

std::optional<CompensationTable> tableDifference(
    const CompensationTable& selected, const CompensationTable& onDrive)
{
    if (selected.grid.dimensions() != onDrive.grid.dimensions())
        return std::nullopt;
    const Lookup lookup(onDrive);
    CompensationTable difference = selected;
    const std::vector<GridAxis>& axes = selected.grid.axes;
    std::vector<double> along(axes[0].size);
    for (std::size_t i = 0; i < along.size(); ++i)
        along[i] = axes[0].position(i);
    RowPositions row(along, axes.size());
    std::vector<double> before(along.size());
    for (std::size_t begin = 0; begin < difference.values.size(); begin += along.size()) {
        std::size_t rest = begin / along.size();
        for (std::size_t n = 1; n < axes.size(); ++n) {
            row.set(n, axes[n].position(rest % axes[n].size));
            rest /= axes[n].size;
        }
        lookup.atEach(row.positions(), before);
        for (std::size_t i = 0; i < before.size(); ++i) {
            float& value = difference.values[begin + i];
            value = static_cast<float>(static_cast<double>(value) - before[i]);
        }
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

LargestChange largestChange(
    const CompensationTable& newTable, const CompensationTable* oldTable, TableSources sources)
{
    const std::size_t dimensions = newTable.grid.axes.size();
    if (oldTable && (sources == TableSources::Other || oldTable->grid.axes.size() != dimensions))
        return changeBound(newTable, *oldTable);
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
    RowPositions row(places[0], dimensions);
    std::vector<double> changes(places[0].size());
    std::vector<double> old(places[0].size());
    for (const double z : places[2])
        for (const double y : places[1]) {
            row.set(1, y);
            row.set(2, z);
            now.atEach(row.positions(), changes);
            if (before)
                before->atEach(row.positions(), old);
            for (std::size_t i = 0; i < changes.size(); ++i) {
                const double change = changes[i] - old[i];
                if (isFirst || std::abs(change) > std::abs(largest.change))
                    largest = {change, {places[0][i], y, z}, false};
                isFirst = false;
            }
        }
    return largest;
}

} // namespace axiscomp
