// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

namespace axiscomp {

/// What a lookup must know of a dimension. Number: double, or a vector of doubles: of several
/// dimensions, or the same dimension for several positions.
template <typename Number> struct AxisNumbers {
    Number start;
    Number last;
    Number distance;
    Number perUnit; ///< 1 / distance
    Number cellStart; ///< start, lower by more than the rounding error of a position
    Number lastIndex; ///< size - 1
};

/// The grid point at or below a position, which is held at the ends, and the way from there to the
/// next one as a fraction of the distance. The only place where this is worked out, so that one
/// position and many of them get the same bits.
///
/// The fraction is measured from the position of the point as GridAxis computes it, so that it is
/// exactly 0 at every grid point; a position that is below one by no more than rounding belongs to
/// it. The order of the comparisons lets the compiler use minimum and maximum instructions, and
/// lets NaN pass to the fraction but not to the point.
template <typename Number, typename Index>
[[gnu::always_inline]] inline void findPlace(
    const AxisNumbers<Number>& axis, const Number& position, Index& point, Number& fraction)
{
    const Number above = axis.start > position ? axis.start : position;
    const Number within = axis.last < above ? axis.last : above;
    const Number index = (within - axis.cellStart) * axis.perUnit;
    const Number held = index < axis.lastIndex ? index : axis.lastIndex;
    Number pointPosition{};
    if constexpr (std::is_floating_point_v<Number>) {
        point = static_cast<Index>(held);
        pointPosition = axis.start + static_cast<Number>(point) * axis.distance;
    } else {
        point = __builtin_convertvector(held, Index);
        pointPosition = axis.start + __builtin_convertvector(point, Number) * axis.distance;
    }
    fraction = (within - pointPosition) * axis.perUnit;
}

/// On the way to another number: exactly where it was at fraction 0, and exactly constant between
/// equal numbers.
template <typename Number, typename Fraction>
[[gnu::always_inline]] inline void mixInto(
    Number& number, const Number& other, const Fraction& fraction)
{
    number += fraction * (other - number);
}

} // namespace axiscomp
