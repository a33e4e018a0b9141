// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/neutral_table.h"

#include <optional>
#include <span>
#include <vector>

namespace axiscomp {

/// How values are changed: multiplied by scale, then offset added, before anything else is done
/// with them, or else shifted so that they are 0 at a position once they have their directions and
/// grid.
struct Adjustment {
    double scale = 1.0; ///< finite, not 0
    double offset = 0.0; ///< finite, in the unit of the values
    std::vector<double> zero; ///< one position per source axis, within the table; empty: none

    friend bool operator==(const Adjustment&, const Adjustment&) = default;
};

/// By scale and offset; remarks say so. Errors: InvalidArgument for numbers that cannot be, and for
/// zero together with an offset.
[[nodiscard]] Result<NeutralTable> adjusted(
    NeutralTable table, const Adjustment& adjustment, std::vector<Text>& remarks);

/// Adjustment::zero in the turn of a modulo axis that its knots are in. Errors: InvalidArgument for
/// a position that is outside of the table, or of another number of axes.
[[nodiscard]] Result<std::vector<double>> zeroWithin(
    const NeutralTable& table, const Adjustment& adjustment);

/// What makes each column 0 at a position, in its unit, interpolated linearly; of two directions
/// the mean becomes 0, so that the reversal stays. Nothing: the position is outside of the table.
[[nodiscard]] std::optional<std::vector<double>> shiftsToZero(
    const NeutralTable& table, std::span<const double> position);

/// shifts: one for each column, in its unit. Says each of them in remarks.
void shiftColumns(NeutralTable& table, std::span<const double> shifts, std::vector<Text>& remarks);

} // namespace axiscomp
