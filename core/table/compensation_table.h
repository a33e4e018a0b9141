// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid.h"

#include <cstddef>
#include <memory>

namespace axiscomp {

/// A table, and what can only be found out by looking at all of its values: found out once, on the
/// thread that has read the table.
struct SurveyedTable {
    std::shared_ptr<const CompensationTable> table; ///< may be null
    std::size_t largestElement = 0; ///< index of the largest |value|, the first of several
};

[[nodiscard]] SurveyedTable surveyed(std::shared_ptr<const CompensationTable> table);

} // namespace axiscomp
