// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/serial/serial_codec.h"
#include "drivecomm/serial/ymodem.h"
#include "drivecomm/virtualdrive/faults.h"
#include "drivecomm/virtualdrive/serial/command_handler.h"

#include <deque>
#include <variant>

namespace axiscomp::drivecomm {

/// One drive's side of the serial link, without I/O: bytes in, bytes out, time given. Lines,
/// repeated requests, file transfers, and the named faults but drop-after.
class SerialConversation {
public:
    using Clock = std::chrono::steady_clock;

    SerialConversation(VirtualDrive& drive, FaultPlan& faults)
        : m_drive(drive)
        , m_faults(faults)
        , m_handler(drive)
    {
    }

    void feed(std::string_view bytes, Clock::time_point now);
    void tick(Clock::time_point now);
    /// What is to be sent; taken by this.
    [[nodiscard]] std::string output() { return std::exchange(m_output, {}); }
    /// tick() is due then; nothing: only when bytes come.
    [[nodiscard]] std::optional<Clock::time_point> wakeAt() const;
    /// The port is gone: half a line, a transfer and a reply on its way go with it.
    void hangUp();

private:
    /// What a reply is to be sent with.
    struct Context {
        std::optional<std::uint16_t> number;
        std::string text;
        bool hasCrc = false;
        FaultPlan::Decision decision;
    };
    struct Receiving {
        Context context;
        CommandHandler::Put put;
        ymodem::Receiver receiver;
    };
    struct Sending {
        Context context;
        Bytes file;
        ymodem::Sender sender;
    };
    struct Held {
        Clock::time_point until;
        std::string text;
    };
    void process(Clock::time_point now);
    void lineArrived(const std::string& text, Clock::time_point now);
    void request(const SerialLine& line, Clock::time_point now);
    void beginPut(const SerialLine& line, Context context, Clock::time_point now);
    void beginTake(const SerialLine& line, Context context, Clock::time_point now);
    void transferMoved(Clock::time_point now);
    void endPut(Clock::time_point now);
    void endTake();
    [[nodiscard]] const SerialReplyLines* remembered(const SerialLine& line) const;
    void remember(const Context& context, const SerialReplyLines& lines);
    [[nodiscard]] static std::string written(const Context& context, const SerialReplyLines& lines);
    void reply(const Context& context, const SerialReplyLines& lines, Clock::time_point now);

    struct Memory {
        std::uint16_t number = 0;
        std::string text;
        SerialReplyLines lines;
    };

    VirtualDrive& m_drive;
    FaultPlan& m_faults;
    CommandHandler m_handler;
    SerialLineAssembler m_assembler;
    std::string m_input;
    std::string m_output;
    std::optional<Held> m_held;
    std::variant<std::monostate, Receiving, Sending> m_transfer;
    std::deque<Memory> m_memory;
    bool m_wantsCrc = false;
};

} // namespace axiscomp::drivecomm
