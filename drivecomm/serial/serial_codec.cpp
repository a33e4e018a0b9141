// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/serial_codec.h"

#include "drivecomm/codec/crc16.h"
#include "drivecomm/codec/error_json.h"
#include "drivecomm/codec/text_json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace axiscomp::drivecomm {

namespace {

constexpr char backspace = '\x08';
constexpr char rubout = '\x7F';
constexpr char cancel = '\x18';
constexpr std::string_view longestFrame = "#65535  *0000";
constexpr std::string_view textKey = "text=";

bool isPrintable(char c)
{
    return c >= ' ' && c < rubout;
}

std::string hex(std::uint32_t value, std::size_t digits)
{
    static constexpr std::string_view characters = "0123456789abcdef";
    std::string text(digits, '0');
    for (std::size_t i = digits; i-- > 0; value >>= 4U)
        text[i] = characters[value & 0xFU];
    return text;
}

template <typename T> std::optional<T> wholeNumber(std::string_view text, int base)
{
    T value{};
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, value, base);
    if (text.empty() || error != std::errc() || end != last)
        return std::nullopt;
    return value;
}

/// A request or a line of a reply; crc is where its CRC begins, and then what it is.
std::string framed(
    std::optional<std::uint16_t> number, std::string_view words, bool withCrc, std::uint16_t& crc)
{
    std::string line = number ? "#" + std::to_string(*number) + " " : "";
    line += words;
    crc = crc16(asBytes(line), crc);
    if (withCrc)
        line += " *" + hex(crc, 4);
    return line;
}

/// One word from the front of rest; false when a quotation mark is not closed or something follows
/// it.
bool takeWord(std::string_view& rest, std::string& word)
{
    if (rest.front() != '"') {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        word = rest.substr(0, end);
        rest.remove_prefix(end);
        return word.find('"') == std::string::npos;
    }
    rest.remove_prefix(1);
    while (!rest.empty()) {
        char c = rest.front();
        rest.remove_prefix(1);
        if (c == '"')
            return rest.empty() || rest.front() == ' ';
        if (c == '\\') {
            if (rest.empty())
                return false;
            c = rest.front();
            rest.remove_prefix(1);
            if (c == 'x') {
                const auto code = wholeNumber<std::uint8_t>(rest.substr(0, 2), 16);
                if (rest.size() < 2 || !code)
                    return false;
                rest.remove_prefix(2);
                c = static_cast<char>(*code);
            } else if (c != '"' && c != '\\') {
                return false;
            }
        }
        word += c;
    }
    return false;
}

std::optional<std::vector<std::string>> splitWords(std::string_view text)
{
    std::vector<std::string> words;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        if (text.empty())
            return words;
        std::string word;
        if (!takeWord(text, word))
            return std::nullopt;
        words.push_back(std::move(word));
    }
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Takes the CRC off the end of line. False when there is one and it is wrong.
bool takeCrc(std::string_view& line, std::uint16_t crcStart, SerialLine& result)
{
    const std::size_t blank = line.rfind(' ');
    if (blank == std::string_view::npos || blank + 1 == line.size() || line[blank + 1] != '*')
        return true;
    result.hasCrc = true;
    const std::string_view digits = line.substr(blank + 2);
    line = line.substr(0, blank);
    const auto stated = wholeNumber<std::uint16_t>(digits, 16);
    result.crc = crc16(asBytes(line), crcStart);
    return digits.size() == 4 && stated == result.crc;
}

} // namespace

SerialLine parseSerialLine(std::string_view line, std::uint16_t crcStart)
{
    SerialLine result;
    // What the assembler has cut off may have come behind a blank: the length counts first.
    if (line.size() > longestSerialLine)
        return result;
    // Blanks in front belong to what the CRC is of; those behind do not.
    line = line.substr(0, line.find_last_not_of(' ') + 1);
    if (!std::ranges::all_of(line, isPrintable))
        return result;
    const bool isIntact = takeCrc(line, crcStart, result);
    std::string_view rest = trimmed(line);
    bool isPossible = true;
    if (rest.starts_with('#')) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        result.number = wholeNumber<std::uint16_t>(rest.substr(1, end - 1), 10);
        isPossible = result.number.value_or(0) != 0;
        rest = trimmed(rest.substr(end));
    }
    result.text = rest;
    if (auto words = splitWords(rest))
        result.words = std::move(*words);
    if (!isIntact)
        result.state = SerialLine::State::BadCrc;
    else if (isPossible && !result.words.empty())
        result.state = SerialLine::State::Good;
    return result;
}

std::string serialLine(std::optional<std::uint16_t> number, std::string_view words, bool withCrc)
{
    std::uint16_t crc = crcCcittFalse;
    return framed(number, words, withCrc, crc);
}

std::string serialReply(
    std::optional<std::uint16_t> number, std::span<const std::string> lines, bool withCrc)
{
    std::uint16_t crc = crcCcittFalse;
    std::string reply;
    for (const std::string& line : lines)
        reply += framed(number, line, withCrc, crc) + std::string(serialLineEnd);
    return reply;
}

std::string serialQuoted(std::string_view text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            quoted += std::string("\\") + c;
        else if (isPrintable(c))
            quoted += c;
        else
            quoted += "\\x" + hex(static_cast<unsigned char>(c), 2);
    }
    return quoted + '"';
}

std::string serialWord(std::string_view word)
{
    const bool isPlain = !word.empty() && word.front() != '#' && word.front() != '*'
        && std::ranges::all_of(
            word, [](char c) { return isPrintable(c) && c != ' ' && c != '"' && c != '\\'; });
    return isPlain ? std::string(word) : serialQuoted(word);
}

std::optional<std::string> SerialLineAssembler::feed(char byte)
{
    if (byte == '\r' || byte == '\n') {
        if (m_line.empty())
            return std::nullopt;
        return std::exchange(m_line, {});
    }
    if (byte == backspace || byte == rubout) {
        if (!m_line.empty())
            m_line.pop_back();
    } else if (byte == cancel) {
        m_line.clear();
    } else if (m_line.size() <= longestSerialLine) {
        m_line += byte == '\t' ? ' ' : byte;
    }
    return std::nullopt;
}

std::string serialError(const Error& error)
{
    std::string words = "error " + std::string(errorName(error.code));
    if (const auto seconds = error.context.integer("seconds"))
        words += " " + std::to_string(*seconds);
    const Text message = driveMessage(error);
    words += " " + serialQuoted(message.english());
    for (const char* key : {"path", "nearest"})
        if (const std::string value = error.context.english(key); !value.empty())
            words += " " + serialQuoted(std::string(key) + "=" + value);
    const std::string text = " " + serialQuoted(std::string(textKey) + textJson(message));
    const bool fits = words.size() + text.size() + longestFrame.size() <= longestSerialLine;
    return fits ? words + text : words;
}

std::string withoutSerialText(std::string line)
{
    // It is the last word; a quotation mark within another word is escaped.
    const std::size_t place = line.rfind(" \"" + std::string(textKey));
    return place == std::string::npos ? line : line.substr(0, place);
}

std::optional<Error> parseSerialError(const std::vector<std::string>& words)
{
    if (words.size() < 2 || words.front() != "error")
        return std::nullopt;
    Error error;
    error.code = driveErrorNamed(words[1]).value_or(ErrorCode::DriveRejected);
    error.detail = words[1];
    std::size_t next = 2;
    if (next < words.size() && words[next] == "retry")
        ++next;
    if (const auto seconds = next < words.size() ? parseSerialNumber(words[next]) : std::nullopt) {
        error.context.set("seconds", *seconds);
        ++next;
    }
    error.context.set("reason", next < words.size() ? words[next] : words[1]);
    for (++next; next < words.size(); ++next) {
        for (const std::string key : {"path", "nearest"})
            if (words[next].starts_with(key + "="))
                error.context.set(key, words[next].substr(key.size() + 1));
        if (words[next].starts_with(textKey))
            if (auto text = parseTextJson(std::string_view(words[next]).substr(textKey.size())))
                error.context.set("reason", *std::move(text));
    }
    return error;
}

std::string serialIdentity(const DriveIdentity& identity, std::string_view profileName)
{
    return serialQuoted(identity.name) + " " + std::to_string(identity.serialNumber) + " "
        + std::to_string(identity.axes) + " " + serialWord(profileName);
}

std::optional<DriveIdentity> parseSerialIdentity(std::span<const std::string> words)
{
    constexpr std::uint16_t mostAxes = 1024;
    if (words.size() < 3)
        return std::nullopt;
    const auto serial = wholeNumber<std::int32_t>(words[1], 10);
    const auto axes = wholeNumber<std::uint16_t>(words[2], 10);
    if (!serial || !axes || *axes > mostAxes)
        return std::nullopt;
    return DriveIdentity{words[0], *serial, *axes};
}

std::string serialReading(const RegisterReading& reading)
{
    return serialWord(reading.type) + " " + serialWord(toText(reading.value));
}

std::optional<RegisterReading> parseSerialReading(std::span<const std::string> words)
{
    if (words.size() != 2)
        return std::nullopt;
    auto value = registerValueFromText(words[0], words[1]);
    if (!value)
        return std::nullopt;
    return RegisterReading{{}, 0, words[0], std::move(*value)};
}

std::string serialTreeLine(const RegisterReading& reading)
{
    return serialWord(reading.path) + " " + std::to_string(reading.address) + " "
        + serialReading(reading);
}

std::optional<RegisterReading> parseSerialTreeLine(std::span<const std::string> words)
{
    if (words.size() != 4)
        return std::nullopt;
    auto reading = parseSerialReading(words.subspan(2));
    const auto address = parseSerialNumber(words[1]);
    if (!reading || !address)
        return std::nullopt;
    reading->path = normalisedPath(words[0]);
    reading->address = *address;
    return reading;
}

std::string serialFile(const DriveFile& file)
{
    return serialWord(file.path) + " " + std::to_string(file.size) + " "
        + std::to_string(file.maximumSize);
}

std::optional<DriveFile> parseSerialFile(std::span<const std::string> words)
{
    if (words.size() != 3)
        return std::nullopt;
    const auto size = parseSerialNumber(words[1]);
    const auto most = parseSerialNumber(words[2]);
    if (words[0].empty() || !size || !most)
        return std::nullopt;
    return DriveFile{words[0], *size, *most};
}

std::string serialCrc32(std::uint32_t crc)
{
    return hex(crc, 8);
}

std::optional<std::uint32_t> parseSerialNumber(std::string_view text, int base)
{
    return wholeNumber<std::uint32_t>(text, base);
}

} // namespace axiscomp::drivecomm
