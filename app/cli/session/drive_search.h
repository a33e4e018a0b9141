// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/session/command_session.h"
#include "drivecomm/drive_candidates.h"

#include <string>
#include <vector>

namespace axiscomp::app {

/// Without a password; empty when it is not valid.
[[nodiscard]] std::string shownEndpoint(const std::string& endpoint);

/// Looks at the addresses of the options and at all serial ports of this computer, and says on
/// standard error what was there and what was not, and why. At least one has answered.
/// Errors: NotConnected when none did, Cancelled, those of the profile.
[[nodiscard]] Result<std::vector<DriveSighting>> lookForDrives(
    Environment& environment, const DriveOptions& options, drivecomm::BaudRates rates);

/// The addresses of the window's connections, without users and passwords; none when there has been
/// no window yet.
[[nodiscard]] std::vector<std::string> rememberedDrives();

} // namespace axiscomp::app
