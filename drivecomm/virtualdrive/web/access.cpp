// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/access.h"

#include <QByteArray>
#include <QHostAddress>
#include <QString>

namespace axiscomp::drivecomm {

namespace {

bool isThisComputer(const std::string& host)
{
    return host == "localhost" || QHostAddress(QString::fromStdString(host)).isLoopback();
}

/// Takes the same time wherever the texts differ.
bool sameSecret(const std::string& a, const std::string& b)
{
    unsigned difference = a.size() == b.size() ? 0U : 1U;
    for (std::size_t i = 0; i < b.size(); ++i)
        difference |= static_cast<unsigned>(i < a.size() ? a[i] ^ b[i] : 1);
    return difference == 0;
}

/// "[::1]:8080" is ::1
std::string withoutPort(const std::string& host)
{
    if (host.starts_with('['))
        return host.substr(1, host.find(']') - 1);
    return host.substr(0, host.find(':'));
}

} // namespace

WebAccess::WebAccess(std::string host, const std::string& user, const std::string& password)
    : m_host(std::move(host))
    , m_isLoopback(isThisComputer(m_host))
{
    if (!user.empty() || !password.empty())
        m_authorization =
            "Basic " + QByteArray::fromStdString(user + ":" + password).toBase64().toStdString();
}

std::optional<WebAccess::Denial> WebAccess::denial(const WebRequest& request) const
{
    if (!isKnownHost(request.host))
        return Denial{403, rejected("this drive is not " + request.host + "; use " + m_host)};
    if (request.method != "GET" && isFromOtherSite(request))
        return Denial{403, rejected("a page of another site must not change anything here")};
    if (!m_authorization.empty() && !sameSecret(request.authorization, m_authorization))
        return Denial{401,
            Error{ErrorCode::Unauthorized,
                {{"reason", AXISCOMP_TEXT("Error", "user name or password is missing or wrong")}},
                {}}};
    return std::nullopt;
}

/// A page whose own name was made to point to this computer could otherwise read and write the
/// drive: its browser takes it for the same site.
bool WebAccess::isKnownHost(const std::string& host) const
{
    const std::string name = withoutPort(host);
    return !m_isLoopback || name == m_host || isThisComputer(name);
}

bool WebAccess::isFromOtherSite(const WebRequest& request)
{
    if (!request.fetchSite.empty() && request.fetchSite != "same-origin"
        && request.fetchSite != "none")
        return true;
    if (request.origin.empty())
        return false; // not a browser
    const std::size_t name = request.origin.find("://");
    return name == std::string::npos || request.origin.substr(name + 3) != request.host;
}

} // namespace axiscomp::drivecomm
