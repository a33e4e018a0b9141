// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Functions of the C library that differ between systems, and with the library of one system
/// between processors, in their last bits. These are of nothing but the additions, multiplications
/// and divisions of IEEE 754, so that a fitted table has the same bits, and so the same CRC, on
/// every computer. Computed with twice the digits of a double: as good as correctly rounded.
namespace axiscomp::portable {

/// Of radians. Beyond 10^15 neighbouring doubles are a good part of a turn apart, and the result is
/// that of some angle.
[[nodiscard]] double sin(double angle);
[[nodiscard]] double cos(double angle);
/// In (-pi, pi]; 0 for the origin. Signs of zeros do not count.
[[nodiscard]] double atan2(double y, double x);
/// Of values that neither overflow nor vanish when they are squared.
[[nodiscard]] double hypot(double x, double y);

/// Minus infinity for 0, NaN for less.
[[nodiscard]] double log(double value);
[[nodiscard]] double log2(double value);
[[nodiscard]] double log10(double value); ///< exact for powers of ten
/// base: 0 or more; a result that is larger or smaller than doubles is infinite or 0. Exact where
/// the result can be: pow(10, -3) is the double of 0.001.
[[nodiscard]] double pow(double base, double exponent);

} // namespace axiscomp::portable
