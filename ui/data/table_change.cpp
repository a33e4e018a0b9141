// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/table_change.h"

#include "core/table/lookup.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace axiscomp::ui {

namespace {

using SharedTable = std::shared_ptr<const CompensationTable>;

constexpr std::size_t cutDimension = 2;

/// The points of one of the two where they are the same; otherwise as many as a small picture can
/// show, over both.
GridAxis covering(const GridAxis& one, const GridAxis& other)
{
    if (one.start == other.start && one.distance == other.distance && one.size == other.size)
        return one;
    constexpr std::uint32_t size = 129;
    GridAxis axis = one;
    axis.start = std::min(one.start, other.start);
    axis.size = size;
    axis.distance = (std::max(one.last(), other.last()) - axis.start) / (size - 1);
    return axis;
}

TablePicture pictureOf(const SharedTable& table, std::optional<double> cutAt)
{
    if (!table)
        return {};
    TablePicture picture{table, std::nullopt, table->grid, largestChange(*table, nullptr)};
    if (table->grid.dimensions() == 3) {
        const GridAxis& axis = table->grid.axes[cutDimension];
        const std::size_t index = cutAt ? nearestIndex(axis, *cutAt) : axis.size / 2;
        picture.drawn =
            std::make_shared<const CompensationTable>(tableSlice(*table, cutDimension, index));
        picture.cutAt = axis.position(index);
    }
    return picture;
}

TablePicture differenceOf(const CompensationTable& newTable, const CompensationTable& oldTable,
    std::optional<double> cutAt, TableSources sources)
{
    const LargestChange largest = largestChange(newTable, &oldTable, sources);
    if (largest.isBound)
        return {nullptr, std::nullopt, newTable.grid, largest};
    CompensationTable drawn;
    drawn.unit = newTable.unit;
    const std::size_t dimensions = newTable.grid.axes.size();
    for (std::size_t n = 0; n < std::min(dimensions, cutDimension); ++n)
        drawn.grid.axes.push_back(covering(newTable.grid.axes[n], oldTable.grid.axes[n]));
    const Lookup now(newTable);
    const Lookup before(oldTable);
    const std::size_t rows = dimensions > 1 ? drawn.grid.axes[1].size : 1;
    drawn.values.reserve(drawn.grid.pointCount());
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < drawn.grid.axes[0].size; ++i) {
            const std::array<double, 3> place{drawn.grid.axes[0].position(i),
                dimensions > 1 ? drawn.grid.axes[1].position(j) : 0.0, cutAt.value_or(0.0)};
            const auto used = std::span(place).first(dimensions);
            drawn.values.push_back(static_cast<float>(now.at(used) - before.at(used)));
        }
    }
    return {
        std::make_shared<const CompensationTable>(std::move(drawn)), cutAt, newTable.grid, largest};
}

} // namespace

double TableChange::scale() const
{
    return std::max(std::abs(before.largest.change), std::abs(after.largest.change));
}

TableChange tableChange(
    const SharedTable& newTable, const SharedTable& oldTable, TableSources sources)
{
    TableChange change;
    change.after = pictureOf(newTable, std::nullopt);
    change.before = pictureOf(oldTable, change.after.cutAt);
    if (!newTable || !oldTable)
        return change;
    change.difference = differenceOf(*newTable, *oldTable, change.after.cutAt, sources);
    return change;
}

} // namespace axiscomp::ui
