// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "drivecomm/virtualdrive/faults.h"

#include <cstdint>
#include <memory>
#include <string>

namespace axiscomp::drivecomm {

/// Passes bytes between the clients of a server and the server, which listens on a loopback port of
/// its own. Here connections break: at an exact byte (FaultPlan::bytesUntilDrop), without a reply,
/// with a garbled one; and here they all end at once when the server stops. Has one thread.
class ConnectionRelay {
public:
    /// faults must outlive the relay. Errors: InvalidEndpoint (endpoint = host:port, reason).
    [[nodiscard]] static Result<std::unique_ptr<ConnectionRelay>> start(
        const std::string& host, std::uint16_t port, std::uint16_t serverPort, FaultPlan& faults);
    ~ConnectionRelay();

    [[nodiscard]] std::uint16_t port() const;

    enum class Fate {
        Silent, ///< nothing more reaches the client, until it gives up
        Cut, ///< closed at once
        GarbledHead, ///< the next reply begins with flipped bits
    };
    /// What happens to the connection that reaches the server from this port. Takes effect before
    /// anything that the server sends afterwards.
    void decide(std::uint16_t serverSidePort, Fate fate);

private:
    struct Private;
    explicit ConnectionRelay(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::drivecomm
