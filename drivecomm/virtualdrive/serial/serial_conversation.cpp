// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/serial/serial_conversation.h"

#include <algorithm>
#include <iterator>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t repliesKept = 8;

void garbleText(std::string& text)
{
    if (text.empty())
        return;
    for (const std::size_t place : {std::size_t{0}, text.size() / 2, text.size() - 3})
        if (place < text.size())
            text[place] = static_cast<char>(text[place] ^ 0x15);
}

std::string nameOf(const std::string& path)
{
    return path.substr(path.rfind('/') + 1);
}

} // namespace

void SerialConversation::feed(std::string_view bytes, Clock::time_point now)
{
    m_input += bytes;
    process(now);
}

void SerialConversation::tick(Clock::time_point now)
{
    if (m_held) {
        if (now < m_held->until)
            return;
        m_output += std::exchange(m_held, std::nullopt)->text;
    }
    if (auto* receiving = std::get_if<Receiving>(&m_transfer))
        receiving->receiver.tick(now);
    else if (auto* sending = std::get_if<Sending>(&m_transfer))
        sending->sender.tick(now);
    transferMoved(now);
    process(now);
}

std::optional<SerialConversation::Clock::time_point> SerialConversation::wakeAt() const
{
    if (m_held)
        return m_held->until;
    if (const auto* receiving = std::get_if<Receiving>(&m_transfer))
        return receiving->receiver.wakeAt();
    if (const auto* sending = std::get_if<Sending>(&m_transfer))
        return sending->sender.wakeAt();
    return std::nullopt;
}

void SerialConversation::hangUp()
{
    m_input.clear();
    m_output.clear();
    m_assembler.clear();
    m_held.reset();
    m_transfer = std::monostate{};
    m_wantsCrc = false;
}

void SerialConversation::process(Clock::time_point now)
{
    while (!m_input.empty() && !m_held) {
        if (auto* receiving = std::get_if<Receiving>(&m_transfer)) {
            m_input.erase(0, receiving->receiver.feed(asBytes(m_input), now));
            transferMoved(now);
        } else if (auto* sending = std::get_if<Sending>(&m_transfer)) {
            m_input.erase(0, sending->sender.feed(asBytes(m_input), now));
            transferMoved(now);
        } else {
            const char byte = m_input.front();
            m_input.erase(0, 1);
            if (const auto line = m_assembler.feed(byte))
                lineArrived(*line, now);
        }
    }
}

void SerialConversation::lineArrived(const std::string& text, Clock::time_point now)
{
    const SerialLine line = parseSerialLine(text);
    Context context{line.number, line.text, line.hasCrc, {}};
    const bool isGood = line.state == SerialLine::State::Good;
    m_wantsCrc |= isGood && line.hasCrc;
    if (line.state == SerialLine::State::BadCrc)
        return reply(context, CommandHandler::garbled("the line came garbled"), now);
    if (!isGood) {
        context.number.reset();
        return reply(context,
            CommandHandler::rejected(text.size() > longestSerialLine
                    ? AXISCOMP_TEXT("Error", "the line has more than {most} characters")
                          .with("most", longestSerialLine)
                    : AXISCOMP_TEXT("Error", "this is no request; a line is [#n ]words[ *XXXX]")),
            now);
    }
    // A line that noise has cut in two must not be taken for one without a CRC.
    if (m_wantsCrc && !line.hasCrc && line.number && line.words.front() == "set")
        return reply(
            context, CommandHandler::garbled("the CRC is missing that other lines had"), now);
    request(line, now);
}

void SerialConversation::request(const SerialLine& line, Clock::time_point now)
{
    Context context{line.number, line.text, line.hasCrc, {}};
    if (const SerialReplyLines* lines = remembered(line)) {
        const SerialReplyLines again = *lines;
        context.decision = m_faults.next(false);
        return reply(context, again, now);
    }
    context.decision = m_faults.next(CommandHandler::isWrite(line.words));
    if (context.decision.rejectCode) {
        const SerialReplyLines lines =
            CommandHandler::refused(errorAskedFor(*context.decision.rejectCode));
        remember(context, lines);
        return reply(context, lines, now);
    }
    if (line.words.front() == "put")
        return beginPut(line, std::move(context), now);
    if (line.words.front() == "take")
        return beginTake(line, std::move(context), now);
    if (context.decision.storeWrong)
        m_drive.storeNextWrong();
    const SerialReplyLines lines = m_handler.answer(line.words);
    remember(context, lines);
    reply(context, lines, now);
}

void SerialConversation::beginPut(const SerialLine& line, Context context, Clock::time_point now)
{
    const auto put = m_handler.beginPut(line.words);
    if (!put) {
        const SerialReplyLines lines = CommandHandler::refused(put.error());
        remember(context, lines);
        return reply(context, lines, now);
    }
    m_output += written(context, {"ready"});
    m_transfer = Receiving{std::move(context), *put, ymodem::Receiver(put->limit, put->size, now)};
    transferMoved(now);
}

void SerialConversation::beginTake(const SerialLine& line, Context context, Clock::time_point now)
{
    auto file = m_handler.take(line.words);
    if (!file) {
        const SerialReplyLines lines = CommandHandler::refused(file.error());
        remember(context, lines);
        return reply(context, lines, now);
    }
    const bool begins = !context.decision.noReply && !context.decision.reboot;
    reply(
        context, {"ready " + std::to_string(file->size()) + " " + serialCrc32(crc32(*file))}, now);
    if (!begins)
        return;
    ymodem::Sender sender(nameOf(line.words[1]), *file, now); // moving does not move the bytes
    m_transfer = Sending{std::move(context), *std::move(file), std::move(sender)};
}

void SerialConversation::transferMoved(Clock::time_point now)
{
    if (auto* receiving = std::get_if<Receiving>(&m_transfer)) {
        m_output += asText(receiving->receiver.output());
        if (!receiving->receiver.isRunning())
            endPut(now);
    } else if (auto* sending = std::get_if<Sending>(&m_transfer)) {
        m_output += asText(sending->sender.output());
        if (!sending->sender.isRunning())
            endTake();
    }
}

void SerialConversation::endPut(Clock::time_point now)
{
    Receiving receiving = std::get<Receiving>(std::move(m_transfer));
    m_transfer = std::monostate{};
    m_assembler.clear();
    // What the transfer left on a person's screen, or in a program's line, ends here.
    m_output += serialLineEnd;
    SerialReplyLines lines;
    if (receiving.receiver.state() == ymodem::State::Done) {
        if (receiving.context.decision.storeWrong)
            m_drive.storeNextWrong();
        lines = m_handler.endPut(receiving.put, receiving.receiver.takeFile());
    } else {
        lines = CommandHandler::garbled("the transfer was broken off: "
            + (receiving.receiver.failure().empty() ? "the sender cancelled it"
                                                    : receiving.receiver.failure()));
    }
    remember(receiving.context, lines);
    reply(receiving.context, lines, now);
}

void SerialConversation::endTake()
{
    const Sending sending = std::get<Sending>(std::move(m_transfer));
    m_transfer = std::monostate{};
    m_assembler.clear();
    const bool isDone = sending.sender.state() == ymodem::State::Done;
    m_output += std::string(serialLineEnd)
        + written(sending.context,
            isDone ? SerialReplyLines{"ok"}
                   : CommandHandler::garbled("the transfer was broken off: "
                       + (sending.sender.failure().empty() ? "the receiver cancelled it"
                                                           : sending.sender.failure())));
}

const SerialReplyLines* SerialConversation::remembered(const SerialLine& line) const
{
    const auto place = std::ranges::find_if(m_memory,
        [&](const Memory& each) { return each.number == line.number && each.text == line.text; });
    return place == m_memory.end() ? nullptr : &place->lines;
}

void SerialConversation::remember(const Context& context, const SerialReplyLines& lines)
{
    if (!context.number)
        return;
    // With this a program begins, whose numbers have nothing to do with those of the one before.
    if (context.text == "identify")
        return m_memory.clear();
    // A number that comes again with other words is a new request.
    std::erase_if(m_memory, [&](const Memory& each) { return each.number == context.number; });
    m_memory.push_back({*context.number, context.text, lines});
    if (m_memory.size() > repliesKept)
        m_memory.pop_front();
}

std::string SerialConversation::written(const Context& context, const SerialReplyLines& lines)
{
    if (context.number)
        return serialReply(context.number, lines, context.hasCrc);
    // Programs number their lines; who does not is a person at a terminal.
    SerialReplyLines shown;
    std::ranges::transform(lines, std::back_inserter(shown), withoutSerialText);
    return serialReply(std::nullopt, shown, context.hasCrc);
}

void SerialConversation::reply(
    const Context& context, const SerialReplyLines& lines, Clock::time_point now)
{
    std::string text = context.decision.noReply ? std::string() : written(context, lines);
    if (context.decision.garble)
        garbleText(text);
    if (context.decision.reboot) {
        m_drive.reboot();
        m_memory.clear();
        m_wantsCrc = false;
        m_assembler.clear();
        text = text.substr(0, text.size() / 2) + std::string(serialLineEnd)
            + serialLine(std::nullopt, m_handler.bootLine(), true) + std::string(serialLineEnd);
    }
    if (context.decision.delay > std::chrono::milliseconds(0))
        m_held = Held{now + context.decision.delay, std::move(text)};
    else
        m_output += text;
}

} // namespace axiscomp::drivecomm
