// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_change.h"

#include "core/table/lookup.h"

#include <cmath>
#include <optional>
#include <span>

namespace axiscomp {

namespace {

std::array<double, 3> positionOf(const Grid& grid, std::size_t element)
{
    std::array<double, 3> position{};
    for (std::size_t n = 0; n < grid.axes.size(); ++n) {
        position[n] = grid.axes[n].position(element % grid.axes[n].size);
        element /= grid.axes[n].size;
    }
    return position;
}

} // namespace

LargestChange largestChange(const CompensationTable& newTable, const CompensationTable* oldTable)
{
    std::optional<Lookup> old;
    if (oldTable && oldTable->grid.dimensions() == newTable.grid.dimensions())
        old.emplace(*oldTable);
    const std::size_t dimensions = newTable.grid.axes.size();
    LargestChange largest;
    for (std::size_t i = 0; i < newTable.values.size(); ++i) {
        const std::array<double, 3> position = positionOf(newTable.grid, i);
        const double before = old ? old->at(std::span(position).first(dimensions)) : 0.0;
        const double change = static_cast<double>(newTable.values[i]) - before;
        if (std::abs(change) > std::abs(largest.change) || i == 0)
            largest = {change, position};
    }
    return largest;
}

} // namespace axiscomp
