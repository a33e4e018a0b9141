// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/neutral/neutral_table.h"
#include "core/table/lookup.h"

#include <span>

namespace axiscomp {

/// What a controller makes of a table: the same numbers mean different corrections.
struct TableBehaviour {
    /// Hold, Zero or Extrapolate: dimension by dimension the first and the last cell go on. An axis
    /// with a wrap period wraps first, and is held where it has no knots.
    Outside outside = Outside::Hold;
    bool startsAtFirst = false; ///< nothing until every source has reached its first value
    bool usesFloat = false; ///< values are float32 in the controller
};

/// A column of a table as a controller applies it: linear between the knots of each axis.
/// Refers to the table, which must outlive it.
class ControllerLookup {
public:
    /// column: index of a column of the table, which is consistent.
    ControllerLookup(
        const NeutralTable& table, std::size_t column, const TableBehaviour& behaviour);

    /// position: one number for each source axis, in the units of the axes. The value is in the
    /// unit of the column. A NaN gives NaN; with Extrapolate, so may an infinite position.
    [[nodiscard]] double at(std::span<const double> position) const;

private:
    struct Place {
        std::size_t knot = 0;
        double fraction = 0.0;
    };
    [[nodiscard]] Place placeOf(std::size_t axis, double position) const;
    [[nodiscard]] double valueAt(std::size_t index) const;

    const NeutralTable& m_table;
    const CompensationColumn& m_column;
    TableBehaviour m_behaviour;
};

} // namespace axiscomp
