// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"
#include "core/table/grid_place.h"
#include "core/table/instruction_set.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <limits>
#include <span>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace axiscomp {

/// What a lookup answers outside the table. The drive holds the end values (assumption,
/// docs/drive.md).
enum class Outside {
    Hold, ///< the value at the nearest end
    Zero, ///< no compensation
    Wrap, ///< periodic with last - start: the first and the last point are the same place
    Extrapolate, ///< the first or last cell goes on
    Error, ///< quiet NaN
};

/// Linear, bilinear or trilinear lookup in an even table (AN140 3.1). The only interpolation of the
/// program: preview, virtual drive, command line and proof use it. Refers to the table's values and
/// must not outlive them. A NaN position gives NaN;
/// so does an infinite one that is wrapped or extrapolated.
class Lookup {
public:
    /// table: consistent (values.size() == grid.pointCount(), 1 to 3 dimensions, sizes from 2 to
    /// 2^31 - 1).
    explicit Lookup(const CompensationTable& table, Outside outside = Outside::Hold);

    [[nodiscard]] int dimensions() const { return m_dimensions; }
    [[nodiscard]] double at(double x) const;
    [[nodiscard]] double at(double x, double y) const;
    [[nodiscard]] double at(double x, double y, double z) const;
    /// positions.size() == dimensions()
    [[nodiscard]] double at(std::span<const double> positions) const;

    /// What at() answers for each of many positions, with the same bits (a NaN for a NaN), several
    /// at a time and on all processors. positions: dimensions() numbers for each; values: one each,
    /// in other memory than the positions.
    void atEach(std::span<const double> positions, std::span<double> values) const;
    /// The same on this thread, with certain instructions of the processor, which must have them.
    void atEach(std::span<const double> positions, std::span<double> values,
        InstructionSet instructions) const;

    /// The fractional index of a position in dimension 0, 1 or 2, as the drive's Dim1Index to
    /// Dim3Index show it. Within the table 0 .. size - 1, whole exactly at the grid points.
    /// Outside: Hold holds it at the ends, Wrap wraps it, Zero and Extrapolate let it go on, Error
    /// gives NaN.
    [[nodiscard]] double index(int dimension, double position) const;

private:
    /// A dimension that the table lacks has the single position 0.
    struct Axis : AxisNumbers<double> {
        std::size_t lastPoint = 0; ///< size - 1
        std::size_t stride = 0;
        InsideRange inside = {};

        [[nodiscard]] bool contains(double position) const { return inside.contains(position); }
    };
    /// A grid point as an offset into the values, and the way from there to the next one.
    struct Cell {
        std::size_t offset = 0;
        std::size_t step = 0; ///< to the next point; 0 behind the last one
        double fraction = 0.0;
    };
    /// Two numbers in one register where the processor has such: of dimensions 1 and 2, or two
    /// neighbouring values of dimension 1.
    using Pair = double __attribute__((vector_size(16)));
    using PairOfPoints = std::int32_t __attribute__((vector_size(8)));

    [[nodiscard]] static Pair pairAt(const float* values);
    [[nodiscard]] static Cell heldCell(const Axis& axis, double position);
    [[nodiscard]] static Cell extrapolatedCell(const Axis& axis, double position);
    [[nodiscard]] static double wrapped(const Axis& axis, double position);
    [[nodiscard]] double blended(const std::array<Cell, 3>& cells) const;
    [[nodiscard]] double heldAt(double x, double y, double z) const;
    [[nodiscard]] double atOutside(double x, double y, double z) const;

    std::array<Axis, 3> m_axes{};
    AxisNumbers<Pair> m_firstTwo{}; ///< dimensions 1 and 2
    const float* m_values = nullptr;
    std::size_t m_count = 0; ///< of the values
    int m_dimensions = 0;
    Outside m_outside = Outside::Hold;
};

inline Lookup::Pair Lookup::pairAt(const float* values)
{
#ifdef __SSE2__
    // one instruction; from the code below compilers make four
    return _mm_cvtps_pd(_mm_castsi128_ps(_mm_loadu_si64(values)));
#else
    return Pair{static_cast<double>(values[0]), static_cast<double>(values[1])};
#endif
}

// In the three functions that follow, the last grid point of a dimension is left to heldAt: the
// pair of values that begins with it is none. They stand here because a call takes a fifth of the
// time of a linear lookup.

[[gnu::always_inline]] inline double Lookup::at(double x) const
{
    assert(m_dimensions == 1);
    const Axis& axis = m_axes[0];
    if (m_outside != Outside::Hold && !axis.contains(x)) [[unlikely]]
        return atOutside(x, 0.0, 0.0);
    std::int64_t point = 0;
    double fraction = 0.0;
    findPlace<double>(axis, x, point, fraction);
    const auto offset = static_cast<std::size_t>(point);
    if (offset == axis.lastPoint) [[unlikely]]
        return heldAt(x, 0.0, 0.0);
    const Pair ends = pairAt(m_values + offset);
    double value = ends[0];
    mixInto(value, ends[1], fraction);
    return value;
}

[[gnu::always_inline]] inline double Lookup::at(double x, double y) const
{
    assert(m_dimensions == 2);
    if (m_outside != Outside::Hold && !(m_axes[0].contains(x) && m_axes[1].contains(y)))
        [[unlikely]]
        return atOutside(x, y, 0.0);
    PairOfPoints points{};
    Pair fractions{};
    findPlace(m_firstTwo, Pair{x, y}, points, fractions);
    const auto pointX = static_cast<std::size_t>(points[0]);
    const auto pointY = static_cast<std::size_t>(points[1]);
    if (pointX == m_axes[0].lastPoint || pointY == m_axes[1].lastPoint) [[unlikely]]
        return heldAt(x, y, 0.0);
    const std::size_t stepY = m_axes[1].stride;
    const float* const corner = m_values + pointX + pointY * stepY;
    Pair row = pairAt(corner);
    mixInto(row, pairAt(corner + stepY), fractions[1]);
    double value = row[0];
    mixInto(value, row[1], fractions[0]);
    return value;
}

[[gnu::always_inline]] inline double Lookup::at(double x, double y, double z) const
{
    assert(m_dimensions == 3);
    if (m_outside != Outside::Hold
        && !(m_axes[0].contains(x) && m_axes[1].contains(y) && m_axes[2].contains(z))) [[unlikely]]
        return atOutside(x, y, z);
    PairOfPoints points{};
    Pair fractions{};
    findPlace(m_firstTwo, Pair{x, y}, points, fractions);
    std::int64_t lastOne = 0;
    double fractionZ = 0.0;
    findPlace<double>(m_axes[2], z, lastOne, fractionZ);
    const auto pointX = static_cast<std::size_t>(points[0]);
    const auto pointY = static_cast<std::size_t>(points[1]);
    const auto pointZ = static_cast<std::size_t>(lastOne);
    if (pointX == m_axes[0].lastPoint || pointY == m_axes[1].lastPoint
        || pointZ == m_axes[2].lastPoint) [[unlikely]]
        return heldAt(x, y, z);
    const std::size_t stepY = m_axes[1].stride;
    const std::size_t stepZ = m_axes[2].stride;
    const float* const corner = m_values + pointX + pointY * stepY + pointZ * stepZ;
    Pair row = pairAt(corner);
    mixInto(row, pairAt(corner + stepZ), fractionZ);
    Pair next = pairAt(corner + stepY);
    mixInto(next, pairAt(corner + stepY + stepZ), fractionZ);
    mixInto(row, next, fractions[1]);
    double value = row[0];
    mixInto(value, row[1], fractions[0]);
    return value;
}

} // namespace axiscomp
