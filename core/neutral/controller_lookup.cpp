// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/controller_lookup.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace axiscomp {

ControllerLookup::ControllerLookup(
    const NeutralTable& table, std::size_t column, const TableBehaviour& behaviour)
    : m_values(table.columns[column].values)
    , m_behaviour(behaviour)
{
    assert(!table.axes.empty() && table.axes.size() <= 3);
    assert(m_values.size() == table.pointCount());
    std::size_t stride = 1;
    for (const SourceAxis& axis : table.axes) {
        m_axes.push_back({axis, KnotSearch(axis.knots), stride,
            InsideRange(axis.knots.front(), axis.knots.back())});
        stride *= axis.knots.size();
    }
}

ControllerLookup::Place ControllerLookup::placeOf(std::size_t axis, double position) const
{
    const SourceAxis& source = m_axes[axis].source;
    const std::vector<double>& knots = source.knots;
    if (std::isnan(position))
        return {0, position, false};
    if (source.wrap && std::isfinite(position))
        position -= std::floor((position - knots.front()) / *source.wrap) * *source.wrap;
    const bool isOutside = !m_axes[axis].inside.contains(position);
    const bool isBefore = isOutside && position < knots.front();
    if ((isBefore && m_behaviour.startsAtFirst)
        || (isOutside && m_behaviour.outside == Outside::Zero))
        return {0, 0.0, true};
    const bool goesOn = isOutside && m_behaviour.outside == Outside::Extrapolate && !source.wrap;
    if (position <= knots.front() && !goesOn)
        return {0, 0.0, false};
    if (position >= knots.back() && !goesOn)
        return {knots.size() - 1, 0.0, false};
    const std::size_t above = m_axes[axis].search.firstAbove(position);
    const std::size_t knot = std::clamp<std::size_t>(above, 1, knots.size() - 1) - 1;
    return {knot, (position - knots[knot]) / (knots[knot + 1] - knots[knot]), false};
}

ControllerLookup::Line ControllerLookup::along(
    std::size_t axis, std::span<const double> position) const
{
    assert(position.size() == m_axes.size());
    Line line(*this, axis);
    for (std::size_t n = 0; n < m_axes.size(); ++n) {
        if (n == axis)
            continue;
        const Place place = placeOf(n, position[n]);
        line.m_isNoNumber = line.m_isNoNumber || std::isnan(place.fraction);
        line.m_appliesNothing = line.m_appliesNothing || place.appliesNothing;
        const std::size_t stride = m_axes[n].stride;
        for (std::size_t i = line.m_rowCount; i-- > 0;) {
            Line::Row& row = line.m_rows[i];
            row.offset += place.knot * stride;
            if (place.fraction == 0.0) // there may be no next knot
                continue;
            line.m_rows[line.m_rowCount++] = {row.offset + stride, row.weight * place.fraction};
            row.weight *= 1.0 - place.fraction;
        }
    }
    return line;
}

void ControllerLookup::Line::workOut()
{
    std::vector<double> values(m_lookup.m_axes[m_axis].source.knots.size());
    for (std::size_t knot = 0; knot < values.size(); ++knot)
        values[knot] = mixedAt(knot);
    m_values = std::move(values);
}

} // namespace axiscomp
