// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <optional>

namespace axiscomp::ui {

/// What a person needs to decide about the certificate of an https drive that nobody vouches for.
struct RejectedCertificate {
    QString endpoint; ///< "https://192.168.1.20", as TrustedCertificates has it
    QString fingerprint; ///< SHA-256, "3F:A0:..."
    QString subject;
    QString issuer;
    QString validFrom; ///< ISO date
    QString validUntil;
    bool hasChanged = false; ///< another one was trusted
    friend bool operator==(const RejectedCertificate&, const RejectedCertificate&) = default;
};

/// From the context of CertificateRejected; nullopt: it is another error.
[[nodiscard]] std::optional<RejectedCertificate> rejectedCertificate(const Error& error);

/// The address of a drive as TrustedCertificates has it; empty when it is not https.
[[nodiscard]] QString certificateEndpoint(const QString& endpoint);

} // namespace axiscomp::ui
