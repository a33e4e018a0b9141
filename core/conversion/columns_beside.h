// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/neutral/neutral_table.h"

namespace axiscomp {

// One column of a file is converted with the others that move the place where it is looked up
// (sourcesBeside), as the whole file would be, and they are left out of what is written.

/// Of the columns beside a table those that move an axis in a direction of motion that no other
/// column of both corrects: of two that stand for a choice nobody knows which is in use.
[[nodiscard]] NeutralTable movingBeside(NeutralTable beside, const NeutralTable& table);

/// Adds columns over the same knots.
void appendColumns(NeutralTable& table, const NeutralTable& beside);
/// Takes the columns from a number on out of a table.
[[nodiscard]] NeutralTable takeColumns(NeutralTable& table, std::size_t first);

/// Adds the columns beside a table to what a file holds of it, at the knots of the file, whose axes
/// may have other names and units. They take the place of columns that the file had to be given for
/// these axes.
void appendBeside(NeutralTable& held, NeutralTable beside);

} // namespace axiscomp
