// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/serial/serial_codec.h"
#include "drivecomm/serial/serial_port.h"
#include "drivecomm/serial/ymodem.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

struct SerialReply {
    std::vector<std::string> words; ///< after "ok" or "ready"
    std::vector<std::vector<std::string>> lines;
};

/// Requests and file transfers over a serial port: numbers, CRCs, repeats and resynchronisation.
/// A request whose reply did not come, or came garbled, is repeated with its number, which the
/// drive answers from memory. A transfer that broke is begun again. The time that the line needs
/// for a request, its reply and the bytes of a file is added to the deadline of the exchange; what
/// is repeated, and what nobody asked for, has no time of its own.
///
/// Errors common to all: those of SerialPortLine; Timeout when nothing answers, Protocol when
/// something does that is no drive; ConnectionLost when the drive rebooted, or the line garbles too
/// much; what the drive refuses.
class SerialSession {
public:
    explicit SerialSession(const DriveEndpoint& endpoint);

    /// Opens the port where it is not open, and finds the drive behind it, by nothing but
    /// `identify`. Every other function begins with this. Errors: OtherDrive when the port was
    /// lost in the meantime, and now leads to another drive than before.
    [[nodiscard]] Result<void> begin(ExchangeDeadline& running);
    /// From here on another drive than the one that answered first is welcome.
    void expectAnyDrive() { m_expected.reset(); }
    /// What `identify` said.
    void expect(const DriveIdentity& identity)
    {
        m_identity = identity;
        m_expected = identity.serialNumber;
    }
    /// As begin() found it.
    [[nodiscard]] const DriveIdentity& identity() const { return m_identity; }
    /// How often begin() has found a drive: what was known of it may have changed since.
    [[nodiscard]] int beginnings() const { return m_beginnings; }

    enum class Shape { Words, Lines };
    [[nodiscard]] Result<SerialReply> ask(
        const std::string& words, Shape shape, ExchangeDeadline& running);
    [[nodiscard]] Result<void> put(
        const std::string& path, ByteView bytes, ExchangeDeadline& running);
    [[nodiscard]] Result<Bytes> take(
        const std::string& path, std::uint64_t limit, ExchangeDeadline& running);

    /// Protocol, with what a drive would have said.
    [[nodiscard]] tl::unexpected<Error> unexpected(
        Text expected, const std::vector<std::string>& words) const;

private:
    struct Request {
        std::uint16_t number = 0;
        std::string words;
        std::string answer = "ok"; ///< the first word of a good reply
        bool hasLines = false;
        bool endsTransfer = false; ///< BadCrc is about the file, not about the line
    };
    [[nodiscard]] Result<void> find(ExchangeDeadline& running);
    [[nodiscard]] Result<void> leaveTransfer(int attempt, ExchangeDeadline& running);
    [[nodiscard]] Result<void> dropLateReplies(const ExchangeDeadline& running);
    [[nodiscard]] Result<void> checkDrive();
    [[nodiscard]] std::uint16_t nextNumber();
    [[nodiscard]] Result<void> send(
        const Request& request, std::string_view before, ExchangeDeadline& running);
    [[nodiscard]] Result<std::size_t> linesBehind(
        const Request& request, const SerialLine& line) const;
    [[nodiscard]] Result<std::optional<SerialReply>> collect(
        const Request& request, ExchangeDeadline& running);
    [[nodiscard]] Result<SerialReply> repeatUntilAnswered(
        const Request& request, bool isSent, ExchangeDeadline& running);
    struct Started {
        std::uint16_t number = 0;
        SerialReply reply;
    };
    [[nodiscard]] Result<Started> start(const std::string& words, ExchangeDeadline& running);
    [[nodiscard]] Result<std::string> nextLine(
        std::chrono::steady_clock::time_point until, const ExchangeDeadline& running);
    [[nodiscard]] Result<Bytes> receive(
        std::chrono::steady_clock::time_point until, const ExchangeDeadline& running);
    template <typename Machine, typename Position>
    [[nodiscard]] Result<void> transfer(
        Machine& machine, Position position, std::uint64_t total, ExchangeDeadline& running);
    [[nodiscard]] std::chrono::nanoseconds timeForFile(std::uint64_t size) const;
    void settle(std::uint16_t number);
    [[nodiscard]] std::optional<Error> finalError(std::uint16_t number);
    void reportProgress(std::uint64_t done, std::uint64_t total, const ExchangeDeadline& running);
    [[nodiscard]] Error failed(Error error);
    [[nodiscard]] tl::unexpected<Error> lost(Text reason, std::string detail = {});

    std::string m_name;
    int m_baud;
    SerialPortLine m_line;
    SerialLineAssembler m_assembler;
    std::string m_input; ///< received and not yet looked at
    std::string m_heard; ///< the beginning of what came while looking for a drive
    DriveIdentity m_identity;
    std::optional<std::int32_t> m_expected; ///< serial number
    std::uint16_t m_number;
    std::uint64_t m_progress = 0;
    bool m_isSynced = false; ///< drive and link agree on where lines begin
    int m_beginnings = 0;
};

} // namespace axiscomp::drivecomm
