// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link/drive_endpoint.h"

#include <QUrl>
#include <QUrlQuery>

namespace axiscomp::drivecomm {

namespace {

/// A password with one of these characters looks like a port, a path or no address at all.
constexpr TextPattern barePassword = AXISCOMP_TEXT("Error",
    "write http://user:password@host[:port], and in user name and password %40 for @, %3A for :, "
    "%2F for /, %3F for ?, %23 for # and %25 for %");

tl::unexpected<Error> invalid(const QUrl& url, Text reason)
{
    // A password with a slash looks like a port and a path; what follows the last @ is none.
    const QString shown = url.toDisplayString(QUrl::RemoveUserInfo | QUrl::StripTrailingSlash)
                              .section(u'@', url.scheme() == u"serial" ? 0 : -1);
    return fail(ErrorCode::InvalidEndpoint,
        {{"endpoint", shown.toStdString()}, {"reason", std::move(reason)}});
}

Result<DriveEndpoint> parseWeb(const QUrl& url, DriveEndpoint::Kind kind)
{
    if (url.host().isEmpty())
        return invalid(url,
            AXISCOMP_TEXT(
                "Error", "the host is missing; write http://192.168.1.20 or http://host:8080"));
    if (url.toString(QUrl::RemoveAuthority).contains(u'@'))
        return invalid(url, barePassword);
    if (!(url.path().isEmpty() || url.path() == u"/") || url.hasQuery() || url.hasFragment())
        return invalid(url, AXISCOMP_TEXT("Error", "only host and port belong here, no path"));
    DriveEndpoint result;
    result.kind = kind;
    result.host = url.host().toStdString();
    const int port = url.port(kind == DriveEndpoint::Kind::Https ? 443 : 80);
    if (port == 0)
        return invalid(url, AXISCOMP_TEXT("Error", "port 0 cannot be reached"));
    result.port = static_cast<std::uint16_t>(port);
    result.user = url.userName(QUrl::FullyDecoded).toStdString();
    result.password = url.password(QUrl::FullyDecoded).toStdString();
    return result;
}

Result<DriveEndpoint> parseSerial(const QUrl& url)
{
    DriveEndpoint result;
    result.kind = DriveEndpoint::Kind::Serial;
    result.device = url.path(QUrl::FullyDecoded).toStdString();
    if (!url.host().isEmpty() || result.device.size() < 2 || result.device.front() != '/')
        return invalid(url,
            AXISCOMP_TEXT(
                "Error", "the device must be an absolute path such as serial:/dev/ttyUSB0"));
    for (const auto& [key, value] : QUrlQuery(url).queryItems()) {
        bool isNumber = false;
        result.baud = value.toInt(&isNumber);
        if (key != u"baud" || !isNumber || result.baud <= 0)
            return invalid(url,
                AXISCOMP_TEXT(
                    "Error", "the only option is baud, as in serial:/dev/ttyUSB0?baud=115200"));
    }
    return result;
}

} // namespace

Result<DriveEndpoint> parseEndpoint(std::string_view text)
{
    const QString trimmed =
        QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).trimmed();
    if (trimmed == u"demo:" || trimmed == u"demo") {
        DriveEndpoint demo;
        demo.kind = DriveEndpoint::Kind::Demo;
        return demo;
    }
    const QUrl url(trimmed, QUrl::StrictMode);
    const QString scheme = url.scheme();
    if (url.isValid() && scheme == u"http")
        return parseWeb(url, DriveEndpoint::Kind::Http);
    if (url.isValid() && scheme == u"https")
        return parseWeb(url, DriveEndpoint::Kind::Https);
    if (url.isValid() && scheme == u"serial")
        return parseSerial(url);
    // What follows the last @ cannot be a password.
    const QString shown = trimmed.section(u'@', -1);
    const bool isWeb = trimmed.startsWith(u"http://") || trimmed.startsWith(u"https://");
    return fail(ErrorCode::InvalidEndpoint,
        {{"endpoint", shown.toStdString()},
            {"reason",
                isWeb && shown != trimmed
                    ? barePassword
                    : AXISCOMP_TEXT("Error",
                        "write http://host[:port], https://host[:port], serial:/dev/ttyUSB0 or "
                        "demo:")}});
}

std::string displayText(const DriveEndpoint& endpoint)
{
    switch (endpoint.kind) {
    case DriveEndpoint::Kind::Demo:
        return "demo:";
    case DriveEndpoint::Kind::Serial:
        return "serial:" + endpoint.device
            + (endpoint.baud == 115200 ? "" : "?baud=" + std::to_string(endpoint.baud));
    case DriveEndpoint::Kind::Http:
    case DriveEndpoint::Kind::Https:
        break;
    }
    const bool secure = endpoint.kind == DriveEndpoint::Kind::Https;
    const bool isIPv6 = endpoint.host.find(':') != std::string::npos;
    std::string text = secure ? "https://" : "http://";
    text += isIPv6 ? "[" + endpoint.host + "]" : endpoint.host;
    if (endpoint.port != (secure ? 443 : 80))
        text += ":" + std::to_string(endpoint.port);
    return text;
}

} // namespace axiscomp::drivecomm
