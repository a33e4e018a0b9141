// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"
#include "core/drive/drive_profile.h"
#include "drivecomm/link/drive_endpoint.h"

#include <memory>

namespace axiscomp::drivecomm {

/// DriveLink over the serial link of docs/protocol.md; endpoint is of kind Serial. The port is
/// opened by the first call, with the first request, which is `identify`; nothing else is sent
/// before a drive has answered. A call with a short deadline is enough to find out whether one
/// does. At most 16 registers are read at one instant, and at most 8 written: more writes are
/// DriveRejected. OtherDrive when the port came back with another drive behind it, until that is
/// identified. profile must outlive the link.
[[nodiscard]] std::unique_ptr<DriveLink> makeSerialDriveLink(
    const DriveEndpoint& endpoint, const DriveProfile& profile);

} // namespace axiscomp::drivecomm
