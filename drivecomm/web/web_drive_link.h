// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"
#include "core/drive/drive_profile.h"
#include "drivecomm/link/certificate_check.h"
#include "drivecomm/link/drive_endpoint.h"

#include <memory>

namespace axiscomp::drivecomm {

/// DriveLink over the drive's own web server (docs/protocol.md, "Web server").
[[nodiscard]] std::unique_ptr<DriveLink> makeWebDriveLink(const DriveEndpoint& endpoint,
    const DriveProfile& profile, CertificateCheck certificateCheck = {});

} // namespace axiscomp::drivecomm
