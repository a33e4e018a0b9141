// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <utility>

namespace axiscomp::drivecomm {

/// A file descriptor that closes itself.
class Socket {
public:
    Socket() = default;
    explicit Socket(int descriptor) : m_descriptor(descriptor) { }
    Socket(Socket&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) { }
    Socket& operator=(Socket&& other) noexcept
    {
        std::swap(m_descriptor, other.m_descriptor);
        return *this;
    }
    ~Socket() { close(); }

    [[nodiscard]] int get() const { return m_descriptor; }
    [[nodiscard]] bool isOpen() const { return m_descriptor >= 0; }
    void close();

private:
    int m_descriptor = -1;
};

/// All non-blocking, without Nagle's delay.
/// Errors: InvalidEndpoint (endpoint, reason).
[[nodiscard]] Result<Socket> listenOn(const std::string& host, std::uint16_t port);
[[nodiscard]] Socket acceptFrom(const Socket& listener);
/// The connection may still be on its way; writing waits for it.
[[nodiscard]] Socket connectToLoopback(std::uint16_t port);
[[nodiscard]] std::uint16_t localPort(const Socket& socket);
/// Whether it listens to this computer only.
[[nodiscard]] bool isOnLoopback(const Socket& socket);

/// "127.0.0.1:80", "[::1]:80"
[[nodiscard]] std::string hostAndPort(const std::string& host, std::uint16_t port);

} // namespace axiscomp::drivecomm
