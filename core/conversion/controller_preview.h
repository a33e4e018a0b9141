// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/axis_place.h"
#include "core/formats/table_format.h"
#include "core/table/compensation_table.h"

namespace axiscomp {

/// What a controller would apply with a table of the drive that was converted for it, at the
/// table's points and some beyond both ends, where controllers differ most. With the controller's
/// sign. place: its target is for a table that does not say what it corrects. The format can hold
/// the table's dimensions. Errors: TargetNotKnown, SignNotConvertible.
[[nodiscard]] Result<CompensationTable> tableAsAppliedBy(
    const CompensationTable& table, const AxisPlace& place, const FormatFacts& facts);

/// The controllers that can have tables of so many dimensions, one format of each.
[[nodiscard]] std::vector<const TableFormat*> controllersFor(int dimensions);

} // namespace axiscomp
