// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// ',' or ';': what separates the columns of a calibration file with this header line
/// (docs/calibration-csv.md, "Text").
[[nodiscard]] char csvSeparator(std::string_view headerLine);

/// Whether the line holds no columns: a comment, or blank.
[[nodiscard]] bool isCsvComment(std::string_view line);

/// The cells of a line as the parser counts them, for showing a file that could not be read: UTF-8
/// without blanks, quotes and control characters, at most `maximum`. A comment is one cell.
[[nodiscard]] std::vector<std::string> csvFields(
    std::string_view line, char separator, std::size_t maximum);

} // namespace axiscomp
