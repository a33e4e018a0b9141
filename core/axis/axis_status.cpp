// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/axis_status.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

TableIdentity identityOf(const TableHeader& table)
{
    const bool isShown = std::ranges::all_of(table.grid.axes, [](const GridAxis& axis) {
        return std::isfinite(axis.start) && std::isfinite(axis.distance) && axis.size > 0;
    });
    return isShown ? TableIdentity{table.crc, table.grid} : TableIdentity{table.crc};
}

TableUnits unitsOfTable(const AxisStatus& status)
{
    TableUnits units{status.axis.unit, {}};
    for (std::size_t n = 0; n < status.sourceUnits.size(); ++n)
        if (status.setup.sources[n].isSet())
            units.positions.push_back(status.sourceUnits[n]);
    return units;
}

} // namespace axiscomp
