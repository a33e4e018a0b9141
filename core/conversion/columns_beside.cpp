// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/columns_beside.h"

#include "core/neutral/controller_lookup.h"
#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace axiscomp {

namespace {

bool correctSame(const NeutralTable& a, const CompensationColumn& columnA, const NeutralTable& b,
    const CompensationColumn& columnB)
{
    const auto own = ownAxis(a, columnA);
    return own && own == ownAxis(b, columnB)
        && sharesDirection(columnA.direction, columnB.direction);
}

/// How many columns correct what this one does.
std::ptrdiff_t countOfSame(
    const NeutralTable& table, const NeutralTable& other, const CompensationColumn& column)
{
    return std::ranges::count_if(table.columns, [&](const CompensationColumn& candidate) {
        return correctSame(table, candidate, other, column);
    });
}

/// The values of the first column of a lookup at the points of another table.
std::vector<double> valuesAtKnots(
    const NeutralTable& beside, const ControllerLookup& lookup, const NeutralTable& held)
{
    std::vector<double> factors;
    for (std::size_t n = 0; n < held.axes.size(); ++n)
        factors.push_back(unitFactor(held.axes[n].unit, beside.axes[n].unit).value_or(1.0));
    std::vector<double> values(held.pointCount());
    for (std::size_t point = 0; point < values.size(); ++point) {
        Position position = knotPosition(held, point);
        for (std::size_t n = 0; n < factors.size(); ++n)
            position[n] *= factors[n];
        values[point] = lookup.at(std::span(position).first(factors.size()));
    }
    return values;
}

} // namespace

NeutralTable movingBeside(NeutralTable beside, const NeutralTable& table)
{
    std::vector<CompensationColumn> moving;
    for (const CompensationColumn& column : beside.columns)
        if (countOfSame(table, beside, column) == 0 && countOfSame(beside, beside, column) == 1)
            moving.push_back(column);
    beside.columns = std::move(moving);
    return beside;
}

void appendColumns(NeutralTable& table, const NeutralTable& beside)
{
    table.columns.insert(table.columns.end(), beside.columns.begin(), beside.columns.end());
}

NeutralTable takeColumns(NeutralTable& table, std::size_t first)
{
    NeutralTable taken{table.name, table.axes, {}, table.sign, {}};
    const auto begin = table.columns.begin() + static_cast<std::ptrdiff_t>(first);
    std::move(begin, table.columns.end(), std::back_inserter(taken.columns));
    table.columns.erase(begin, table.columns.end());
    return taken;
}

void appendBeside(NeutralTable& held, NeutralTable beside)
{
    for (std::size_t n = 0; n < held.axes.size(); ++n)
        if (const auto& wrap = held.axes[n].wrap; wrap && !beside.axes[n].wrap)
            beside.axes[n].wrap =
                *wrap * unitFactor(held.axes[n].unit, beside.axes[n].unit).value_or(1.0);
    std::erase_if(held.columns,
        [&](const CompensationColumn& column) { return countOfSame(beside, held, column) > 0; });
    for (std::size_t n = 0; n < beside.columns.size(); ++n) {
        CompensationColumn column = beside.columns[n];
        column.target = sourceTarget(*ownAxis(beside, column));
        column.values =
            valuesAtKnots(beside, ControllerLookup(beside, n, {.outside = Outside::Hold}), held);
        held.columns.push_back(std::move(column));
    }
}

} // namespace axiscomp
