// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/table/compensation_table.h"

#include <cstddef>
#include <vector>

namespace axiscomp {

/// The steepest step between neighbouring points.
struct SteepestStep {
    double slope = 0.0; ///< >= 0
    std::size_t from = 0; ///< index of the element; `to` is the next one along the dimension
    std::size_t to = 0;
    std::size_t dimension = 0;
};

/// Values are compared with positions in one unit where both are stated, and otherwise as numbers.
/// Dimensions of another kind are left out: an angle over a length has no such slope.
[[nodiscard]] SteepestStep steepestStep(const CompensationTable& table);

/// What is so large in a table that its unit may be wrong, as sentences: a correction above 1 % of
/// the range of a dimension, and a slope above 0.1, both compared as by steepestStep(). Takes
/// milliseconds for the largest tables.
[[nodiscard]] std::vector<Text> largeCorrections(const CompensationTable& table);

} // namespace axiscomp
