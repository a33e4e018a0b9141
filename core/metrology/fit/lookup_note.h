// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/lookup_frame.h"

#include <optional>
#include <span>
#include <string>

namespace axiscomp {

// Where a table has to be looked up, as a note of its file: a file that is written later says for
// which side of the compensation its values were made.

[[nodiscard]] std::string lookupNote(LookupAt lookupAt); ///< "lookup: set"

/// What the notes say; nothing: none says it. notes: comments without their slashes. Errors:
/// InvalidArgument for a note that says neither side, and for two that contradict each other.
[[nodiscard]] Result<std::optional<LookupAt>> lookupInNotes(std::span<const std::string> notes);

} // namespace axiscomp
