// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid.h"

#include <optional>

namespace axiscomp {

/// selected - drive at the selected table's points; the drive's table is looked up there (ends
/// held). None when the two have different dimensions.
[[nodiscard]] std::optional<CompensationTable> tableDifference(
    const CompensationTable& selected, const CompensationTable& onDrive);

/// A 3D table cut at one index of one dimension (0, 1, 2): a 2D table over the other two, in order.
[[nodiscard]] CompensationTable tableSlice(
    const CompensationTable& table, std::size_t dimension, std::size_t index);

/// The index of the grid point nearest to a position, held at the ends.
[[nodiscard]] std::size_t nearestIndex(const GridAxis& axis, double position);

} // namespace axiscomp
