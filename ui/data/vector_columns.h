// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace axiscomp::ui {

/// Which columns of a file hold the errors of its own source axes: the X and the Y errors over X
/// and Y are a plane of vectors.
struct VectorColumns {
    std::array<std::vector<std::size_t>, 3> ofDimension; ///< columns, in their order

    [[nodiscard]] bool hasPlane(std::size_t a, std::size_t b) const
    {
        return !ofDimension.at(a).empty() && !ofDimension.at(b).empty();
    }
    [[nodiscard]] bool hasAnyPlane() const
    {
        return hasPlane(0, 1) || hasPlane(0, 2) || hasPlane(1, 2);
    }
};

/// tables: over one grid. Left out are columns that state no target (core/table/target_axis.h), and
/// those whose unit cannot be compared with the positions' unit: an angle along a length.
[[nodiscard]] VectorColumns vectorColumns(std::span<const CompensationTable> tables);

/// How many of a dimension's units one unit of the values is; 1 where one of them is not known.
[[nodiscard]] double positionsPerValue(const CompensationTable& table, std::size_t dimension);

} // namespace axiscomp::ui
