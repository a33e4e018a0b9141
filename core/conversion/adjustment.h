// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/neutral_table.h"

#include <vector>

namespace axiscomp {

/// How values are changed before anything else is done with them: multiplied by scale, then offset
/// added, or else shifted so that they are 0 at a position; of two directions the mean is, so that
/// the reversal stays.
struct Adjustment {
    double scale = 1.0; ///< finite, not 0
    double offset = 0.0; ///< finite, in the unit of the values
    std::vector<double> zero; ///< one position per source axis, within the table; empty: none

    friend bool operator==(const Adjustment&, const Adjustment&) = default;
};

/// Says in remarks what was done, the shift of each column included. The value at zero is
/// interpolated linearly. Errors: InvalidArgument for numbers that cannot be, for a position that
/// is outside of the table, and for zero together with an offset.
[[nodiscard]] Result<NeutralTable> adjusted(
    NeutralTable table, const Adjustment& adjustment, std::vector<Text>& remarks);

} // namespace axiscomp
