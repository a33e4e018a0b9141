// SPDX-License-Identifier: GPL-3.0-or-later
// The same code for registers of two, four and eight numbers: the compiler makes vectors of it for
// each set of instructions. Nothing may be contracted to fused operations (-ffp-contract=off), or
// the bits would differ.
#include "core/table/lookup_batch.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace axiscomp {

namespace {

/// Width numbers, and as many points. (In a template, GCC drops the attribute of an alias.)
template <std::size_t width> struct Lanes {
    typedef double Numbers __attribute__((vector_size(width * sizeof(double))));
    typedef std::int32_t Points __attribute__((vector_size(width * sizeof(std::int32_t))));
};

template <typename Vector, typename Element>
[[gnu::always_inline]] inline void load(Vector& vector, const Element* from)
{
    std::memcpy(&vector, from, sizeof vector);
}

template <typename Vector, typename Element>
[[gnu::always_inline]] inline void store(const Vector& vector, Element* to)
{
    std::memcpy(to, &vector, sizeof vector);
}

template <typename Numbers>
[[gnu::always_inline]] inline void spread(
    const AxisNumbers<double>& axis, AxisNumbers<Numbers>& numbers)
{
    numbers.start = Numbers{} + axis.start;
    numbers.last = Numbers{} + axis.last;
    numbers.distance = Numbers{} + axis.distance;
    numbers.perUnit = Numbers{} + axis.perUnit;
    numbers.cellStart = Numbers{} + axis.cellStart;
    numbers.lastIndex = Numbers{} + axis.lastIndex;
}

/// One dimension after the other.
template <std::size_t dimensions>
using BatchNumbers = std::array<std::array<double, batchSize>, dimensions>;

/// Where the cells begin in the values.
using BatchOffsets = std::array<std::int32_t, batchSize>;

/// Fills fractions and offsets. False: some positions are left out; their first fraction is no
/// number.
template <std::size_t width, std::size_t dimensions>
[[gnu::always_inline]] inline bool findCells(const BatchTable& table,
    const BatchNumbers<dimensions>& positions, BatchNumbers<dimensions>& fractions,
    BatchOffsets& offsets)
{
    using Numbers = typename Lanes<width>::Numbers;
    using Points = typename Lanes<width>::Points;
    std::array<AxisNumbers<Numbers>, dimensions> axes;
    for (std::size_t n = 0; n < dimensions; ++n)
        spread(table.axes[n], axes[n]);
    const Numbers zero{};
    const Numbers one = zero + 1.0;
    const Numbers notANumber = zero + std::numeric_limits<double>::quiet_NaN();
    const Numbers outsideIsOut = zero + (table.holdsEnds ? 0.0 : 1.0);
    Numbers allOut{};
    for (std::size_t i = 0; i < batchSize; i += width) {
        Numbers offset{};
        Numbers out{}; // above 0 where the position is left out
        std::array<Numbers, dimensions> fraction;
#pragma GCC unroll 3
        for (std::size_t n = 0; n < dimensions; ++n) {
            const AxisNumbers<Numbers>& axis = axes[n];
            Numbers position;
            load(position, &positions[n][i]);
            Points points;
            findPlace(axis, position, points, fraction[n]);
            const Numbers point = __builtin_convertvector(points, Numbers);
            offset += point * static_cast<double>(table.strides[n]);
            out += point == axis.lastIndex ? one : zero;
            out += position >= axis.start ? zero : outsideIsOut;
            out += position <= axis.last ? zero : outsideIsOut;
        }
        fraction[0] = out > zero ? notANumber : fraction[0];
#pragma GCC unroll 3
        for (std::size_t n = 0; n < dimensions; ++n)
            store(fraction[n], &fractions[n][i]);
        offset = out > zero ? zero : offset;
        const Points found = __builtin_convertvector(offset, Points);
        store(found, &offsets[i]);
        allOut += out;
    }
    double sum = 0.0;
    for (std::size_t lane = 0; lane < width; ++lane)
        sum += allOut[lane];
    return sum == 0.0;
}

using Four = Lanes<4>::Numbers;

/// One row of dimension 1 in each of four cells: its two values, or what is mixed of two such rows.
struct Rows {
    Four values;
    Four neighbours;
};

[[gnu::always_inline]] inline void loadRows(
    const float* corner, const std::int32_t* offsets, Rows& rows)
{
    using TwoPairs = std::int64_t __attribute__((vector_size(16)));
    using FourValues = float __attribute__((vector_size(16)));
    std::array<std::int64_t, 4> pairs;
    std::memcpy(&pairs[0], corner + offsets[0], sizeof pairs[0]);
    std::memcpy(&pairs[1], corner + offsets[1], sizeof pairs[0]);
    std::memcpy(&pairs[2], corner + offsets[2], sizeof pairs[0]);
    std::memcpy(&pairs[3], corner + offsets[3], sizeof pairs[0]);
    const auto first = reinterpret_cast<FourValues>(TwoPairs{pairs[0], pairs[1]});
    const auto second = reinterpret_cast<FourValues>(TwoPairs{pairs[2], pairs[3]});
    rows.values = __builtin_convertvector(__builtin_shufflevector(first, second, 0, 2, 4, 6), Four);
    rows.neighbours =
        __builtin_convertvector(__builtin_shufflevector(first, second, 1, 3, 5, 7), Four);
}

[[gnu::always_inline]] inline void mixRows(Rows& rows, const Rows& others, const Four& fraction)
{
    mixInto(rows.values, others.values, fraction);
    mixInto(rows.neighbours, others.neighbours, fraction);
}

/// In the order of Lookup::at: dimension 3, 2, 1.
template <std::size_t dimensions>
[[gnu::always_inline]] inline void mixCells(const BatchTable& table,
    const BatchNumbers<dimensions>& fractions, const BatchOffsets& offsets, double* values)
{
    const float* const corner = table.values;
    const std::size_t stepY = table.strides[1];
    const std::size_t stepZ = table.strides[2];
    for (std::size_t i = 0; i < batchSize; i += 4) {
        Four fraction;
        Rows rows;
        loadRows(corner, &offsets[i], rows);
        if constexpr (dimensions == 2) {
            Rows behind;
            loadRows(corner + stepY, &offsets[i], behind);
            load(fraction, &fractions[1][i]);
            mixRows(rows, behind, fraction);
        }
        if constexpr (dimensions == 3) {
            Rows above;
            Rows behind;
            Rows behindAbove;
            loadRows(corner + stepZ, &offsets[i], above);
            loadRows(corner + stepY, &offsets[i], behind);
            loadRows(corner + stepY + stepZ, &offsets[i], behindAbove);
            load(fraction, &fractions[2][i]);
            mixRows(rows, above, fraction);
            mixRows(behind, behindAbove, fraction);
            load(fraction, &fractions[1][i]);
            mixRows(rows, behind, fraction);
        }
        load(fraction, &fractions[0][i]);
        mixInto(rows.values, rows.neighbours, fraction);
        store(rows.values, values + i);
    }
}

template <std::size_t width, std::size_t dimensions>
[[gnu::always_inline]] inline bool lookUp(
    const BatchTable& table, const double* positions, double* values)
{
    // Many positions come from memory and many values go there, both in order: the next ones are
    // asked for while these are worked on.
    for (std::size_t i = 0; i < batchSize * dimensions; i += 8)
        __builtin_prefetch(positions + batchSize * dimensions + i);
    for (std::size_t i = 0; i < batchSize; i += 8)
        __builtin_prefetch(values + batchSize + i, 1);
    BatchNumbers<dimensions> byDimension;
    for (std::size_t i = 0; i < batchSize; ++i, positions += dimensions) {
        byDimension[0][i] = positions[0];
        if constexpr (dimensions > 1)
            byDimension[1][i] = positions[1];
        if constexpr (dimensions > 2)
            byDimension[2][i] = positions[2];
    }
    BatchNumbers<dimensions> fractions;
    BatchOffsets offsets;
    const bool isComplete = findCells<width, dimensions>(table, byDimension, fractions, offsets);
    mixCells<dimensions>(table, fractions, offsets, values);
    return isComplete;
}

template <std::size_t dimensions>
bool lookUpBaseline(const BatchTable& table, const double* positions, double* values)
{
    return lookUp<2, dimensions>(table, positions, values);
}

#ifdef AXISCOMP_HAS_WIDE_VECTORS
template <std::size_t dimensions>
[[gnu::target("avx2")]] bool lookUpAvx2(
    const BatchTable& table, const double* positions, double* values)
{
    return lookUp<4, dimensions>(table, positions, values);
}

template <std::size_t dimensions>
[[gnu::target("avx512f,avx512dq,avx512vl")]] bool lookUpAvx512(
    const BatchTable& table, const double* positions, double* values)
{
    return lookUp<8, dimensions>(table, positions, values);
}
#endif

template <std::size_t dimensions> BatchLookup lookupWith(InstructionSet instructions)
{
#ifdef AXISCOMP_HAS_WIDE_VECTORS
    if (instructions == InstructionSet::Avx512)
        return lookUpAvx512<dimensions>;
    if (instructions == InstructionSet::Avx2)
        return lookUpAvx2<dimensions>;
#endif
    static_cast<void>(instructions);
    return lookUpBaseline<dimensions>;
}

} // namespace

BatchLookup batchLookup(int dimensions, InstructionSet instructions)
{
    switch (dimensions) {
    case 1:
        return lookupWith<1>(instructions);
    case 2:
        return lookupWith<2>(instructions);
    default:
        return lookupWith<3>(instructions);
    }
}

} // namespace axiscomp
