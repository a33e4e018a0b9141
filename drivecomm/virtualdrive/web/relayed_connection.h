// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/web/connection_relay.h"
#include "drivecomm/virtualdrive/web/socket.h"

#include <poll.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace axiscomp::drivecomm {

/// Bytes on their way from one socket to the other.
struct RelayLane {
    std::vector<char> bytes;
    std::size_t begin = 0;
    bool sourceEnded = false;
    bool endPassedOn = false;
    bool discards = false;

    [[nodiscard]] bool isEmpty() const { return begin == bytes.size(); }
    [[nodiscard]] bool wantsToRead() const { return !sourceEnded && isEmpty(); }
};

/// A client, and the connection by which the server is asked for it.
struct RelayedConnection {
    Socket client;
    Socket server;
    std::uint16_t serverSidePort = 0;
    RelayLane request;
    RelayLane reply;
    std::optional<ConnectionRelay::Fate> fate;
    std::chrono::steady_clock::time_point lastPassed = std::chrono::steady_clock::now();
    std::optional<std::chrono::steady_clock::time_point> endRequestAt;
    std::optional<std::chrono::steady_clock::time_point> closeAt;
    std::optional<std::chrono::steady_clock::time_point>
        replyWaitsSince; ///< the client does not take it
    std::chrono::steady_clock::time_point waitsSince =
        std::chrono::steady_clock::now(); ///< for a request that is complete
    bool answersRequest = false; ///< the server has it
    bool hasReplied = false; ///< and nothing was asked since
    bool isDead = false;

    /// A client has this time for its request before another one may take its place.
    static constexpr std::chrono::milliseconds protection{250};

    [[nodiscard]] std::chrono::steady_clock::time_point replaceableAt() const
    {
        return waitsSince + protection;
    }
};

/// What poll shall wait for at socket.
[[nodiscard]] pollfd watch(
    const Socket& socket, const RelayLane& readFrom, const RelayLane& writtenTo);
/// False when the connection is broken.
[[nodiscard]] bool readInto(RelayLane& lane, const Socket& source);

} // namespace axiscomp::drivecomm
