// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <array>
#include <cstddef>
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

/// Whether a table and the one that it replaces are looked up at the same places.
enum class TableSources {
    Same,
    Other, ///< other sources, or the same ones in another order
};

/// The position at which a new table differs most from the table that it replaces.
struct LargestChange {
    double change = 0.0; ///< new - old, in the tables' unit; old is 0 without a table
    std::array<double, 3> position{}; ///< of the point, one per dimension
    /// No place changes by more, and which one changes by that much is not known: position has no
    /// meaning.
    bool isBound = false;
};

/// Over the whole travel, both tables as the drive looks them up: also where only one of them has
/// points, and the other holds its end value. oldTable: null where the axis had none. With other
/// sources, or other dimensions, any value of the one may follow any value of the other: then it is
/// a bound. Takes a while for the largest tables: not for the window's thread.
[[nodiscard]] LargestChange largestChange(const CompensationTable& newTable,
    const CompensationTable* oldTable, TableSources sources = TableSources::Same);

} // namespace axiscomp
