// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/data/table_view_model.h"

#include <cmath>
#include <vector>

namespace axiscomp::test {

/// Axes X, Y, Z in mm that begin at 0, 100, 200; each value is its own, from -3 to 3 um.
inline CompensationTable namedTable(const std::vector<std::uint32_t>& sizes, double phase = 0.0)
{
    CompensationTable table;
    table.name = "table";
    table.unit = "mm";
    const char* names[] = {"X", "Y", "Z"};
    for (std::size_t n = 0; n < sizes.size(); ++n)
        table.grid.axes.push_back({.name = names[n],
            .unit = "mm",
            .start = 100.0 * static_cast<double>(n),
            .distance = 2.5,
            .size = sizes[n]});
    table.values.resize(table.grid.pointCount());
    for (std::size_t i = 0; i < table.values.size(); ++i)
        table.values[i] =
            static_cast<float>(0.003 * std::sin(0.7 * static_cast<double>(i) + phase));
    return table;
}

inline ui::TableViewModel::Table sharedTable(
    const std::vector<std::uint32_t>& sizes, double phase = 0.0)
{
    return std::make_shared<const CompensationTable>(namedTable(sizes, phase));
}

} // namespace axiscomp::test
