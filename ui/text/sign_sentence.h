// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "core/table/compensation_table.h"

#include <QString>

#include <cstddef>
#include <optional>

namespace axiscomp::ui {

/// Where a table is looked up, and what is known of its values.
struct SignPlace {
    std::optional<std::size_t> own = {}; ///< the dimension that is the axis's own position
    std::optional<LookupAt> lookupAt = {}; ///< on which side of the compensation that is
    bool isComputed = false; ///< as in WritePlan: what a reference said is not told
};

/// What the table does, in numbers, at its largest value: "where the encoder reads 40.0000 mm, the
/// reference reads 40.0021 mm: the drive will add +0.0021 mm". It is there so that a wrong sign,
/// unit or column is seen before it moves a machine. Positions have the file's names and units;
/// what the drive adds is in the axis's own unit. Empty: table or positions are in a unit that is
/// not the axis's, and will not be written.
[[nodiscard]] QString signSentenceFor(
    const LoadedTable& table, const AxisInfo& axis, const SignPlace& place);

} // namespace axiscomp::ui
