// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace axiscomp {

/// A number in its shortest exact form, without an exponent where people would not write one.
[[nodiscard]] std::string toText(double value);
[[nodiscard]] std::string toText(float value);

/// The same into a buffer, for millions of them. Returns the end of the text.
inline constexpr std::size_t longestText = 32;
[[nodiscard]] char* writeText(float value, char* buffer);
[[nodiscard]] char* writeText(double value, char* buffer);

/// With this many digits behind the point, without an exponent, and no sign before what is rounded
/// to 0.
[[nodiscard]] std::string fixedDigits(double value, int decimals);

/// With this many digits that say something: "0.0333", "1.2e-07".
[[nodiscard]] std::string significantText(double value, int digits);

/// A computed number without the rounding of doubles: 12 digits.
[[nodiscard]] std::string roundedText(double value);

/// A share of 0 to 1 in percent, rounded down to whole ones, and below 10 % to two digits: only the
/// whole is "100", and only nothing is "0".
[[nodiscard]] std::string percentText(double share);

/// "31 x 21": the points of a grid in each dimension, or what else is counted per dimension.
[[nodiscard]] std::string sizeText(std::span<const std::size_t> counts);

/// The fewest characters that are exactly this number again: with an exponent where that is
/// shorter.
[[nodiscard]] std::string shortestText(double value);
[[nodiscard]] std::string shortestText(float value);

} // namespace axiscomp
