// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::app {

/// For people: the shortest text that is exact, or seven digits when that is long. A value that is
/// a float32 (the drive's outputs and tables are) gets the shortest text of the float32.
[[nodiscard]] std::string shortText(double value);

/// The shortest text that gives back the same float32 (what a drive computes with).
[[nodiscard]] std::string floatText(double value);

/// Without an exponent, with this many digits behind the point.
[[nodiscard]] std::string fixedText(double value, int decimals);

/// Digits behind the point that a value needs, at most `most`.
[[nodiscard]] int decimalsOf(double value, int most);

/// The numbers of a column: as many digits behind the point in each, seven digits in the largest.
[[nodiscard]] std::vector<std::string> columnTexts(const std::vector<double>& values);

/// "+0.0021"; zero stays "0"
[[nodiscard]] std::string signedText(std::string text);

/// "1c291ca3"
[[nodiscard]] std::string hexText(std::uint32_t value);

/// "2 096 976"
[[nodiscard]] std::string countText(std::uint64_t value);

/// "1 value", "2 values"
[[nodiscard]] std::string plural(std::uint64_t count, std::string_view one, std::string_view many);

/// A finite decimal number and nothing else, independent of the locale.
[[nodiscard]] std::optional<double> numberFromText(std::string_view text);

/// "12.5 mm"; the number alone without a unit.
[[nodiscard]] std::string withUnit(const std::string& number, std::string_view unit);

} // namespace axiscomp::app
