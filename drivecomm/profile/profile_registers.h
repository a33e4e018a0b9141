// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_profile.h"
#include "core/io/strict_json.h"

namespace axiscomp::drivecomm {

/// The parts of a profile that name registers and their values. What is wrong is recorded in the
/// node's document.
[[nodiscard]] RegisterPaths readRegisterPaths(const JsonNode& node);
[[nodiscard]] RegisterEnums readRegisterEnums(const JsonNode& node);
/// With the ranges "[0..15]" written out.
[[nodiscard]] std::vector<std::string> readSourceShortlist(const JsonNode& node);
/// The same, each with {axis}.
[[nodiscard]] PositionKinds readPositionKinds(const JsonNode& node);
/// As the shortlist; none of them is a position.
[[nodiscard]] std::vector<std::string> readTemperatures(
    const JsonNode& node, const PositionKinds& positions);
[[nodiscard]] std::vector<std::string> readSourceTypes(const JsonNode& node);

/// A word that may be part of a path, an enum's value or a line of the serial link: letters,
/// digits, underscore and minus.
[[nodiscard]] std::string readWord(const JsonNode& node);

} // namespace axiscomp::drivecomm
