// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid.h"

#include <array>
#include <memory>

namespace axiscomp {

/// The point of a new table at which it differs most from the table that it replaces.
struct LargestChange {
    double change = 0.0; ///< new - old, in the tables' unit; old is 0 without a table
    std::array<double, 3> position{}; ///< of the point, one per dimension
};

/// At the new table's points, the old table as the drive looks it up (end values held). A table of
/// other dimensions counts as none. Takes milliseconds for the largest tables: not for the window's
/// thread.
[[nodiscard]] LargestChange largestChange(
    const CompensationTable& newTable, const CompensationTable* oldTable);

} // namespace axiscomp
