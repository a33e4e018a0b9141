// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <QString>

#include <vector>

namespace axiscomp::ui {

/// A rectangle of cells as ValuesModel lays them out, both ends included.
struct CellRange {
    int top = 0;
    int left = 0;
    int bottom = 0;
    int right = 0;
};

/// What goes with the values: the names of 1D's columns, or of a map's dimensions.
struct CopyHeaders {
    QString first; ///< 1D: the position; 2D: dimension 1
    QString second; ///< 1D: the value; 2D: dimension 2
};

/// Cells as tab-separated lines for spreadsheets: decimal point, every digit the value has, an
/// empty cell where a row or column is only partly chosen. headers null: the cells alone; otherwise
/// with a line of names or positions above and the positions on the left. drawn: 1 or 2 dimensions.
/// Takes a tenth of a second for the largest tables: not for the window's thread.
[[nodiscard]] QString copiedText(const CompensationTable& drawn,
    const std::vector<CellRange>& ranges, const CopyHeaders* headers);

} // namespace axiscomp::ui
