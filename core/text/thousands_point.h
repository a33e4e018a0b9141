// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace axiscomp {

/// A number such as "1.000" in a column with "750": a point in it may stand between thousands.
struct ThousandsDoubt {
    std::size_t line = 0;
    std::size_t column = 0; ///< from 1
    std::string_view number; ///< "1.000"
    std::string_view whole; ///< "750", of the same column
};

/// Looks at the cells of data lines for points between thousands, as German spreadsheets print
/// them. There is a doubt while every point has three digits behind it and at most three before it,
/// not with 0 in front, and numbers without a point have at most three digits: nothing shows then
/// that points are decimal. The answer comes with the first decimal point in most files. firstLine:
/// the number of the first of the lines.
[[nodiscard]] std::optional<ThousandsDoubt> thousandsDoubt(
    std::string_view lines, std::size_t firstLine, char separator);

} // namespace axiscomp
