// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/rejected_certificate.h"

#include <QUrl>

namespace axiscomp::ui {

std::optional<RejectedCertificate> rejectedCertificate(const Error& error)
{
    const auto text = [&error](const char* key) {
        return QString::fromStdString(error.context.english(key));
    };
    if (error.code != ErrorCode::CertificateRejected || text("fingerprint").isEmpty())
        return std::nullopt;
    return RejectedCertificate{text("endpoint"), text("fingerprint"), text("subject"),
        text("issuer"), text("validFrom"), text("validUntil"), text("hasChanged") == u"yes"};
}

QString certificateEndpoint(const QString& endpoint)
{
    constexpr int usualPort = 443;
    const QUrl url(endpoint.trimmed(), QUrl::StrictMode);
    if (!url.isValid() || url.scheme() != u"https")
        return {};
    const QString host = url.host();
    const QString place = host.contains(u':') ? u'[' + host + u']' : host;
    const int port = url.port(usualPort);
    return QStringLiteral("https://") + place
        + (port == usualPort ? QString() : u':' + QString::number(port));
}

} // namespace axiscomp::ui
