// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_identity.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

bool areSamePositions(const GridAxis& a, const GridAxis& b)
{
    const double rounding = largestPointShift * std::min(a.distance, b.distance);
    return a.size == b.size && std::abs(a.start - b.start) <= rounding
        && std::abs(a.last() - b.last()) <= rounding;
}

bool isSameTable(const TableIdentity& a, const TableIdentity& b)
{
    if (a.crc != b.crc)
        return false;
    return !a.grid || !b.grid || std::ranges::equal(a.grid->axes, b.grid->axes, areSamePositions);
}

} // namespace axiscomp
