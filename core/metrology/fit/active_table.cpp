// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/fit_parts.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <string>

namespace axiscomp {

namespace {

std::string listOf(std::span<const std::string> axes)
{
    std::string list;
    for (const std::string& axis : axes)
        list += (list.empty() ? "" : ", ") + axis;
    return list;
}

/// Of those that were active the one whose CRC is on record, else the one for the axis itself;
/// null: nothing was. Errors: those of tableOfAxis.
Result<const CompensationTable*> chosenTable(const FitInput& input)
{
    if (!input.state.active)
        return nullptr;
    const KnownTables& known = *input.state.active;
    if (input.state.tableCrc)
        if (const CompensationTable* const table = known.withCrc(*input.state.tableCrc))
            return table;
    AXISCOMP_TRY(const std::size_t own, tableOfAxis(known, input.axis()));
    return &known.tables[own];
}

} // namespace

Result<void> checkTableOver(
    const Text& name, const CompensationTable& table, std::span<const std::string> axes)
{
    std::vector<std::string> own;
    bool isOther = false;
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n) {
        own.push_back(table.grid.axes[n].name);
        isOther = isOther
            || (n < axes.size() && areDifferentAxes(axisInHeader(own[n]), axisInHeader(axes[n])));
    }
    if (!isOther)
        return {};
    return badFit(AXISCOMP_TEXT("Error",
        "{name} is a table over {axes}, but what was measured is over {measured}: take a table "
        "over the same axes, in the same order")
                      .with("name", name)
                      .with("axes", listOf(own))
                      .with("measured", listOf(axes)));
}

Result<void> checkTableOfAxis(
    const Text& name, const CompensationTable& table, const FitInput& input)
{
    if (table.grid.axes.size() != 1)
        return badFit(AXISCOMP_TEXT("Error",
            "what was measured along one axis needs a table of one dimension; {name} has "
            "{dimensions}")
                          .with("name", name)
                          .with("dimensions", table.grid.dimensions()));
    const std::string& measured = input.measurement.header.axis;
    AXISCOMP_CHECK(checkTableOver(name, table, {&measured, 1}));
    const std::string corrected = targetName(table);
    if (areDifferentAxes(corrected, input.axis()))
        return badFit(AXISCOMP_TEXT("Error",
            "axis {measured} was measured, but {name} is of axis {axis}: take the table of the "
            "axis that was measured")
                          .with("measured", input.axis())
                          .with("name", name)
                          .with("axis", corrected));
    if (table.target == otherAxis && input.state.axis.empty() && !measured.empty())
        return badFit(AXISCOMP_TEXT("Error",
            "axis {measured} was measured, but {name} corrects an axis that is no source: take the "
            "table of the axis that was measured, or state what the values correct (--target "
            "other)")
                          .with("measured", measured)
                          .with("name", name));
    return {};
}

Result<const CompensationTable*> findActiveTable(const FitInput& input)
{
    AXISCOMP_TRY(const CompensationTable* const active, chosenTable(input));
    if (active)
        AXISCOMP_CHECK(checkTableOfAxis(input.state.active->name, *active, input));
    return active;
}

AxisNames axisNames(const FitInput& input, const CompensationTable* old)
{
    const std::string& axis = input.measurement.header.axis;
    const std::string& stated = input.state.axis;
    const std::string open = old ? old->grid.axes.front().name : std::string();
    const std::string positions = !axis.empty() ? axis : open.empty() ? "Position" : open;
    if (correctsAnotherAxis(stated, axis)) {
        const std::string_view letter = axisInHeader(stated);
        const bool isNamed = stated != otherAxis && !letter.empty();
        return {positions, isNamed ? "d" + std::string(letter) : "Error", stated};
    }
    if (!axis.empty())
        return {axis, "d" + axis, axis};
    return {positions, "Error", old ? old->target : std::string()};
}

bool correctsAnother(const FitInput& input)
{
    if (input.state.kind == FoundState::Kind::Irrelevant)
        return false;
    const AxisNames names = axisNames(input, findActiveTable(input).value_or(nullptr));
    return correctsAnotherAxis(names.target, names.positions);
}

} // namespace axiscomp
