// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive/drive_profile.h"
#include "core/neutral/lookup_note.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

/// Where the drive looks a table up whose source is this register; nothing where the profile does
/// not know it as a position.
[[nodiscard]] std::optional<LookupAt> lookupAtSource(
    const DriveProfile& profile, std::string_view source);

/// The same for the table of an axis: by the source that is its own position, or by all of them
/// where none is and they are on one side. sources: paths of registers.
[[nodiscard]] std::optional<LookupAt> lookupAtSources(
    const DriveProfile& profile, int axis, std::span<const std::string> sources);

/// The source that decides it: the position of the axis itself, or else the first one.
[[nodiscard]] std::string lookupSource(
    const DriveProfile& profile, int axis, std::span<const std::string> sources);

/// The dimension whose source is the position of the axis itself; nothing: none is, as in a table
/// over a temperature or over other axes.
[[nodiscard]] std::optional<std::size_t> ownDimension(
    const DriveProfile& profile, int axis, std::span<const std::string> sources);

/// Whether a source is on the side of the compensation for which a table was made: its values
/// belong to other positions on the other one. A source that the profile does not know passes.
/// Errors: InvalidArgument, with the way out.
[[nodiscard]] Result<void> checkLookupSource(
    LookupAt made, const DriveProfile& profile, std::string_view source);

/// The same for the sources of an axis, by the rule of lookupAtSources.
[[nodiscard]] Result<void> checkLookupSources(
    LookupAt made, const DriveProfile& profile, int axis, std::span<const std::string> sources);

} // namespace axiscomp
