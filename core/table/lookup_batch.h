// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid_place.h"
#include "core/table/instruction_set.h"

#include <array>
#include <cstddef>

namespace axiscomp {

/// A table for lookups at many positions; fewer than 2^31 values.
struct BatchTable {
    std::array<AxisNumbers<double>, 3> axes{};
    std::array<std::size_t, 3> strides{};
    const float* values = nullptr;
    bool holdsEnds = true; ///< outside the table; otherwise positions out there are left out
};

/// What is looked up at once.
inline constexpr std::size_t batchSize = 64;

/// Looks up batchSize positions of a table of 1 to 3 dimensions. False: where a value is no number
/// the position is outside or no number, or its point is the last one of a dimension, behind which
/// there is no cell; those are left to Lookup::at.
using BatchLookup = bool (*)(const BatchTable& table, const double* positions, double* values);

[[nodiscard]] BatchLookup batchLookup(int dimensions, InstructionSet instructions);

} // namespace axiscomp
