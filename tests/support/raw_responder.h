// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace axiscomp::test {

/// One connection of a RawResponder. Every function returns at once when the responder ends.
class RawConnection {
public:
    virtual ~RawConnection() = default;

    /// A request with its body (by Content-Length); empty when the client has gone.
    virtual std::string readRequest() = 0;
    /// False when the client has gone.
    virtual bool send(std::string_view bytes) = 0;
    /// Waits so long, or until the client goes.
    virtual bool isStillThereAfter(std::chrono::milliseconds time) = 0;
    virtual void waitUntilGone() = 0;
    /// Closes with a reset instead of an end.
    virtual void reset() = 0;
};

/// A TCP server on a loopback port and a thread of its own, for answers that no HTTP server gives.
/// serve is called for one connection after the other, which is closed when it returns.
class RawResponder {
public:
    explicit RawResponder(std::function<void(RawConnection&)> serve);
    ~RawResponder();

    [[nodiscard]] std::uint16_t port() const;
    [[nodiscard]] std::string url() const;
    /// Requests read so far.
    [[nodiscard]] int requests() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// Takes requests and leaves them without an answer, for RawResponder.
void neverAnswer(RawConnection& connection);

/// A reply with Content-Length.
[[nodiscard]] std::string httpReply(
    std::string_view statusLine, std::string_view contentType, std::string_view body);

} // namespace axiscomp::test
