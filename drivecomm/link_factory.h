// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_profile.h"
#include "core/drive/drive_search.h"
#include "drivecomm/link/certificate_check.h"
#include "drivecomm/link/drive_endpoint.h"

#include <memory>
#include <string>

namespace axiscomp::drivecomm {

/// A link of the kind that the endpoint names. It is used on the thread that made it, which needs
/// no running event loop but a QCoreApplication must exist for http, https and serial. demo: makes
/// a virtual drive inside the process with an example state. Nothing is sent yet. profile must
/// outlive the link. Errors: those of the example state.
[[nodiscard]] Result<std::unique_ptr<DriveLink>> makeLink(const DriveEndpoint& endpoint,
    const DriveProfile& profile, const CertificateCheck& certificateCheck = {});

/// makeLink() from the text of an endpoint, which may be InvalidEndpoint. profile must outlive what
/// is made.
[[nodiscard]] LinkFactory linkFactory(
    const DriveProfile& profile, CertificateCheck certificateCheck = {});

/// What https is spoken with, "OpenSSL 3.0.15 3 Sep 2024"; empty: https drives cannot be reached. A
/// QCoreApplication must exist.
[[nodiscard]] std::string tlsLibrary();

} // namespace axiscomp::drivecomm
