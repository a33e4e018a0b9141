// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace axiscomp::drivecomm {

/// The text of resources/profiles/generic.json, put into the library by CMake.
extern const std::string_view genericProfileJson;

} // namespace axiscomp::drivecomm
