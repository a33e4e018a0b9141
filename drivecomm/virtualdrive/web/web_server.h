// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/faults.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace axiscomp::drivecomm {

struct WebServerOptions {
    std::string host = "127.0.0.1"; ///< loopback unless told otherwise
    std::uint16_t port = 0; ///< 0: a free one
    std::string user; ///< both set: HTTP Basic authentication is asked for
    std::string password;
    std::string certificateFile; ///< PEM; both set: https
    std::string privateKeyFile;
    /// What a client may take for a request, or for its reply, beyond 8 KiB/s.
    std::chrono::milliseconds patience{10'000};
};

/// The virtual drive's web server: the pages, files and registers of docs/protocol.md. Serves from
/// its own threads until it is destroyed.
class WebServer {
public:
    /// drive, profile and faults must outlive the server. Errors: InvalidEndpoint (address in use,
    /// ...).
    [[nodiscard]] static Result<std::unique_ptr<WebServer>> start(VirtualDrive& drive,
        const DriveProfile& profile, FaultPlan& faults, const WebServerOptions& options = {});
    ~WebServer();

    [[nodiscard]] std::uint16_t port() const;
    /// Whether no other computer reaches it.
    [[nodiscard]] bool isOnLoopbackOnly() const;
    /// "http://127.0.0.1:8080"
    [[nodiscard]] std::string url() const;

private:
    struct Private;
    explicit WebServer(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::drivecomm
