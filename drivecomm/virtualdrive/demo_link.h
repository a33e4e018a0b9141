// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <memory>

namespace axiscomp::drivecomm {

/// The drive behind "demo:": axes X and Y in millimetres, homed. loadDemoState gives X a persistent
/// 2D table over both axes and activates it.
[[nodiscard]] VirtualDriveOptions demoDriveOptions();
/// Errors: those of the drive; none for a drive that demoDriveOptions made.
[[nodiscard]] Result<void> loadDemoState(VirtualDrive& drive);

/// A link with the drive that it leads to, in its demo state. profile must outlive the link.
[[nodiscard]] Result<std::unique_ptr<DriveLink>> makeDemoLink(const DriveProfile& profile);

} // namespace axiscomp::drivecomm
