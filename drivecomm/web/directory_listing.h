// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::drivecomm {

/// The drive's table files as JSON: [{"path", "size", "maximumSize"}, ...].
[[nodiscard]] std::string directoryJson(std::span<const DriveFile> files);
/// Errors: Protocol (expected, quote).
[[nodiscard]] Result<std::vector<DriveFile>> parseDirectoryJson(std::string_view json);

/// The Directory page that every drive has (AN140 5.2): a table with the columns File, actual size
/// and maximum size, found by their headings, in any order. Tolerant of how the page is written,
/// strict about what it says. Errors: Protocol (expected, quote).
[[nodiscard]] Result<std::vector<DriveFile>> parseDirectoryPage(std::string_view html);

} // namespace axiscomp::drivecomm
