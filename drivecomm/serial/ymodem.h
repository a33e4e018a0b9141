// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axiscomp::drivecomm {

/// YMODEM (CRC-16, blocks of 1024 and 128 bytes, a header with name and size, an empty header at
/// the end) for one file, as two state machines without I/O: they are given bytes and the time, and
/// give bytes. A transfer ends Done with the whole file or not at all; what CRC-16 lets through (a
/// block with several flipped bytes in 65536) is for a checksum over the whole file to find.
///
/// The loop around either: write output(), wait for bytes until wakeAt(), then feed() what came or
/// tick() when nothing did, while isRunning().
namespace ymodem {

using Clock = std::chrono::steady_clock;

// What the bytes on the line say.
inline constexpr std::uint8_t soh = 0x01; ///< begins a block of 128 bytes
inline constexpr std::uint8_t stx = 0x02; ///< begins a block of 1024 bytes
inline constexpr std::uint8_t eot = 0x04;
inline constexpr std::uint8_t ack = 0x06;
inline constexpr std::uint8_t nak = 0x15;
inline constexpr std::uint8_t can = 0x18;
inline constexpr std::uint8_t backspace = 0x08; ///< some send it after CAN, to tidy up a terminal
inline constexpr std::uint8_t promptCrc = 'C';
inline constexpr std::uint8_t padding = 0x1A;

inline constexpr std::size_t shortBlock = 128;
inline constexpr std::size_t longBlock = 1024;
inline constexpr std::size_t blockOverhead = 5; ///< kind, number and its complement, CRC

enum class State {
    Running,
    Done,
    Cancelled, ///< by the other side
    Failed, ///< given up; failure() says why
};

/// The other side is taken to be gone, or the line to be useless, after these.
struct Patience {
    std::chrono::milliseconds start{60'000}; ///< for the other side to begin: a person may do it
    std::chrono::milliseconds answer{3'000}; ///< after that, ask again
    std::chrono::milliseconds between{1'000}; ///< two bytes of a block
    std::chrono::milliseconds quiet{100}; ///< that ends garbled bytes
    int repeats = 25; ///< of one block, one after the other
};

struct FileHeader {
    std::string name; ///< empty: the header that ends a batch
    std::optional<std::uint64_t> size;
};

/// What both sides have.
class Machine {
public:
    [[nodiscard]] bool isRunning() const { return m_state == State::Running; }
    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] const std::string& failure() const { return m_failure; }
    /// What must be sent now; taken by this.
    [[nodiscard]] Bytes output() { return std::exchange(m_output, {}); }
    /// tick() is due then.
    [[nodiscard]] Clock::time_point wakeAt() const { return m_wakeAt; }
    /// Ends the transfer; output() then tells the other side.
    void cancel();

protected:
    explicit Machine(const Patience& patience) : m_patience(patience) { }
    void send(ByteView bytes) { m_output.insert(m_output.end(), bytes.begin(), bytes.end()); }
    void send(std::uint8_t byte) { m_output.push_back(static_cast<std::byte>(byte)); }
    void giveUp(std::string reason);
    void end(State state) { m_state = state; }

    Patience m_patience;
    Clock::time_point m_wakeAt;

private:
    State m_state = State::Running;
    std::string m_failure;
    Bytes m_output;
};

class Sender final : public Machine {
public:
    /// bytes must live as long as the sender. name has no folders for most receivers.
    Sender(std::string name, ByteView bytes, Clock::time_point now, const Patience& patience = {});

    /// Gives the number of bytes used: those that come after the end are not the sender's.
    [[nodiscard]] std::size_t feed(ByteView received, Clock::time_point now);
    void tick(Clock::time_point now);
    /// Bytes of the file that the receiver has acknowledged.
    [[nodiscard]] std::uint64_t acknowledged() const { return m_acknowledged; }

private:
    enum class Step { Start, Header, DataStart, Block, End, LastStart, LastHeader };
    void respond(std::uint8_t byte, Clock::time_point now);
    void acknowledge(Clock::time_point now);
    void begin(Step step, Clock::time_point now);
    void repeat(Clock::time_point now);
    void sendBlock(std::uint8_t number, ByteView content, std::size_t size, std::byte filler);
    void sendLast();
    void sendNextBlock(Clock::time_point now);
    [[nodiscard]] Bytes headerContent() const;
    [[nodiscard]] Clock::time_point answerBy(Clock::time_point now) const;

    std::string m_name;
    ByteView m_bytes;
    Step m_step = Step::Start;
    Bytes m_last; ///< what is repeated
    std::uint64_t m_acknowledged = 0;
    std::size_t m_blockSize = 0; ///< bytes of the file in the block on its way
    std::uint8_t m_number = 0;
    int m_repeats = 0;
    int m_shortBlocks = 0; ///< so many more, because long ones do not arrive
    bool m_sawCancel = false;
    bool m_hasSent = false; ///< because of the byte that is looked at
    bool m_isUnclear = false; ///< something came that is no answer
};

class Receiver final : public Machine {
public:
    /// limit: a longer file is cancelled. expectedSize: where the sender's header has none.
    Receiver(std::uint64_t limit, std::optional<std::uint64_t> expectedSize, Clock::time_point now,
        const Patience& patience = {});

    /// As Sender::feed.
    [[nodiscard]] std::size_t feed(ByteView received, Clock::time_point now);
    void tick(Clock::time_point now);

    [[nodiscard]] const FileHeader& header() const { return m_header; }
    [[nodiscard]] std::uint64_t received() const { return m_file.size(); }
    /// The whole file, once it is Done; taken by this.
    [[nodiscard]] Bytes takeFile() { return std::move(m_file); }

private:
    enum class Step { Header, Data, LastHeader };
    void take(std::byte byte, Clock::time_point now);
    void takeFirst(std::uint8_t byte, Clock::time_point now);
    void blockArrived(Clock::time_point now);
    void headerArrived(ByteView content, Clock::time_point now);
    void dataArrived(std::uint8_t number, ByteView content, Clock::time_point now);
    void endArrived(Clock::time_point now);
    void acknowledge(bool promptsForMore, Clock::time_point now);
    void askAgain(Clock::time_point now);
    void junkEnded(Clock::time_point now);
    [[nodiscard]] bool isComplete() const;

    std::uint64_t m_limit;
    std::optional<std::uint64_t> m_expectedSize;
    Clock::time_point m_giveUpStart;
    Step m_step = Step::Header;
    FileHeader m_header;
    Bytes m_file;
    Bytes m_block; ///< of the block that is coming, from its first byte
    std::size_t m_blockLength = 0; ///< of the whole block with number and CRC
    Bytes m_junk; ///< its last bytes
    bool m_inJunk = false;
    bool m_sawCancel = false;
    bool m_sawEnd = false;
    std::uint8_t m_expected = 1;
    int m_failures = 0;
};

/// The content of a header block, before padding. nullopt when it is none.
[[nodiscard]] std::optional<FileHeader> parseHeader(ByteView content);

} // namespace ymodem

} // namespace axiscomp::drivecomm
