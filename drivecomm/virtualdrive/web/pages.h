// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"
#include "core/drive/drive_profile.h"

#include <span>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

struct PageFrame;

/// The pages by which a person does every step in a browser (docs/protocol.md, "Web server").
struct StartPage {
    std::string driveError;
    std::vector<std::string> axisNames; ///< one per axis, may be empty texts
};
[[nodiscard]] std::string startPage(
    const PageFrame& frame, const DriveProfile& profile, const StartPage& start);
[[nodiscard]] std::string directoryPage(
    const PageFrame& frame, const DriveProfile& profile, std::span<const DriveFile> files);
[[nodiscard]] std::string transferPage(
    const PageFrame& frame, const DriveProfile& profile, std::span<const DriveFile> files);
[[nodiscard]] std::string transferDonePage(
    const PageFrame& frame, const DriveProfile& profile, const DriveFile& file);
[[nodiscard]] std::string errorPage(
    const PageFrame& frame, std::string_view message, std::string_view backLink);

/// /registers?path=A&path=B
[[nodiscard]] std::string registersLink(
    const DriveProfile& profile, std::span<const std::string> paths);
/// /registers?prefix=P
[[nodiscard]] std::string treeLink(const DriveProfile& profile, std::string_view prefix);

} // namespace axiscomp::drivecomm
