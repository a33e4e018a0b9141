// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

// Which drive was measured, as a line of a file: "drive: Mill, serial number 850618". A measurement
// says it in its header, and a table that was made of it in its notes.

inline constexpr std::string_view driveKey = "drive:";
/// What stands before the serial number.
inline constexpr std::string_view driveSerialKey = "serial number ";
/// "Mill, serial number 850618"; a drive may have no name.
[[nodiscard]] std::string driveText(std::string_view name, std::int32_t serial);
/// By which a drive is told: its name may change. text: "Mill, serial number 850618". Nothing: it
/// does not end with a serial number.
[[nodiscard]] std::optional<std::int32_t> driveSerialIn(std::string_view text);

/// "drive: Mill, serial number 850618"
[[nodiscard]] std::string driveNote(std::string_view drive);
/// Serial number of the drive that was measured, as the notes say it; nothing: none says it. notes:
/// comments without their slashes. Errors: InvalidArgument for two that contradict each other.
[[nodiscard]] Result<std::optional<std::int32_t>> measuredDriveInNotes(
    std::span<const std::string> notes);

/// That a table, or residuals, go to the drive that was measured: the axis X of a twin machine has
/// another error. measured: its serial number; nothing: not known, and any drive passes. found:
/// that of the drive. Errors: OtherDrive, with the way out.
[[nodiscard]] Result<void> checkMeasuredDrive(
    std::optional<std::int32_t> measured, std::int32_t found);

} // namespace axiscomp
