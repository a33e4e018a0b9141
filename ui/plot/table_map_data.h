// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <qcustomplot.h>

#include <algorithm>

namespace axiscomp::ui {

/// A table in the plot library's form. Its own way, cell by cell with checks, takes as long as
/// drawing.
class TableMapData final : public QCPColorMapData {
public:
    TableMapData(const CompensationTable& table, double largest)
        : QCPColorMapData(static_cast<int>(table.grid.axes[0].size),
            static_cast<int>(table.grid.axes[1].size),
            QCPRange(table.grid.axes[0].start, table.grid.axes[0].last()),
            QCPRange(table.grid.axes[1].start, table.grid.axes[1].last()))
    {
        std::ranges::transform(
            table.values, mData, [](float value) { return static_cast<double>(value); });
        mDataBounds = QCPRange(-largest, largest);
        mDataModified = true;
    }
};

} // namespace axiscomp::ui
