// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/table_of_axis.h"

#include "core/drive/axis_target.h"
#include "core/drive/drive_units.h"
#include "core/table/position_unit.h"
#include "core/table/target_axis.h"
#include "core/text/token_scanner.h"
#include "core/write/lookup_side.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// A name that headers and targets of files take for that of an axis.
bool isNameInFiles(std::string_view name)
{
    return !name.empty() && axisInHeader(name) == name;
}

bool hasAxisNamed(const Grid& grid, std::string_view name)
{
    return std::ranges::any_of(
        grid.axes, [&](const GridAxis& axis) { return sameLetters(axis.name, name); });
}

/// By the axes whose positions the sources are, so that a file of the table is for this axis and
/// for no other.
void nameAxes(CompensationTable& table, const AxisStatus& status, std::span<const AxisInfo> axes,
    const DriveProfile& profile)
{
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n) {
        const auto owner = profile.axisOfPosition(status.setup.sources[n].path);
        const auto found = owner ? std::ranges::find(axes, *owner, &AxisInfo::index) : axes.end();
        GridAxis& axis = table.grid.axes[n];
        if (found != axes.end() && axis.name.empty() && isNameInFiles(found->name)
            && !hasAxisNamed(table.grid, found->name))
            axis.name = found->name;
    }
    const std::string& own = status.axis.name;
    const auto target = targetOf(table);
    if (!target || !isNameInFiles(own))
        return;
    const bool isSource = target->source && table.grid.axes[*target->source].name == own;
    const bool isOther = !target->source && !hasAxisNamed(table.grid, own)
        && std::ranges::all_of(table.grid.axes, isNameInFiles, &GridAxis::name);
    if (isSource || isOther)
        table.target = own;
}

} // namespace

void describeTable(CompensationTable& table, const AxisStatus& status,
    std::span<const AxisInfo> axes, const DriveProfile& profile)
{
    const std::span sources =
        std::span(status.setup.sources).first(static_cast<std::size_t>(table.grid.dimensions()));
    const auto unitOf = [&](int axis) -> Result<std::string> {
        const auto found = std::ranges::find(axes, axis, &AxisInfo::index);
        return found == axes.end() || !isPositionUnit(found->unit) ? std::string()
                                                                   : unitSymbol(found->unit);
    };
    const TableUnits units =
        driveUnits(profile, sources, status.axis.index, unitOf).value_or(TableUnits{});
    table.unit = units.values;
    for (std::size_t n = 0; n < units.positions.size(); ++n)
        table.grid.axes[n].unit = units.positions[n];
    if (std::ranges::all_of(sources, &DimSource::isSet))
        table.target = axisTarget(profile, status.axis.index, sourcePaths(status.setup));
    nameAxes(table, status, axes, profile);
}

void nameParts(CompensationTable& table)
{
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n)
        if (table.grid.axes[n].name.empty())
            table.grid.axes[n].name = "Dim " + std::to_string(n + 1);
    if (table.name.empty())
        table.name = "Table";
}

std::vector<std::string> lookupNotes(const AxisStatus& status, const DriveProfile& profile)
{
    return withLookupNote(
        {}, lookupAtSources(profile, status.axis.index, sourcePaths(status.setup)));
}

} // namespace axiscomp
