// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// What the position is at which the drive looks a table up: before or after its own compensation.
enum class LookupAt {
    Encoder, ///< the raw position u (MasterPosition, Encoders[n]/Position)
    Set, ///< u and what the drive adds (PathPlanner/Position)
};
[[nodiscard]] std::string_view lookupAtName(LookupAt lookupAt); ///< "encoder", "set"
/// In capital or small letters; nothing: neither.
[[nodiscard]] std::optional<LookupAt> lookupAtNamed(std::string_view name);

// Where a table has to be looked up, as a note of its file: a file that is written later says for
// which side of the compensation its values were made.

inline constexpr std::string_view lookupKey = "lookup:";
[[nodiscard]] std::string lookupNote(LookupAt lookupAt); ///< "lookup: set"
/// The notes with this one, or none of this kind, in place of what they have said before.
[[nodiscard]] std::vector<std::string> withLookupNote(
    std::vector<std::string> notes, std::optional<LookupAt> lookupAt);

/// What the notes say; nothing: none says it. notes: comments without their slashes. Errors:
/// InvalidArgument for a note that says neither side, and for two that contradict each other.
[[nodiscard]] Result<std::optional<LookupAt>> lookupInNotes(std::span<const std::string> notes);
/// The same, or what a person or a drive states of it. Errors: those of lookupInNotes, and
/// InvalidArgument where they contradict each other.
[[nodiscard]] Result<std::optional<LookupAt>> lookupOfTable(
    std::span<const std::string> notes, std::optional<LookupAt> stated);

} // namespace axiscomp
