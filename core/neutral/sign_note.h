// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/neutral/neutral_table.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

// That a calibration file holds command values, as a note of it, "sign: command": nothing else of
// the file tells them from what the drive adds.

inline constexpr std::string_view signKey = "sign:";
/// The notes with what they have to say of values of this sign, and nothing that contradicts it: of
/// command values one note, of feedback values what is there of these.
[[nodiscard]] std::vector<std::string> withSignNote(
    std::vector<std::string> notes, SignConvention sign);

/// What a person states of the sign, or else Command where the notes say it; nothing: as the format
/// says. notes: comments without their slashes. Errors: InvalidArgument for a note that says
/// neither feedback (or deviation) nor command, and where they contradict each other.
[[nodiscard]] Result<std::optional<SignConvention>> signOfTable(
    std::span<const std::string> notes, std::optional<SignConvention> stated);

} // namespace axiscomp
