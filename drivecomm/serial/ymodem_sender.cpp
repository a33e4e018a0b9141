// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/crc16.h"
#include "drivecomm/serial/ymodem.h"

#include <algorithm>

namespace axiscomp::drivecomm::ymodem {

namespace {

/// After a block that had to be repeated this often, the next ones are short.
constexpr int repeatsThatShorten = 2;
constexpr int shortBlocksThen = 24;
/// The file has arrived by then: the receiver may have gone, and its last answer with it (rb
/// empties its output when it ends).
constexpr int repeatsAtTheEnd = 2;

/// No answer of a receiver, but what a line of text begins with.
bool beginsLine(std::uint8_t byte)
{
    return byte == '#' || byte == '\r' || byte == '\n' || (byte >= 'a' && byte <= 'z');
}

} // namespace

Sender::Sender(std::string name, ByteView bytes, Clock::time_point now, const Patience& patience)
    : Machine(patience)
    , m_name(std::move(name))
    , m_bytes(bytes)
{
    m_wakeAt = now + m_patience.start;
}

std::size_t Sender::feed(ByteView received, Clock::time_point now)
{
    for (std::size_t i = 0; i < received.size(); ++i) {
        const std::uint8_t byte = std::to_integer<std::uint8_t>(received[i]);
        const bool isSecondCancel = byte == can && m_sawCancel;
        m_sawCancel = byte == can;
        if (isSecondCancel) {
            end(State::Cancelled);
            return i + 1;
        }
        if (m_step == Step::LastHeader && beginsLine(byte)) {
            end(State::Done); // the receiver has gone on, and its answer was lost
            return i;
        }
        m_hasSent = false;
        respond(byte, now);
        if (!isRunning())
            return i + 1;
        if (m_hasSent) // what came before a block cannot be the answer to it
            return received.size();
    }
    return received.size();
}

void Sender::respond(std::uint8_t byte, Clock::time_point now)
{
    switch (byte) {
    case ack:
        return acknowledge(now);
    case nak:
        if (m_step == Step::DataStart || m_step == Step::LastStart)
            return begin(m_step == Step::DataStart ? Step::Block : Step::LastHeader, now);
        if (m_step != Step::Start)
            repeat(now);
        return;
    case promptCrc:
        if (m_step == Step::Start)
            return begin(Step::Header, now);
        if (m_step == Step::DataStart)
            return begin(Step::Block, now);
        if (m_step == Step::End || m_step == Step::LastStart)
            return begin(Step::LastHeader, now);
        break;
    default:
        break;
    }
    if (m_step == Step::Start || m_step == Step::DataStart || m_step == Step::LastStart)
        return;
    // A garbled answer. Sending again is right whatever it was: the receiver knows a block that it
    // has by its number.
    m_isUnclear = true;
    m_wakeAt = std::min(m_wakeAt, now + m_patience.quiet);
}

void Sender::acknowledge(Clock::time_point now)
{
    switch (m_step) {
    case Step::Header:
        return begin(Step::DataStart, now);
    case Step::Block:
        m_acknowledged += m_blockSize;
        return begin(Step::Block, now);
    case Step::End:
        return begin(Step::LastStart, now);
    case Step::LastHeader:
        return end(State::Done);
    case Step::Start:
    case Step::DataStart:
    case Step::LastStart:
        return;
    }
}

void Sender::begin(Step step, Clock::time_point now)
{
    if (m_repeats >= repeatsThatShorten && m_step == Step::Block)
        m_shortBlocks = shortBlocksThen;
    m_step = step;
    m_repeats = 0;
    m_isUnclear = false;
    m_wakeAt = answerBy(now);
    switch (step) {
    case Step::Start:
    case Step::DataStart:
    case Step::LastStart:
        m_last.clear();
        return;
    case Step::Header:
        return sendBlock(0, headerContent(), 0, std::byte{0});
    case Step::Block:
        return sendNextBlock(now);
    case Step::End:
        m_last = {static_cast<std::byte>(eot)};
        return sendLast();
    case Step::LastHeader:
        return sendBlock(0, {}, 0, std::byte{0});
    }
}

void Sender::sendNextBlock(Clock::time_point now)
{
    const ByteView rest = m_bytes.subspan(static_cast<std::size_t>(m_acknowledged));
    if (rest.empty())
        return begin(Step::End, now);
    const bool isShort = rest.size() <= shortBlock || m_shortBlocks > 0;
    if (m_shortBlocks > 0)
        --m_shortBlocks;
    m_blockSize = std::min(rest.size(), isShort ? shortBlock : longBlock);
    ++m_number;
    sendBlock(m_number, rest.first(m_blockSize), isShort ? shortBlock : longBlock,
        static_cast<std::byte>(padding));
}

/// size 0: whatever holds the content. The content of a number never changes: the receiver may have
/// taken the block, and only its answer was lost.
void Sender::sendBlock(std::uint8_t number, ByteView content, std::size_t size, std::byte filler)
{
    if (size == 0)
        size = content.size() > shortBlock ? longBlock : shortBlock;
    m_last.clear();
    m_last.push_back(static_cast<std::byte>(size == longBlock ? stx : soh));
    m_last.push_back(static_cast<std::byte>(number));
    m_last.push_back(static_cast<std::byte>(~static_cast<unsigned>(number) & 0xFFU));
    m_last.insert(m_last.end(), content.begin(), content.end());
    m_last.resize(3 + size, filler);
    const std::uint16_t crc = crc16(ByteView(m_last).subspan(3), crcXmodem);
    m_last.push_back(static_cast<std::byte>(crc >> 8U));
    m_last.push_back(static_cast<std::byte>(crc & 0xFFU));
    sendLast();
}

void Sender::sendLast()
{
    send(m_last);
    m_hasSent = true;
}

/// When to ask again for the answer to the block that is sent now.
Clock::time_point Sender::answerBy(Clock::time_point now) const
{
    return now + (m_step == Step::LastHeader ? m_patience.between : m_patience.answer);
}

Bytes Sender::headerContent() const
{
    const std::string text =
        m_name.substr(0, longBlock / 2) + '\0' + std::to_string(m_bytes.size());
    const ByteView bytes = asBytes(text);
    Bytes content(bytes.begin(), bytes.end());
    content.push_back(std::byte{0});
    return content;
}

void Sender::repeat(Clock::time_point now)
{
    if (++m_repeats > m_patience.repeats)
        return giveUp("one block did not arrive in " + std::to_string(m_repeats) + " attempts");
    m_isUnclear = false;
    m_wakeAt = answerBy(now);
    sendLast();
}

void Sender::tick(Clock::time_point now)
{
    if (!isRunning() || now < m_wakeAt)
        return;
    switch (m_step) {
    case Step::Start:
        return giveUp("the receiver did not begin");
    case Step::DataStart:
        return begin(Step::Block, now);
    case Step::LastStart:
        return begin(Step::LastHeader, now);
    case Step::LastHeader:
        if (m_repeats >= repeatsAtTheEnd)
            return end(State::Done);
        return repeat(now);
    case Step::Header:
    case Step::Block:
    case Step::End:
        // Nothing at all came for long: fewer attempts than for garbled blocks.
        if (!m_isUnclear && m_repeats >= m_patience.repeats / 3)
            return giveUp("the receiver does not answer");
        return repeat(now);
    }
}

} // namespace axiscomp::drivecomm::ymodem
