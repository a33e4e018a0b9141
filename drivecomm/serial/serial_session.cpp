// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/serial_session.h"

#include "drivecomm/codec/json_parsing.h"

#include <algorithm>
#include <random>

namespace axiscomp::drivecomm {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto patience = 500ms; ///< a drive answers in this time, or the line has lost something
constexpr auto garbledPatience = 60ms; ///< the end of a reply that has to be asked for again
constexpr auto pauseBetweenBlocks = 150ms;
constexpr auto pauseInBlock = 1200ms;
constexpr int attemptsToFind = 3;
constexpr std::size_t heardKept = 256;
constexpr std::uint32_t mostLines = 256;

std::uint16_t randomNumber()
{
    std::random_device device;
    return static_cast<std::uint16_t>(device() & 0xFFFFU);
}

bool isIntact(const SerialLine& line)
{
    return line.state == SerialLine::State::Good && line.hasCrc;
}

bool isOfAnEarlier(std::optional<std::uint16_t> number, std::uint16_t current)
{
    constexpr std::uint16_t recent = 64;
    return number && *number != current && static_cast<std::uint16_t>(current - *number) < recent;
}

} // namespace

SerialSession::SerialSession(const DriveEndpoint& endpoint)
    : m_name(displayText(endpoint))
    , m_baud(endpoint.baud)
    , m_line(endpoint)
    , m_number(randomNumber())
{
}

std::uint16_t SerialSession::nextNumber()
{
    if (++m_number == 0)
        ++m_number;
    return m_number;
}

Error SerialSession::failed(Error error)
{
    error.context.setIfMissing("endpoint", m_name);
    if (error.code == ErrorCode::Timeout || error.code == ErrorCode::ConnectionLost)
        m_isSynced = false;
    return error;
}

tl::unexpected<Error> SerialSession::lost(Text reason, std::string detail)
{
    return fail(failed(
        Error{ErrorCode::ConnectionLost, {{"reason", std::move(reason)}}, std::move(detail)}));
}

tl::unexpected<Error> SerialSession::unexpected(
    Text expected, const std::vector<std::string>& words) const
{
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return fail(ErrorCode::Protocol,
        {{"endpoint", m_name}, {"expected", std::move(expected)}, {"quote", quoteOf(text)}});
}

Result<void> SerialSession::begin(ExchangeDeadline& running)
{
    if (running.isStopped())
        return fail(ErrorCode::Cancelled);
    m_progress = 0;
    if (m_isSynced && m_line.isOpen()) {
        auto idle = dropLateReplies(running);
        if (idle || idle.error().code != ErrorCode::ConnectionLost)
            return idle ? checkDrive() : idle;
    }
    m_isSynced = false; // or the port has gone since, and may be back
    if (!m_line.isOpen())
        if (auto opened = m_line.open(); !opened)
            return opened;
    m_input.clear();
    m_heard.clear();
    m_assembler.clear();
    if (auto found = find(running); !found) {
        m_line.close(); // other programs may have more use for it
        return found;
    }
    return checkDrive();
}

Result<void> SerialSession::dropLateReplies(const ExchangeDeadline& running)
{
    m_assembler.clear();
    while (true) {
        const auto late = receive(Clock::now(), running);
        if (!late)
            return fail(failed(late.error()));
        if (late->empty())
            return {};
    }
}

Result<void> SerialSession::checkDrive()
{
    if (!m_expected)
        m_expected = m_identity.serialNumber;
    if (*m_expected == m_identity.serialNumber)
        return {};
    return fail(
        ErrorCode::OtherDrive, {{"expected", *m_expected}, {"found", m_identity.serialNumber}});
}

Result<void> SerialSession::find(ExchangeDeadline& running)
{
    Request request;
    request.words = "identify";
    const auto isNoDrive = [&] {
        return unexpected(
            AXISCOMP_TEXT("Error", "the reply of a drive at {speed} baud").with("speed", m_baud),
            {m_heard});
    };
    for (int attempt = 0;; ++attempt) {
        request.number = nextNumber();
        auto sent = attempt == 0 ? Result<void>() : leaveTransfer(attempt, running);
        if (sent)
            sent = send(request, attempt == 0 ? std::string_view() : serialLineEnd, running);
        auto reply = sent ? collect(request, running)
                          : Result<std::optional<SerialReply>>(fail(sent.error()));
        if (!reply) {
            const bool wasNoDrive = reply.error().code == ErrorCode::Timeout && !m_heard.empty();
            return wasNoDrive ? isNoDrive() : fail(failed(reply.error()));
        }
        if (*reply) {
            const auto identity = parseSerialIdentity((*reply)->words);
            if (!identity)
                return unexpected(AXISCOMP_TEXT("Error", "name, serial number, axes and profile"),
                    (*reply)->words);
            m_identity = *identity;
            m_isSynced = true;
            ++m_beginnings;
            return {};
        }
        if (attempt + 1 >= attemptsToFind && !m_heard.empty())
            return isNoDrive();
    }
}

/// A drive that waits for a file takes what comes for a part of it, until there is a pause: the
/// second time one that even ends a block in its middle.
Result<void> SerialSession::leaveTransfer(int attempt, ExchangeDeadline& running)
{
    if (auto sent = m_line.write(asBytes(serialCancel), running); !sent)
        return sent;
    const auto pause = attempt == 1 ? pauseBetweenBlocks : pauseInBlock;
    const auto said = nextLine(Clock::now() + pause, running);
    return said ? Result<void>() : fail(said.error());
}

Result<void> SerialSession::send(
    const Request& request, std::string_view before, ExchangeDeadline& running)
{
    m_assembler.clear();
    const std::string text = std::string(before) + serialLine(request.number, request.words, true)
        + std::string(serialLineEnd);
    if (before.empty()) // a repeat has no time of its own
        running.deadline += m_line.timeFor(text.size());
    return m_line.write(asBytes(text), running);
}

Result<Bytes> SerialSession::receive(Clock::time_point until, const ExchangeDeadline& running)
{
    if (!m_input.empty()) {
        const ByteView bytes = asBytes(m_input);
        Bytes taken(bytes.begin(), bytes.end());
        m_input.clear();
        return taken;
    }
    auto bytes = m_line.read(until, running);
    if (bytes && !m_isSynced && m_heard.size() < heardKept)
        m_heard += asText(*bytes).substr(0, heardKept - m_heard.size());
    return bytes;
}

Result<std::string> SerialSession::nextLine(
    Clock::time_point until, const ExchangeDeadline& running)
{
    while (true) {
        for (std::size_t i = 0; i < m_input.size(); ++i) {
            if (auto line = m_assembler.feed(m_input[i])) {
                m_input.erase(0, i + 1);
                return *line;
            }
        }
        m_input.clear();
        AXISCOMP_TRY(const auto bytes, receive(until, running));
        if (bytes.empty())
            return std::string();
        m_input = asText(bytes);
    }
}

/// How many lines follow this one.
Result<std::size_t> SerialSession::linesBehind(const Request& request, const SerialLine& line) const
{
    if (line.words.front() != request.answer)
        return unexpected(Verbatim{request.answer}, line.words);
    if (!request.hasLines)
        return 0;
    const auto count = line.words.size() < 2 ? std::nullopt : parseSerialNumber(line.words[1]);
    if (!count || *count > mostLines)
        return unexpected(AXISCOMP_TEXT("Error", "the number of lines that follow"), line.words);
    return *count;
}

/// Nothing when the reply did not come, or not intact.
Result<std::optional<SerialReply>> SerialSession::collect(
    const Request& request, ExchangeDeadline& running)
{
    SerialReply reply;
    std::size_t expectedLines = 0; // behind the first one; 0: that one is not there
    std::uint16_t crc = 0; // of the line before
    bool isGarbledReply = false;
    auto lastHeard = Clock::now() + m_line.timeFor(request.words.size());
    while (true) {
        AXISCOMP_TRY(const auto text,
            nextLine(lastHeard + (isGarbledReply ? garbledPatience : patience), running));
        if (text.empty())
            return std::nullopt;
        lastHeard = Clock::now();
        SerialLine line = parseSerialLine(text, crc);
        if (expectedLines > 0 && isIntact(line) && line.number == request.number) {
            running.deadline += m_line.timeFor(text.size());
            crc = line.crc;
            reply.lines.push_back(std::move(line.words));
            if (reply.lines.size() == expectedLines)
                return reply;
            continue;
        }
        line = parseSerialLine(text);
        if (!isIntact(line)) {
            isGarbledReply = true;
            expectedLines = 0; // those behind it would come to be in its place
            continue;
        }
        if (line.words.front() == serialBootWord)
            return lost(AXISCOMP_TEXT("Error", "the drive rebooted"));
        if (line.words.size() > 1 && line.words[0] == "error" && line.words[1] == serialBadCrc) {
            if (isOfAnEarlier(line.number, request.number))
                continue; // the end of a transfer that was begun anew
            if (!request.endsTransfer || line.number != request.number)
                return std::nullopt;
        }
        if (line.number != request.number)
            continue;
        // Only what was asked for has time of its own: other talk must not keep this alive.
        running.deadline += m_line.timeFor(text.size());
        if (auto error = parseSerialError(line.words))
            return fail(failed(*std::move(error)));
        if (line.words.front() != "ok" && line.words.front() != "ready")
            continue;
        AXISCOMP_TRY(expectedLines, linesBehind(request, line));
        crc = line.crc;
        isGarbledReply = false; // it begins anew
        reply = {{line.words.begin() + 1, line.words.end()}, {}};
        if (expectedLines == 0)
            return reply;
    }
}

Result<SerialReply> SerialSession::repeatUntilAnswered(
    const Request& request, bool isSent, ExchangeDeadline& running)
{
    while (true) {
        if (!isSent)
            if (auto sent = send(request, {}, running); !sent)
                return fail(failed(sent.error()));
        auto reply = collect(request, running);
        if (!reply)
            return fail(failed(reply.error()));
        if (*reply)
            return **std::move(reply);
        // Whatever half a line the drive may have.
        if (auto sent = send(request, serialLineEnd, running); !sent)
            return fail(failed(sent.error()));
        isSent = true;
    }
}

Result<SerialReply> SerialSession::ask(
    const std::string& words, Shape shape, ExchangeDeadline& running)
{
    AXISCOMP_CHECK(begin(running));
    Request request;
    request.number = nextNumber();
    request.words = words;
    request.hasLines = shape == Shape::Lines;
    return repeatUntilAnswered(request, false, running);
}

} // namespace axiscomp::drivecomm
