// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::drivecomm {

/// The cells of one HTML table as plain text: tags removed, character references resolved, blanks
/// collapsed.
using HtmlRow = std::vector<std::string>;
using HtmlTable = std::vector<HtmlRow>;

/// Every table of a page, in order; a table within a table counts for itself. Takes any bytes:
/// missing end tags, comments, scripts and unfinished pages.
[[nodiscard]] std::vector<HtmlTable> htmlTables(std::string_view html);

/// The text of a page, as above: for quoting what a stranger answered.
[[nodiscard]] std::string htmlText(std::string_view html);

} // namespace axiscomp::drivecomm
