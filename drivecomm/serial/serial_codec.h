// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"
#include "drivecomm/codec/crc16.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::drivecomm {

/// Limits of the serial link (docs/protocol.md, "Serial link").
constexpr std::size_t mostSerialReads = 16;
constexpr std::size_t mostSerialWrites = 8;
constexpr std::size_t serialTreePage = 32; ///< registers in one answer of `tree`
constexpr std::size_t longestSerialLine = 4096; ///< bytes, without the end of the line

/// What the drive says of its own accord after a reboot: boot "NAME" SERIAL.
constexpr std::string_view serialBootWord = "boot";
/// The code of `error` for a line or a file that arrived garbled; nothing has been done.
constexpr std::string_view serialBadCrc = "BadCrc";
/// Cancels a transfer; outside of one it throws away what stands in the line so far.
constexpr std::string_view serialCancel = "\x18\x18\x18\x18\x18\x18\x18\x18";
constexpr std::string_view serialLineEnd = "\r\n";

/// A request or a line of a reply: `[#n ]words[ *XXXX]`.
struct SerialLine {
    enum class State {
        Good,
        BadCrc, ///< number and words are what stands there, and cannot be trusted
        Malformed, ///< no text, an open quotation mark, an impossible number
    };
    State state = State::Malformed;
    std::optional<std::uint16_t> number; ///< 1 to 65535
    std::vector<std::string> words; ///< without quotation marks
    std::string text; ///< the words as they stand, by which a repeated request is recognised
    bool hasCrc = false;
    std::uint16_t crc = 0; ///< where it has one: with it the CRC of the next line of a reply begins
};

/// line is without its end; crcStart is crcCcittFalse, or the CRC of the line of the reply that
/// stands before it.
[[nodiscard]] SerialLine parseSerialLine(
    std::string_view line, std::uint16_t crcStart = crcCcittFalse);

/// words are already quoted where they need it (serialWord). Without its end.
[[nodiscard]] std::string serialLine(
    std::optional<std::uint16_t> number, std::string_view words, bool withCrc);

/// A reply, its lines with their ends. The CRC of each line begins with that of the line before it:
/// one that is missing, comes twice or has another place is seen.
[[nodiscard]] std::string serialReply(
    std::optional<std::uint16_t> number, std::span<const std::string> lines, bool withCrc);

/// The word as it is, or in quotation marks with \", \\ and \xNN, so that a line is always ASCII.
[[nodiscard]] std::string serialWord(std::string_view word);
[[nodiscard]] std::string serialQuoted(std::string_view text);

/// Makes lines of bytes. A line ends with CR, LF or both; empty ones are left out. For people:
/// backspace deletes, CAN (Ctrl-X) deletes the line.
class SerialLineAssembler {
public:
    /// The line that this byte ends. A line that is too long comes cut off, one byte longer than
    /// longestSerialLine.
    [[nodiscard]] std::optional<std::string> feed(char byte);
    void clear() { m_line.clear(); }

private:
    std::string m_line;
};

// Replies. parse... want the words after "ok" and give nullopt for anything else.

/// error CODE [SECONDS] "MESSAGE" [path=PATH] [nearest=PATHS] [text=JSON]; the text (text_json)
/// only where the line is long enough for it.
[[nodiscard]] std::string serialError(const Error& error);
/// The line without that text, which only programs can read.
[[nodiscard]] std::string withoutSerialText(std::string line);
/// An unknown code becomes DriveRejected; detail is the code as it stands.
[[nodiscard]] std::optional<Error> parseSerialError(const std::vector<std::string>& words);

/// "NAME" SERIAL AXES PROFILE
[[nodiscard]] std::string serialIdentity(
    const DriveIdentity& identity, std::string_view profileName);
[[nodiscard]] std::optional<DriveIdentity> parseSerialIdentity(std::span<const std::string> words);

/// TYPE VALUE; path and address are left to the caller.
[[nodiscard]] std::string serialReading(const RegisterReading& reading);
[[nodiscard]] std::optional<RegisterReading> parseSerialReading(std::span<const std::string> words);

/// PATH ADDRESS TYPE VALUE, a line of `tree`
[[nodiscard]] std::string serialTreeLine(const RegisterReading& reading);
[[nodiscard]] std::optional<RegisterReading> parseSerialTreeLine(
    std::span<const std::string> words);

/// PATH SIZE MAXIMUM
[[nodiscard]] std::string serialFile(const DriveFile& file);
[[nodiscard]] std::optional<DriveFile> parseSerialFile(std::span<const std::string> words);

/// 8 hex digits, as `put` and `take` have them
[[nodiscard]] std::string serialCrc32(std::uint32_t crc);
/// A whole number and nothing else; base 16 without a prefix.
[[nodiscard]] std::optional<std::uint32_t> parseSerialNumber(std::string_view text, int base = 10);

} // namespace axiscomp::drivecomm
