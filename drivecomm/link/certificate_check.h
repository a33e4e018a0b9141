// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/trusted_certificates.h"

#include <functional>
#include <string>

namespace axiscomp::drivecomm {

/// What a person has decided about the certificate of an https endpoint ("https://host:port"), by
/// its SHA-256 (sha256Fingerprint): asked for every certificate that comes. Called on any thread.
/// Empty: nobody has decided anything.
using CertificateCheck =
    std::function<CertificateTrust(const std::string& endpoint, const std::string& fingerprint)>;

} // namespace axiscomp::drivecomm
