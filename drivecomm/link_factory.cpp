// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link_factory.h"

#include "drivecomm/serial/serial_drive_link.h"
#include "drivecomm/virtualdrive/demo_link.h"
#include "drivecomm/web/web_drive_link.h"

#include <QSslSocket>

namespace axiscomp::drivecomm {

Result<std::unique_ptr<DriveLink>> makeLink(const DriveEndpoint& endpoint,
    const DriveProfile& profile, const CertificateCheck& certificateCheck)
{
    switch (endpoint.kind) {
    case DriveEndpoint::Kind::Http:
    case DriveEndpoint::Kind::Https:
        return makeWebDriveLink(endpoint, profile, certificateCheck);
    case DriveEndpoint::Kind::Serial:
        return makeSerialDriveLink(endpoint, profile);
    case DriveEndpoint::Kind::Demo:
        break;
    }
    return makeDemoLink(profile);
}

LinkFactory linkFactory(const DriveProfile& profile, CertificateCheck certificateCheck)
{
    return [&profile, certificateCheck = std::move(certificateCheck)](
               const std::string& text) -> Result<std::unique_ptr<DriveLink>> {
        AXISCOMP_TRY(const auto endpoint, parseEndpoint(text));
        return makeLink(endpoint, profile, certificateCheck);
    };
}

std::string tlsLibrary()
{
    return QSslSocket::supportsSsl() ? QSslSocket::sslLibraryVersionString().toStdString()
                                     : std::string();
}

} // namespace axiscomp::drivecomm
