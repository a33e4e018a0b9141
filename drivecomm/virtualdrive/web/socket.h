// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/io/file_descriptor.h"

#include <cstdint>
#include <string>

namespace axiscomp::drivecomm {

/// A connection, or what waits for one.
using Socket = FileDescriptor;

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
