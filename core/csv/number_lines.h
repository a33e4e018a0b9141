// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/cells.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace axiscomp::csv {

/// The first lines of a piece of a text, as far as they hold nothing but short numbers.
struct NumberLines {
    std::vector<double> values; ///< [line * columns + column]
    std::size_t lines = 0;
    const char* begin = nullptr;
    const char* end = nullptr; ///< where the first line begins that is anything else
    const char* limit = nullptr; ///< where the piece ends, at the beginning of a line
};

/// The next megabytes of a text, which begins with a line, in pieces that all processors read; what
/// they are does not depend on the number of processors. Nothing at the end of the text. Reports
/// nothing: what it does not take is for CellReader.
[[nodiscard]] std::vector<NumberLines> readNumberLines(
    std::string_view text, const CellFormat& format, std::size_t columns);

} // namespace axiscomp::csv
