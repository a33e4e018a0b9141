// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/session/command_session.h"
#include "core/computer/configuration_facts.h"
#include "drivecomm/drive_candidates.h"

#include <optional>
#include <string>
#include <vector>

namespace axiscomp::app {

/// Without a password; empty when it is not valid.
[[nodiscard]] std::string shownEndpoint(const std::string& endpoint);

/// Where drives are looked for beside the addresses of the options.
struct SearchedPlaces {
    drivecomm::BaudRates rates = drivecomm::BaudRates::AsGiven; ///< at the serial ports
    std::optional<NetworkRange> network; ///< none: no network is asked
};

/// Looks at the addresses of the options, at all serial ports of this computer and at the network
/// that was named, and says on standard error what was there and what was not, and why; of
/// addresses of a network where nothing answers only how many they are, and they are not among the
/// sightings. At least one has answered.
/// Errors: NotConnected when none did, Cancelled, those of the profile.
[[nodiscard]] Result<std::vector<DriveSighting>> lookForDrives(
    Environment& environment, const DriveOptions& options, const SearchedPlaces& places);

/// The settings of the window with the addresses of its connections.
[[nodiscard]] WindowSettings windowSettings();
/// The addresses of the window's connections, without users and passwords; none when there has been
/// no window yet.
[[nodiscard]] std::vector<std::string> rememberedDrives();

} // namespace axiscomp::app
