// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"
#include "core/table/compensation_table.h"

namespace axiscomp {

/// What a controller would apply with a table of the drive that was converted for it, at the
/// table's points and some beyond both ends, where controllers differ most. With the controller's
/// sign. The format can hold the table's dimensions. Errors: SignNotConvertible.
[[nodiscard]] Result<CompensationTable> tableAsAppliedBy(
    const CompensationTable& table, const FormatFacts& facts);

/// The controllers that can have tables of so many dimensions, one format of each.
[[nodiscard]] std::vector<const TableFormat*> controllersFor(int dimensions);

} // namespace axiscomp
