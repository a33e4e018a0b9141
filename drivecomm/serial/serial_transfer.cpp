// SPDX-License-Identifier: GPL-3.0-or-later
// The file transfers of SerialSession.
#include "drivecomm/codec/error_json.h"
#include "drivecomm/serial/serial_session.h"

namespace axiscomp::drivecomm {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto cancelTimeout = 1500ms; ///< for the drive to leave a broken transfer
constexpr int attemptsToStart = 6;
constexpr int attemptsToTransfer = 4;

constexpr TextPattern tooGarbled =
    AXISCOMP_TEXT("Error", "the line garbles too much; check the cable, or try a lower baud rate");

/// It arrived garbled, and the drive has done nothing.
bool isGarbled(const Error& error)
{
    return error.detail == serialBadCrc;
}

std::string fileNameOf(const std::string& path)
{
    return path.substr(path.rfind('/') + 1);
}

/// A drive that is there begins, and goes on, without a person.
ymodem::Patience patienceWithDrive()
{
    ymodem::Patience patience;
    patience.start = 5s;
    return patience;
}

} // namespace

/// Each attempt has a number of its own: nothing has been done yet, and a drive that has begun must
/// leave its transfer first.
Result<SerialSession::Started> SerialSession::start(
    const std::string& words, ExchangeDeadline& running)
{
    for (int attempt = 0; attempt < attemptsToStart; ++attempt) {
        Request request;
        request.number = nextNumber();
        request.words = words;
        request.answer = "ready";
        const std::string before =
            attempt == 0 ? "" : std::string(serialCancel) + std::string(serialLineEnd);
        if (auto sent = send(request, before, running); !sent)
            return fail(failed(sent.error()));
        auto reply = collect(request, running);
        if (!reply) {
            if (reply.error().code == ErrorCode::Cancelled
                || reply.error().code == ErrorCode::Timeout)
                settle(request.number);
            return fail(failed(reply.error()));
        }
        if (*reply)
            return Started{request.number, **std::move(reply)};
    }
    return lost(tooGarbled, "no answer to " + words);
}

/// With blocks, their acknowledgements and some that are sent twice.
std::chrono::nanoseconds SerialSession::timeForFile(std::uint64_t size) const
{
    constexpr std::uint64_t beginAndEnd = 4096;
    return m_line.timeFor(size + size / 8 + beginAndEnd);
}

template <typename Machine, typename Position>
Result<void> SerialSession::transfer(
    Machine& machine, Position position, std::uint64_t total, ExchangeDeadline& running)
{
    running.deadline += timeForFile(total);
    while (true) {
        const Bytes output = machine.output();
        Result<void> done;
        if (!output.empty())
            done = m_line.write(output, running);
        if (done && !machine.isRunning())
            return {};
        Result<Bytes> came = Bytes{};
        if (done)
            came = receive(machine.wakeAt(), running);
        if (!done || !came)
            return fail(done ? came.error() : done.error());
        if (came->empty()) {
            machine.tick(Clock::now());
            continue;
        }
        const std::size_t used = machine.feed(*came, Clock::now());
        m_input = asText(ByteView(*came).subspan(used));
        reportProgress(position(), total, running);
    }
}

void SerialSession::reportProgress(
    std::uint64_t done, std::uint64_t total, const ExchangeDeadline& running)
{
    if (done <= m_progress)
        return;
    m_progress = done;
    if (running.exchange.progress)
        running.exchange.progress(done, total);
}

/// Tells the drive to leave the transfer, and waits until it has: the user's stop and the deadline
/// do not count here.
void SerialSession::settle(std::uint16_t number)
{
    if (!m_line.isOpen())
        return;
    Exchange exchange;
    exchange.timeout = cancelTimeout;
    ExchangeDeadline running(exchange);
    running.deadline += 2 * m_line.timeFor(2048); // a block on its way
    m_isSynced =
        m_line.write(asBytes(serialCancel), running).has_value() && finalError(number).has_value();
}

/// Why the drive left a transfer. Nothing when it does not say it.
std::optional<Error> SerialSession::finalError(std::uint16_t number)
{
    Exchange exchange;
    exchange.timeout = cancelTimeout;
    ExchangeDeadline running(exchange);
    running.deadline += 2 * m_line.timeFor(2048);
    m_assembler.clear();
    while (true) {
        const auto text = nextLine(running.deadline, running);
        if (!text || text->empty())
            return std::nullopt;
        const SerialLine line = parseSerialLine(*text);
        if (line.state != SerialLine::State::Good || !line.hasCrc || line.number != number)
            continue;
        return parseSerialError(line.words);
    }
}

Result<void> SerialSession::put(const std::string& path, ByteView bytes, ExchangeDeadline& running)
{
    if (auto begun = begin(running); !begun)
        return begun;
    const std::string words = "put " + serialWord(path) + " " + std::to_string(bytes.size()) + " "
        + serialCrc32(crc32(bytes));
    std::string history;
    for (int attempt = 0; attempt < attemptsToTransfer; ++attempt) {
        AXISCOMP_TRY(const auto started, start(words, running));
        ymodem::Sender sender(fileNameOf(path), bytes, Clock::now(), patienceWithDrive());
        const auto sent = transfer(
            sender, [&] { return sender.acknowledged(); }, bytes.size(), running);
        if (!sent) {
            settle(started.number);
            return fail(failed(sent.error()));
        }
        if (sender.state() != ymodem::State::Done) {
            const auto reason = finalError(started.number);
            if (reason && !isGarbled(*reason))
                return fail(failed(*reason));
            history +=
                sender.failure() + " / " + (reason ? driveMessage(*reason).english() : "-") + "; ";
            continue;
        }
        Request end;
        end.number = started.number;
        end.words = words;
        end.endsTransfer = true;
        const auto reply = repeatUntilAnswered(end, true, running);
        if (reply)
            return {};
        if (reply.error().code == ErrorCode::Protocol) { // "ready": it has forgotten the transfer
            settle(started.number);
            return lost(AXISCOMP_TEXT("Error", "the drive began anew"));
        }
        if (!isGarbled(reply.error()))
            return fail(reply.error());
        history += driveMessage(reply.error()).english() + "; ";
    }
    return lost(tooGarbled, history);
}

Result<Bytes> SerialSession::take(
    const std::string& path, std::uint64_t limit, ExchangeDeadline& running)
{
    AXISCOMP_CHECK(begin(running));
    std::string history;
    for (int attempt = 0; attempt < attemptsToTransfer; ++attempt) {
        AXISCOMP_TRY(const auto started, start("take " + serialWord(path), running));
        const auto& words = started.reply.words;
        const auto size = words.size() == 2 ? parseSerialNumber(words[0]) : std::nullopt;
        const auto crc = words.size() == 2 ? parseSerialNumber(words[1], 16) : std::nullopt;
        if (!size || !crc || *size > limit) {
            settle(started.number);
            return unexpected(
                AXISCOMP_TEXT("Error", "a size of at most {most} and a CRC").with("most", limit),
                words);
        }
        ymodem::Receiver receiver(*size, *size, Clock::now(), patienceWithDrive());
        const auto received = transfer(
            receiver, [&] { return receiver.received(); }, *size, running);
        if (!received) {
            settle(started.number);
            return fail(failed(received.error()));
        }
        if (receiver.state() == ymodem::State::Done) {
            Bytes file = receiver.takeFile();
            // The CRC says it all; what the drive says afterwards is not waited for.
            if (file.size() == *size && crc32(file) == *crc)
                return file;
            history += "the CRC-32 is wrong; ";
            continue;
        }
        const auto reason = finalError(started.number);
        if (reason && !isGarbled(*reason))
            return fail(failed(*reason));
        history +=
            receiver.failure() + " / " + (reason ? driveMessage(*reason).english() : "-") + "; ";
    }
    return lost(tooGarbled, history);
}

} // namespace axiscomp::drivecomm
