// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_link.h"
#include "core/drive_profile.h"
#include "drivecomm/certificate_check.h"
#include "drivecomm/drive_endpoint.h"

#include <memory>

namespace axiscomp::drivecomm {

/// DriveLink over the drive's own web server (spec/drive.md, "Web server").
[[nodiscard]] std::unique_ptr<DriveLink> makeWebDriveLink(const DriveEndpoint& endpoint,
    const DriveProfile& profile, CertificateCheck certificateCheck = {});

} // namespace axiscomp::drivecomm
