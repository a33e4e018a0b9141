// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/tam_table.h"

#include <array>

namespace axiscomp::test {

inline CompensationTable tamSample(int dimensions)
{
    const std::array<GridAxis, 3> axes{GridAxis{{}, {}, -10.5, 0.25, 3},
        GridAxis{{}, {}, 100.0, 2.0, 4}, GridAxis{{}, {}, 0.1, 0.1, 5}};
    CompensationTable table;
    table.name = "X axis";
    table.grid.axes.assign(axes.begin(), axes.begin() + dimensions);
    for (std::size_t i = 0; i < table.grid.pointCount(); ++i)
        table.values.push_back(static_cast<float>(i) * 0.125F - 3.0F);
    return table;
}

inline Bytes encoded(const CompensationTable& table,
    const TableLayout& layout = genericTableLayout(), bool persistent = false)
{
    const auto file = encodeTamTable(table, persistent, layout);
    return file.value_or(Bytes{});
}

/// No more than the mandatory fields.
inline TableLayout smallLayout()
{
    TableLayout layout;
    layout.place(TableField::Size) = FieldPlace{0, FieldType::U16, 3};
    layout.place(TableField::Start) = FieldPlace{6, FieldType::F32, 3};
    layout.headerSize = 30;
    layout.place(TableField::Distance) = FieldPlace{18, FieldType::F32, 3};
    return layout;
}

} // namespace axiscomp::test
