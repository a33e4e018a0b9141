// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/neutral/neutral_table.h"

namespace axiscomp {

/// Columns for one axis that act at the same time where a controller adds its tables.
struct AddedColumns {
    std::string target; ///< the name of the axis; may be empty
    std::vector<Text> columns; ///< for reports: one where they are called the same, else two
};

/// Those over different sources, and those over the same ones in the same direction: each axis, and
/// each kind of column for it, once.
[[nodiscard]] std::vector<AddedColumns> addedColumns(std::span<const NeutralTable> tables);

} // namespace axiscomp
