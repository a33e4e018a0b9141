// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// Where a drive is (docs/cli.md, "Rules that hold everywhere"):
/// http://[user:password@]host[:port], https://..., demo:, or serial:/dev/ttyUSB0[?baud=N].
struct DriveEndpoint {
    enum class Kind { Http, Https, Serial, Demo };
    Kind kind = Kind::Http;
    std::string host; ///< name, IPv4, or IPv6 without brackets; empty for Serial and Demo
    std::uint16_t port = 0; ///< Http 80, Https 443 unless given
    std::string user;
    std::string password;
    std::string device; ///< Serial: absolute path
    int baud = 115200;

    friend bool operator==(const DriveEndpoint&, const DriveEndpoint&) = default;
};

/// Errors: InvalidEndpoint with the reason; the password never appears in it.
[[nodiscard]] Result<DriveEndpoint> parseEndpoint(std::string_view text);

/// Without user and password: for messages, logs and settings. Default ports are left out.
[[nodiscard]] std::string displayText(const DriveEndpoint& endpoint);

} // namespace axiscomp::drivecomm
