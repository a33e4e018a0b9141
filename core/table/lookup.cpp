// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/lookup.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace axiscomp {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Two neighbouring values of dimension 1, in one register where the processor has such.
using Pair = double __attribute__((vector_size(16)));

Pair pairAt(const float* values)
{
#ifdef __SSE2__
    // one instruction; from the code below compilers make four
    return _mm_cvtps_pd(_mm_castsi128_ps(_mm_loadu_si64(values)));
#else
    return Pair{static_cast<double>(values[0]), static_cast<double>(values[1])};
#endif
}

/// Exactly `from` at fraction 0, and exactly constant between equal values.
template <typename Number> Number mixed(Number from, Number to, double fraction)
{
    return from + fraction * (to - from);
}

double mixed(Pair ends, double fraction)
{
    return mixed(ends[0], ends[1], fraction);
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
        const double largest = std::max(std::abs(axis.start), std::abs(axis.last()));
        const double roundingError = std::min(
            0.25, 4.0 * std::numeric_limits<double>::epsilon() * (largest * perUnit + axis.size));
        m_axes[i] = {axis.start, axis.last(), axis.distance, perUnit,
            axis.start - roundingError * axis.distance, static_cast<double>(axis.size - 1),
            axis.size - 1, stride};
        stride *= axis.size;
    }
}

/// The fraction is measured from the position of the point as GridAxis computes it, so that it is
/// exactly 0 at every grid point; a position that is below one by no more than rounding belongs to
/// it. The order of the comparisons lets the compiler use minimum and maximum instructions, and
/// lets NaN pass to the fraction but not to the point.
inline Lookup::Place Lookup::heldPlace(const Axis& axis, double position)
{
    const double above = axis.start > position ? axis.start : position;
    const double within = axis.last < above ? axis.last : above;
    const double index = (within - axis.cellStart) * axis.perUnit;
    const auto point = static_cast<std::int64_t>(index < axis.lastIndex ? index : axis.lastIndex);
    const double pointPosition = axis.start + static_cast<double>(point) * axis.distance;
    return {static_cast<std::size_t>(point), (within - pointPosition) * axis.perUnit};
}

Lookup::Cell Lookup::heldCell(const Axis& axis, double position)
{
    const Place place = heldPlace(axis, position);
    return {
        place.point * axis.stride, place.point == axis.lastPoint ? 0 : axis.stride, place.fraction};
}

/// The first or the last cell goes on: the fraction is below 0 or above 1 outside.
Lookup::Cell Lookup::extrapolatedCell(const Axis& axis, double position)
{
    if (axis.contains(position))
        return heldCell(axis, position);
    if (position < axis.start)
        return {0, axis.stride, (position - axis.start) * axis.perUnit};
    return {(axis.lastPoint - 1) * axis.stride, axis.stride,
        1.0 + (position - axis.last) * axis.perUnit};
}

double Lookup::wrapped(const Axis& axis, double position)
{
    if (axis.contains(position))
        return position;
    const double period = axis.last - axis.start;
    const double way = std::fmod(position - axis.start, period);
    return axis.start + (way < 0.0 ? way + period : way);
}

double Lookup::blended(const std::array<Cell, 3>& cells) const
{
    const auto& [x, y, z] = cells;
    const auto row = [&x = x](const float* values) {
        return mixed(
            static_cast<double>(values[0]), static_cast<double>(values[x.step]), x.fraction);
    };
    const auto plane = [&row, &y = y](const float* values) {
        return mixed(row(values), row(values + y.step), y.fraction);
    };
    const float* const corner = m_values + x.offset + y.offset + z.offset;
    return mixed(plane(corner), plane(corner + z.step), z.fraction);
}

double Lookup::heldAt(double x, double y, double z) const
{
    return blended({heldCell(m_axes[0], x), heldCell(m_axes[1], y), heldCell(m_axes[2], z)});
}

// In the three functions that follow, the last grid point of a dimension is left to heldAt: the
// pair of values that begins with it is none.

double Lookup::at(double x) const
{
    assert(m_dimensions == 1);
    if (m_outside != Outside::Hold && !m_axes[0].contains(x)) [[unlikely]]
        return atOutside(x, 0.0, 0.0);
    const Place placeX = heldPlace(m_axes[0], x);
    if (placeX.point == m_axes[0].lastPoint) [[unlikely]]
        return heldAt(x, 0.0, 0.0);
    return mixed(pairAt(m_values + placeX.point), placeX.fraction);
}

double Lookup::at(double x, double y) const
{
    assert(m_dimensions == 2);
    if (m_outside != Outside::Hold && !(m_axes[0].contains(x) && m_axes[1].contains(y)))
        [[unlikely]]
        return atOutside(x, y, 0.0);
    const Place placeX = heldPlace(m_axes[0], x);
    const Place placeY = heldPlace(m_axes[1], y);
    if (placeX.point == m_axes[0].lastPoint || placeY.point == m_axes[1].lastPoint) [[unlikely]]
        return heldAt(x, y, 0.0);
    const std::size_t stepY = m_axes[1].stride;
    const float* const corner = m_values + placeX.point + placeY.point * stepY;
    return mixed(mixed(pairAt(corner), pairAt(corner + stepY), placeY.fraction), placeX.fraction);
}

double Lookup::at(double x, double y, double z) const
{
    assert(m_dimensions == 3);
    if (m_outside != Outside::Hold
        && !(m_axes[0].contains(x) && m_axes[1].contains(y) && m_axes[2].contains(z))) [[unlikely]]
        return atOutside(x, y, z);
    const Place placeX = heldPlace(m_axes[0], x);
    const Place placeY = heldPlace(m_axes[1], y);
    const Place placeZ = heldPlace(m_axes[2], z);
    if (placeX.point == m_axes[0].lastPoint || placeY.point == m_axes[1].lastPoint
        || placeZ.point == m_axes[2].lastPoint) [[unlikely]]
        return heldAt(x, y, z);
    const std::size_t stepY = m_axes[1].stride;
    const std::size_t stepZ = m_axes[2].stride;
    const float* const corner =
        m_values + placeX.point + placeY.point * stepY + placeZ.point * stepZ;
    const auto row = [&](const float* values) {
        return mixed(pairAt(values), pairAt(values + stepZ), placeZ.fraction);
    };
    return mixed(mixed(row(corner), row(corner + stepY), placeY.fraction), placeX.fraction);
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

/// At least one position is outside or no number, and m_outside is not Hold.
double Lookup::atOutside(double x, double y, double z) const
{
    if (m_outside == Outside::Error || std::isnan(x) || std::isnan(y) || std::isnan(z))
        return notANumber;
    if (m_outside == Outside::Zero)
        return 0.0;
    if (m_outside == Outside::Extrapolate)
        return blended({extrapolatedCell(m_axes[0], x), extrapolatedCell(m_axes[1], y),
            extrapolatedCell(m_axes[2], z)});
    return heldAt(wrapped(m_axes[0], x), wrapped(m_axes[1], y), wrapped(m_axes[2], z));
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
    const Place place = heldPlace(axis, position);
    return static_cast<double>(place.point) + place.fraction;
}

} // namespace axiscomp
