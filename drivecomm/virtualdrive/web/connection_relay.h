// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "drivecomm/virtualdrive/faults.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace axiscomp::drivecomm {

/// Passes bytes between the clients of a server and the server, which listens on a loopback port of
/// its own. Here connections break: at an exact byte (FaultPlan::bytesUntilDrop), without a reply,
/// with a garbled one; and here they all end at once when the server stops. Has one thread.
///
/// There is always room for one more client: at the limit of connections, or of file descriptors,
/// the one goes that has waited longest for a request of its own.
class ConnectionRelay {
public:
    static constexpr std::size_t mostConnections = 256;

    /// faults must outlive the relay; patience: for a client that does not take 64 KiB of a reply.
    /// Errors: InvalidEndpoint (endpoint = host:port, reason).
    [[nodiscard]] static Result<std::unique_ptr<ConnectionRelay>> start(const std::string& host,
        std::uint16_t port, std::uint16_t serverPort, FaultPlan& faults,
        std::chrono::milliseconds patience);
    ~ConnectionRelay();

    [[nodiscard]] std::uint16_t port() const;
    [[nodiscard]] bool isOnLoopback() const;

    /// Ends all connections and takes no more. What the server still decides has no effect.
    void stop();

    enum class Fate {
        Silent, ///< nothing more reaches the client, until it gives up
        Cut, ///< closed at once
        GarbledHead, ///< the next reply begins with flipped bits
    };
    /// What happens to the connection that reaches the server from this port. Takes effect before
    /// anything that the server sends afterwards.
    void decide(std::uint16_t serverSidePort, Fate fate);

    /// The server has the whole request of the connection that reaches it from this port: no other
    /// client takes its place before the reply.
    void keepUntilReply(std::uint16_t serverSidePort);

private:
    struct Private;
    explicit ConnectionRelay(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::drivecomm
