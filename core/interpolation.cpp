// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/interpolation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace axiscomp {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// value, held between low and high; NaN stays NaN. The order of the comparisons lets the compiler
/// use one minimum and one maximum instruction.
double held(double low, double value, double high)
{
    const double above = low > value ? low : value;
    return high < above ? high : above;
}

/// Exactly from at fraction 0, and exactly constant between equal values.
double mixed(double from, double to, double fraction)
{
    return from + fraction * (to - from);
}

} // namespace

Lookup::Lookup(const CompensationTable& table, Outside outside)
    : m_values(table.values.data())
    , m_dimensions(table.grid.dimensions())
    , m_outside(outside)
{
    assert(m_dimensions >= 1 && m_dimensions <= 3);
    assert(table.values.size() == table.grid.pointCount());
    std::size_t stride = 1;
    for (std::size_t i = 0; i < table.grid.axes.size(); ++i) {
        const GridAxis& axis = table.grid.axes[i];
        assert(axis.size >= 2 && axis.distance > 0.0);
        // the reciprocal of a denormal distance would be infinite and turn 0 into NaN
        const double perUnit = std::min(1.0 / axis.distance, std::numeric_limits<double>::max());
        m_axes[i] = {axis.start, axis.last(), axis.distance, perUnit,
            static_cast<double>(axis.size - 1), stride};
        stride *= axis.size;
    }
}

/// The grid point next to a position between start and last, 0 .. size - 1 whatever the position
/// is.
inline double Lookup::nearestIndex(const Axis& axis, double position)
{
    const double index = (position - axis.start) * axis.perUnit + 0.5;
    const double limited = index < axis.lastIndex ? index : axis.lastIndex; // NaN: lastIndex
    return static_cast<double>(static_cast<std::int64_t>(limited));
}

/// The way is measured from the nearest grid point, whose position is computed as GridAxis does: at
/// a grid point it is exactly 0 and the value exactly the table's.
inline Lookup::Cell Lookup::heldCell(const Axis& axis, double position)
{
    const double within = held(axis.start, position, axis.last);
    const double nearest = nearestIndex(axis, within);
    const double way = (within - (axis.start + nearest * axis.distance)) * axis.perUnit;
    const auto isBefore = static_cast<std::int64_t>(way < 0.0);
    const std::int64_t lower = static_cast<std::int64_t>(nearest) - isBefore;
    const std::int64_t step = nearest < axis.lastIndex ? 1 : isBefore;
    const std::size_t offset = static_cast<std::size_t>(lower) * axis.stride;
    return {offset, offset + static_cast<std::size_t>(step) * axis.stride,
        way + static_cast<double>(isBefore)};
}

/// The first or the last cell goes on: the fraction is below 0 or above 1 outside.
inline Lookup::Cell Lookup::endCell(const Axis& axis, double position)
{
    if (axis.contains(position))
        return heldCell(axis, position);
    if (position < axis.start)
        return {0, axis.stride, (position - axis.start) * axis.perUnit};
    const std::size_t last = static_cast<std::size_t>(axis.lastIndex) * axis.stride;
    return {last - axis.stride, last, 1.0 + (position - axis.last) * axis.perUnit};
}

double Lookup::wrapped(const Axis& axis, double position)
{
    if (axis.contains(position))
        return position;
    const double period = axis.last - axis.start;
    const double way = std::fmod(position - axis.start, period);
    return axis.start + (way < 0.0 ? way + period : way);
}

inline double Lookup::blend(const Cell& x) const
{
    const double from = static_cast<double>(m_values[x.lower]);
    return mixed(from, static_cast<double>(m_values[x.upper]), x.fraction);
}

inline double Lookup::blend(const Cell& x, const Cell& y) const
{
    const auto row = [&](std::size_t offset) {
        const float* const values = m_values + offset;
        return mixed(
            static_cast<double>(values[x.lower]), static_cast<double>(values[x.upper]), x.fraction);
    };
    return mixed(row(y.lower), row(y.upper), y.fraction);
}

inline double Lookup::blend(const Cell& x, const Cell& y, const Cell& z) const
{
    const auto plane = [&](std::size_t offset) {
        const auto row = [&](std::size_t rowOffset) {
            const float* const values = m_values + offset + rowOffset;
            return mixed(static_cast<double>(values[x.lower]), static_cast<double>(values[x.upper]),
                x.fraction);
        };
        return mixed(row(y.lower), row(y.upper), y.fraction);
    };
    return mixed(plane(z.lower), plane(z.upper), z.fraction);
}

double Lookup::at(double x) const
{
    assert(m_dimensions == 1);
    if (m_outside != Outside::Hold && !m_axes[0].contains(x)) [[unlikely]]
        return atOutside({x, 0.0, 0.0});
    return blend(heldCell(m_axes[0], x));
}

double Lookup::at(double x, double y) const
{
    assert(m_dimensions == 2);
    if (m_outside != Outside::Hold && !(m_axes[0].contains(x) && m_axes[1].contains(y)))
        [[unlikely]]
        return atOutside({x, y, 0.0});
    return blend(heldCell(m_axes[0], x), heldCell(m_axes[1], y));
}

double Lookup::at(double x, double y, double z) const
{
    assert(m_dimensions == 3);
    if (m_outside != Outside::Hold
        && !(m_axes[0].contains(x) && m_axes[1].contains(y) && m_axes[2].contains(z))) [[unlikely]]
        return atOutside({x, y, z});
    return blend(heldCell(m_axes[0], x), heldCell(m_axes[1], y), heldCell(m_axes[2], z));
}

double Lookup::at(std::span<const double> positions) const
{
    assert(positions.size() == static_cast<std::size_t>(m_dimensions));
    switch (positions.size()) {
    case 1:
        return at(positions[0]);
    case 2:
        return at(positions[0], positions[1]);
    case 3:
        return at(positions[0], positions[1], positions[2]);
    default:
        return notANumber;
    }
}

double Lookup::atOutside(std::array<double, 3> positions) const
{
    if (std::ranges::any_of(positions, [](double position) { return std::isnan(position); }))
        return notANumber;
    std::array<Cell, 3> cells;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        switch (m_outside) {
        case Outside::Zero:
            return 0.0;
        case Outside::Error:
            return notANumber;
        case Outside::Hold:
            cells[i] = heldCell(m_axes[i], positions[i]);
            break;
        case Outside::Wrap:
            cells[i] = heldCell(m_axes[i], wrapped(m_axes[i], positions[i]));
            break;
        case Outside::Extrapolate:
            cells[i] = endCell(m_axes[i], positions[i]);
            break;
        }
    }
    return blend(cells[0], cells[1], cells[2]);
}

double Lookup::index(int dimension, double position) const
{
    if (dimension < 0 || dimension >= m_dimensions)
        return notANumber;
    const Axis& axis = m_axes[static_cast<std::size_t>(dimension)];
    if (!axis.contains(position) && m_outside != Outside::Hold) {
        if (m_outside == Outside::Error || std::isnan(position))
            return notANumber;
        if (m_outside == Outside::Wrap)
            position = wrapped(axis, position);
        else if (position < axis.start)
            return (position - axis.start) * axis.perUnit;
        else
            return axis.lastIndex + (position - axis.last) * axis.perUnit;
    }
    const double within = held(axis.start, position, axis.last);
    const double nearest = nearestIndex(axis, within);
    return nearest + (within - (axis.start + nearest * axis.distance)) * axis.perUnit;
}

} // namespace axiscomp
