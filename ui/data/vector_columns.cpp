// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/vector_columns.h"

#include "core/table/position_unit.h"
#include "core/table/target_axis.h"

namespace axiscomp::ui {

VectorColumns vectorColumns(std::span<const CompensationTable> tables)
{
    VectorColumns columns;
    for (std::size_t n = 0; n < tables.size(); ++n) {
        const std::vector<GridAxis>& axes = tables[n].grid.axes;
        const auto target = targetOf(tables[n]);
        if (!target || !target->source || axes.size() < 2)
            continue;
        if (!commonUnitFactor(tables[n].unit, axes[*target->source].unit))
            continue;
        columns.ofDimension.at(*target->source).push_back(n);
    }
    return columns;
}

double positionsPerValue(const CompensationTable& table, std::size_t dimension)
{
    return commonUnitFactor(table.unit, table.grid.axes[dimension].unit).value_or(1.0);
}

} // namespace axiscomp::ui
