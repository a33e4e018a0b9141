// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/drive_summary.h"
#include "core/computer/finding.h"
#include "core/drive/drive_profile.h"
#include "core/drive/drive_search.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace axiscomp {

/// What a drive said when it was looked at.
struct DriveAnswer {
    std::string endpoint; ///< without a password; empty: it is no address
    std::string profile; ///< by which it was asked
    std::optional<DriveIdentity> drive; ///< none: it did not answer
    std::chrono::milliseconds latency{0}; ///< until it had said who it is, with connecting
    std::vector<AxisSummary> axes;
    std::optional<Error> error; ///< why it did not say all of it
};

struct DriveQuestion {
    LinkFactory linkFactory;
    const DriveProfile& profile;
    std::filesystem::path storeRoot; ///< what this computer remembers; may be a copy
    std::chrono::milliseconds timeLimit{5000}; ///< for all exchanges with the drive together
    std::stop_token stop{};
};

/// Asks a drive who it is and how its axes are, and writes nothing to it. endpoint: with a password
/// where it has one; shown: without. Blocks; the link is made and used on this thread.
[[nodiscard]] DriveAnswer askDrive(
    const std::string& endpoint, const std::string& shown, const DriveQuestion& question);

[[nodiscard]] FindingSection driveFindings(const std::vector<DriveAnswer>& answers);

} // namespace axiscomp
