// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/token_scanner.h"

namespace axiscomp::klipper {

// What printer.cfg is made of: sections with entries, some of them behind #*# as SAVE_CONFIG writes
// them.

/// Finds the part that SAVE_CONFIG writes. It is a configuration of its own, with words above its
/// first section: no section goes on into it.
class AutosavedPart {
public:
    /// line: as it stands in the file. True once, at the first line of the part.
    [[nodiscard]] bool beginsAt(const Token& line);

private:
    bool m_hasBegun = false;
};

/// The line as the firmware sees it: without #*# in front, or without comments.
[[nodiscard]] Token configLine(const Token& line);

/// "[bed_mesh default]": what stands in the brackets; nothing when this is no section.
[[nodiscard]] std::optional<Token> sectionOf(const Token& line);

} // namespace axiscomp::klipper
