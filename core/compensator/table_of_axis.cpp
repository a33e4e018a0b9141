// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/table_of_axis.h"

#include "core/drive/axis_target.h"
#include "core/drive/drive_units.h"
#include "core/table/position_unit.h"
#include "core/write/lookup_side.h"

#include <algorithm>

namespace axiscomp {

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
