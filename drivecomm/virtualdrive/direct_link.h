// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"
#include "drivecomm/virtualdrive/faults.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <memory>

namespace axiscomp::drivecomm {

/// DriveLink to a virtual drive in the same process. drive and faults must outlive the link.
/// With faults the link fails as a real one would: a reply that does not come is a Timeout (at
/// once), a garbled one a Protocol error, a cut or a reboot ConnectionLost.
[[nodiscard]] std::unique_ptr<DriveLink> makeDirectLink(
    VirtualDrive& drive, FaultPlan* faults = nullptr);

} // namespace axiscomp::drivecomm
