// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/lookup.h"

#include "core/base/parallel.h"
#include "core/table/lookup_batch.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace axiscomp {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace

Lookup::Lookup(const CompensationTable& table, Outside outside)
    : m_values(table.values.data())
    , m_count(table.values.size())
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
        m_axes[i] = {
            {axis.start, axis.last(), axis.distance, perUnit,
                axis.start - roundingError * axis.distance, static_cast<double>(axis.size - 1)},
            axis.size - 1, stride, InsideRange(axis.start, axis.last())};
        stride *= axis.size;
    }
    const auto& [x, y, z] = m_axes;
    m_firstTwo = {Pair{x.start, y.start}, Pair{x.last, y.last}, Pair{x.distance, y.distance},
        Pair{x.perUnit, y.perUnit}, Pair{x.cellStart, y.cellStart}, Pair{x.lastIndex, y.lastIndex}};
}

Lookup::Cell Lookup::heldCell(const Axis& axis, double position)
{
    std::int64_t found = 0;
    double fraction = 0.0;
    findPlace<double>(axis, position, found, fraction);
    const auto point = static_cast<std::size_t>(found);
    return {point * axis.stride, point == axis.lastPoint ? 0 : axis.stride, fraction};
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
        auto value = static_cast<double>(values[0]);
        mixInto(value, static_cast<double>(values[x.step]), x.fraction);
        return value;
    };
    const auto plane = [&row, &y = y](const float* values) {
        double value = row(values);
        mixInto(value, row(values + y.step), y.fraction);
        return value;
    };
    const float* const corner = m_values + x.offset + y.offset + z.offset;
    double value = plane(corner);
    mixInto(value, plane(corner + z.step), z.fraction);
    return value;
}

double Lookup::heldAt(double x, double y, double z) const
{
    return blended({heldCell(m_axes[0], x), heldCell(m_axes[1], y), heldCell(m_axes[2], z)});
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
    std::int64_t point = 0;
    double fraction = 0.0;
    findPlace<double>(axis, position, point, fraction);
    return static_cast<double>(point) + fraction;
}

void Lookup::atEach(std::span<const double> positions, std::span<double> values) const
{
    constexpr std::size_t enough = 32'768; // positions for a thread to be worth its while
    const auto dimensions = static_cast<std::size_t>(m_dimensions);
    const InstructionSet best = bestInstructionSet();
    shareWork((values.size() + enough - 1) / enough, 0, [&](std::size_t part) {
        const std::size_t begin = part * enough;
        const std::size_t count = std::min(enough, values.size() - begin);
        atEach(positions.subspan(begin * dimensions, count * dimensions),
            values.subspan(begin, count), best);
    });
}

void Lookup::atEach(
    std::span<const double> positions, std::span<double> values, InstructionSet instructions) const
{
    const auto dimensions = static_cast<std::size_t>(m_dimensions);
    assert(positions.size() == values.size() * dimensions);
    BatchTable table{{m_axes[0], m_axes[1], m_axes[2]},
        {m_axes[0].stride, m_axes[1].stride, m_axes[2].stride}, m_values,
        m_outside == Outside::Hold};
    const auto single = [&](std::size_t i) {
        values[i] = at(positions.subspan(i * dimensions, dimensions));
    };
    // Offsets are numbers of 32 bits.
    const bool isVast = m_count > std::numeric_limits<std::int32_t>::max();
    const BatchLookup batch = batchLookup(m_dimensions, instructions);
    std::size_t begin = 0;
    for (; !isVast && begin + batchSize <= values.size(); begin += batchSize) {
        if (batch(table, &positions[begin * dimensions], &values[begin])) [[likely]]
            continue;
        for (std::size_t i = begin; i < begin + batchSize; ++i)
            if (std::isnan(values[i]))
                single(i);
    }
    for (; begin < values.size(); ++begin)
        single(begin);
}

} // namespace axiscomp
