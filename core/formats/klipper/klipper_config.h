// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/token_scanner.h"

namespace axiscomp::klipper {

// What printer.cfg is made of: sections with entries, some of them behind #*# as SAVE_CONFIG writes
// them.

/// How each line of the part begins that SAVE_CONFIG writes.
inline constexpr std::string_view autosavePrefix = "#*#";

/// The line as the firmware sees it: without #*# in front, or without comments.
[[nodiscard]] Token configLine(const Token& line);

/// "[bed_mesh default]": what stands in the brackets; nothing when this is no section.
[[nodiscard]] std::optional<Token> sectionOf(const Token& line);

} // namespace axiscomp::klipper
