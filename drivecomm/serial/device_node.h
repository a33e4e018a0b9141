// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <string>

namespace axiscomp::drivecomm {

/// The device behind path, all symbolic links followed, when this user may read and write it.
/// Errors: NotConnected with the reason: it does not exist; no permission, and which group to join.
[[nodiscard]] Result<std::string> usableDevice(const std::string& path);

} // namespace axiscomp::drivecomm
