// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive/drive_profile.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// A drive profile from JSON (docs/profiles.md has every key).
/// Errors: InvalidProfile with the JSON path of the fault ("slots[2].maximumSize") and the reason;
/// unknown keys are faults too. fileName is for messages.
[[nodiscard]] Result<DriveProfile> parseProfile(std::string_view json, const std::string& fileName);

/// Errors: FileNotReadable, FileTooLarge (1 MiB), InvalidProfile.
[[nodiscard]] Result<DriveProfile> loadProfile(const std::filesystem::path& file);

/// The built-in profile "generic" (resources/profiles/generic.json).
[[nodiscard]] const DriveProfile& genericProfile();

} // namespace axiscomp::drivecomm
