// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/crc16.h"
#include "drivecomm/serial/ymodem.h"

#include <algorithm>

namespace axiscomp::drivecomm::ymodem {

namespace {

constexpr std::size_t junkKept = 16;
constexpr std::chrono::seconds promptInterval{1};
/// The file is whole by then: the sender may have gone without an empty header.
constexpr int promptsAtTheEnd = 3;

bool endsWithCancel(ByteView junk)
{
    std::size_t cancels = 0;
    for (const std::byte byte : junk) {
        const auto value = std::to_integer<std::uint8_t>(byte);
        if (value == can)
            ++cancels;
        else if (value != backspace)
            cancels = 0;
    }
    return cancels >= 2;
}

} // namespace

Receiver::Receiver(std::uint64_t limit, std::optional<std::uint64_t> expectedSize,
    Clock::time_point now, const Patience& patience)
    : Machine(patience)
    , m_limit(limit)
    , m_expectedSize(expectedSize)
    , m_giveUpStart(now + m_patience.start)
{
    send(promptCrc);
    m_wakeAt = now + promptInterval;
}

std::size_t Receiver::feed(ByteView received, Clock::time_point now)
{
    for (std::size_t i = 0; i < received.size(); ++i) {
        take(received[i], now);
        if (!isRunning())
            return i + 1;
    }
    return received.size();
}

void Receiver::take(std::byte byte, Clock::time_point now)
{
    if (m_inJunk) {
        if (m_junk.size() == junkKept)
            m_junk.erase(m_junk.begin());
        m_junk.push_back(byte);
        m_wakeAt = now + m_patience.quiet;
        return;
    }
    if (m_block.empty())
        return takeFirst(std::to_integer<std::uint8_t>(byte), now);
    m_block.push_back(byte);
    m_wakeAt = now + m_patience.between;
    if (m_block.size() == m_blockLength)
        blockArrived(now);
}

void Receiver::takeFirst(std::uint8_t byte, Clock::time_point now)
{
    if (byte == can && m_sawCancel)
        return end(State::Cancelled);
    m_sawCancel = byte == can;
    switch (byte) {
    case soh:
    case stx:
        m_block = {static_cast<std::byte>(byte)};
        m_blockLength = (byte == stx ? longBlock : shortBlock) + blockOverhead;
        m_wakeAt = now + m_patience.between;
        return;
    case eot:
        return endArrived(now);
    case can:
    case '\r': // the end of the line that asked for the transfer
    case '\n':
        return;
    default:
        m_inJunk = true;
        m_junk = {static_cast<std::byte>(byte)};
        m_wakeAt = now + m_patience.quiet;
    }
}

void Receiver::blockArrived(Clock::time_point now)
{
    const Bytes block = std::exchange(m_block, {});
    const auto at = [&](std::size_t i) { return std::to_integer<unsigned>(block[i]); };
    const ByteView content = ByteView(block).subspan(3, block.size() - blockOverhead);
    const unsigned crc = (at(block.size() - 2) << 8U) | at(block.size() - 1);
    if (at(1) + at(2) != 0xFFU) {
        // The first byte may be garbled too, and with it the length.
        m_inJunk = true;
        m_junk.assign(block.end() - static_cast<std::ptrdiff_t>(junkKept), block.end());
        m_wakeAt = now + m_patience.quiet;
        return;
    }
    if (crc16(content, crcXmodem) != crc)
        return askAgain(now);
    const auto number = static_cast<std::uint8_t>(at(1));
    if (m_step == Step::Data)
        return dataArrived(number, content, now);
    if (number != 0)
        return askAgain(now);
    headerArrived(content, now);
}

void Receiver::headerArrived(ByteView content, Clock::time_point now)
{
    const auto header = parseHeader(content);
    if (!header)
        return giveUp("the header of the file makes no sense");
    if (m_step == Step::LastHeader) {
        if (!header->name.empty())
            return giveUp("more than one file was sent");
        send(ack);
        return end(State::Done);
    }
    if (header->name.empty() && !header->size)
        return giveUp("no file was sent");
    m_header = *header;
    if (!m_header.size)
        m_header.size = m_expectedSize;
    if (m_header.size.value_or(0) > m_limit)
        return giveUp("the file is too large");
    m_step = Step::Data;
    acknowledge(true, now);
}

void Receiver::dataArrived(std::uint8_t number, ByteView content, Clock::time_point now)
{
    if (number == static_cast<std::uint8_t>(m_expected - 1)) // the answer to it was lost
        return acknowledge(m_file.empty() && number == 0, now);
    if (number != m_expected)
        return giveUp("the blocks are out of order");
    std::uint64_t count = content.size();
    if (m_header.size)
        count = std::min<std::uint64_t>(count, *m_header.size - m_file.size());
    if (m_file.size() + count > m_limit)
        return giveUp("the file is too large");
    m_file.insert(
        m_file.end(), content.begin(), content.begin() + static_cast<std::ptrdiff_t>(count));
    ++m_expected;
    m_sawEnd = false;
    acknowledge(false, now);
}

bool Receiver::isComplete() const
{
    return m_step == Step::Data && m_header.size && m_file.size() == *m_header.size;
}

/// A single byte without a check: it must fit the size, or come twice where that is not known.
void Receiver::endArrived(Clock::time_point now)
{
    if (m_step == Step::LastHeader)
        return acknowledge(true, now);
    if (isComplete() || (m_step == Step::Data && !m_header.size && m_sawEnd)) {
        m_step = Step::LastHeader;
        return acknowledge(true, now);
    }
    m_sawEnd = true;
    askAgain(now);
}

void Receiver::acknowledge(bool promptsForMore, Clock::time_point now)
{
    m_failures = 0;
    send(ack);
    if (promptsForMore)
        send(promptCrc);
    m_wakeAt =
        now + (promptsForMore ? std::chrono::milliseconds(promptInterval) : m_patience.answer);
}

void Receiver::askAgain(Clock::time_point now)
{
    if (++m_failures > m_patience.repeats)
        return giveUp("one block did not arrive in " + std::to_string(m_failures) + " attempts");
    const bool prompts = m_step != Step::Data || (m_file.empty() && m_expected == 1);
    send(prompts ? promptCrc : nak);
    m_wakeAt = now + (prompts ? std::chrono::milliseconds(promptInterval) : m_patience.answer);
}

void Receiver::junkEnded(Clock::time_point now)
{
    m_inJunk = false;
    if (endsWithCancel(std::exchange(m_junk, {})))
        return end(State::Cancelled);
    askAgain(now);
}

void Receiver::tick(Clock::time_point now)
{
    if (!isRunning() || now < m_wakeAt)
        return;
    if (m_inJunk)
        return junkEnded(now);
    if (!m_block.empty()) {
        // Cut off: the last bytes tell whether the sender gave up.
        m_junk = std::exchange(m_block, {});
        return junkEnded(now);
    }
    if (m_step == Step::LastHeader && m_failures >= promptsAtTheEnd)
        return end(State::Done);
    if (m_step == Step::Header) {
        if (now >= m_giveUpStart)
            return giveUp("the sender did not begin");
        send(promptCrc);
        m_wakeAt = now + promptInterval;
        return;
    }
    if (m_failures >= m_patience.repeats / 3)
        return giveUp("the sender does not send any more");
    askAgain(now);
}

} // namespace axiscomp::drivecomm::ymodem
