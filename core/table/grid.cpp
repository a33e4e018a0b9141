// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

/// NaN: a drive that does not show it.
bool isSameNumber(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

} // namespace

InsideRange::InsideRange(double first, double last)
{
    const double rounding =
        4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(first), std::abs(last));
    m_from = first - rounding;
    m_to = last + rounding;
}

bool sameSpans(const Grid& a, const Grid& b)
{
    return std::ranges::equal(a.axes, b.axes, [](const GridAxis& x, const GridAxis& y) {
        return isSameNumber(x.start, y.start) && isSameNumber(x.distance, y.distance)
            && x.size == y.size;
    });
}

bool isWithin(const Grid& grid, std::span<const double> positions)
{
    for (std::size_t n = 0; n < grid.axes.size(); ++n) {
        const GridAxis& axis = grid.axes[n];
        if (!InsideRange(axis.start, axis.last()).contains(positions[n]))
            return false;
    }
    return true;
}

std::vector<double> positionOf(const Grid& grid, std::size_t point)
{
    std::vector<double> position;
    position.reserve(grid.axes.size());
    for (const GridAxis& axis : grid.axes) {
        position.push_back(axis.position(static_cast<std::uint32_t>(point % axis.size)));
        point /= axis.size;
    }
    return position;
}

bool pointsAreDistinct(const GridAxis& axis)
{
    const double largest = std::max(std::abs(axis.start), std::abs(axis.last()));
    return std::isnormal(axis.distance)
        && axis.distance > 32.0 * std::numeric_limits<double>::epsilon() * largest;
}

} // namespace axiscomp
