// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "drivecomm/link/drive_endpoint.h"
#include "drivecomm/link/exchange_deadline.h"

#include <memory>
#include <string>

class QSerialPort;

namespace axiscomp::drivecomm {

/// The bytes of a serial port, 8N1, blocking, for nobody else while it is open. Used on one thread,
/// which needs no event loop and may have one; a QCoreApplication must exist. Once the port has
/// failed it is closed, and can be opened again: a cable that was plugged in again may be there
/// under the same name.
class SerialPortLine {
public:
    explicit SerialPortLine(DriveEndpoint endpoint);
    ~SerialPortLine();
    SerialPortLine(const SerialPortLine&) = delete;
    SerialPortLine& operator=(const SerialPortLine&) = delete;

    [[nodiscard]] bool isOpen() const { return m_port != nullptr; }
    /// What was received before is thrown away. Errors: NotConnected with a sentence for each of:
    /// no such port, no permission (and the group that has it), used by another program, no serial
    /// port at all, a speed that it cannot do.
    [[nodiscard]] Result<void> open();
    void close();

    /// Returns when the system has taken all bytes. Errors: ConnectionLost, Cancelled, Timeout.
    [[nodiscard]] Result<void> write(ByteView bytes, const ExchangeDeadline& running);
    /// What has come, waiting until something does: empty at `until`. Errors: ConnectionLost,
    /// Cancelled, Timeout (at the exchange's deadline).
    [[nodiscard]] Result<Bytes> read(
        std::chrono::steady_clock::time_point until, const ExchangeDeadline& running);

    /// That the line itself needs for so many bytes: 10 bits each.
    [[nodiscard]] std::chrono::nanoseconds timeFor(std::uint64_t bytes) const;

private:
    [[nodiscard]] tl::unexpected<Error> notConnected(Argument reason, std::string detail = {});
    [[nodiscard]] tl::unexpected<Error> lost();
    [[nodiscard]] Result<void> check(const ExchangeDeadline& running);

    DriveEndpoint m_endpoint;
    std::string m_name;
    std::unique_ptr<QSerialPort> m_port;
    std::string m_failure; ///< Qt's words for what made the port unusable
};

} // namespace axiscomp::drivecomm
