// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

#include <string>

namespace axiscomp::app {

// The facts of the table formats in words, for `axiscomp formats` and docs/formats.md.

[[nodiscard]] std::string_view knotRuleName(
    KnotRule rule); ///< "any ascending", "even", "square cells"
[[nodiscard]] std::string dimensionsText(const FormatFacts& facts); ///< "1 to 3"
[[nodiscard]] std::string outsideWords(const FormatFacts& facts);

/// Everything about one format, for a terminal.
[[nodiscard]] std::string formatText(const TableFormat& format);

/// The page docs/formats.md.
[[nodiscard]] std::string formatsPage();

} // namespace axiscomp::app
