// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/controller_lookup.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

double wrapped(const SourceAxis& axis, double position)
{
    const double first = axis.knots.front();
    const double turns = std::floor((position - first) / *axis.wrap);
    return position - turns * *axis.wrap;
}

} // namespace

ControllerLookup::ControllerLookup(
    const NeutralTable& table, std::size_t column, const TableBehaviour& behaviour)
    : m_table(table)
    , m_column(table.columns[column])
    , m_behaviour(behaviour)
{
    assert(!table.axes.empty() && table.axes.size() <= 3);
    assert(m_column.values.size() == table.pointCount());
}

ControllerLookup::Place ControllerLookup::placeOf(std::size_t axis, double position) const
{
    const std::vector<double>& knots = m_table.axes[axis].knots;
    if (m_behaviour.outside == Outside::Extrapolate && !m_table.axes[axis].wrap) {
        const auto behind = std::upper_bound(knots.begin() + 1, knots.end() - 1, position);
        const auto knot = static_cast<std::size_t>(behind - knots.begin()) - 1;
        return {knot, (position - knots[knot]) / (knots[knot + 1] - knots[knot])};
    }
    if (position <= knots.front())
        return {0, 0.0};
    if (position >= knots.back())
        return {knots.size() - 1, 0.0};
    const auto above = std::ranges::upper_bound(knots, position);
    const auto knot = static_cast<std::size_t>(above - knots.begin()) - 1;
    return {knot, (position - knots[knot]) / (knots[knot + 1] - knots[knot])};
}

double ControllerLookup::valueAt(std::size_t index) const
{
    const double value = m_column.values[index];
    return m_behaviour.usesFloat ? static_cast<double>(static_cast<float>(value)) : value;
}

double ControllerLookup::at(std::span<const double> position) const
{
    assert(position.size() == m_table.axes.size());
    std::array<Place, 3> places;
    for (std::size_t n = 0; n < position.size(); ++n) {
        const SourceAxis& axis = m_table.axes[n];
        if (std::isnan(position[n]))
            return std::numeric_limits<double>::quiet_NaN();
        const bool wraps = axis.wrap.has_value() && std::isfinite(position[n]);
        const double x = wraps ? wrapped(axis, position[n]) : position[n];
        const bool isBefore = x < axis.knots.front();
        const bool isOutside = isBefore || x > axis.knots.back();
        if ((isBefore && m_behaviour.startsAtFirst)
            || (isOutside && m_behaviour.outside == Outside::Zero))
            return 0.0;
        places[n] = placeOf(n, x);
    }
    // The corners of the cell, dimension by dimension; a corner without weight may not exist.
    double sum = 0.0;
    const std::size_t corners = std::size_t{1} << position.size();
    for (std::size_t corner = 0; corner < corners; ++corner) {
        double weight = 1.0;
        std::size_t index = 0;
        std::size_t stride = 1;
        for (std::size_t n = 0; n < position.size(); ++n) {
            const bool isUpper = ((corner >> n) & 1U) != 0;
            weight *= isUpper ? places[n].fraction : 1.0 - places[n].fraction;
            index += stride * (places[n].knot + (isUpper ? 1 : 0));
            stride *= m_table.axes[n].knots.size();
        }
        if (weight != 0.0)
            sum += weight * valueAt(index);
    }
    return sum;
}

} // namespace axiscomp
