// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";
constexpr std::uint32_t replacementCode = 0xFFFD;

bool isContinuation(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Length of the character at the beginning of text, 0 when that is not UTF-8 (too long a form,
/// a surrogate or a value above U+10FFFF included).
std::size_t characterLength(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80U)
        return 1;
    const std::size_t length = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : 2;
    if (first < 0xC2U || first > 0xF4U || text.size() < length
        || !std::all_of(
            text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(length), isContinuation))
        return 0;
    const auto second = static_cast<unsigned char>(text[1]);
    const bool refused = (first == 0xE0U && second < 0xA0U) || (first == 0xEDU && second > 0x9FU)
        || (first == 0xF0U && second < 0x90U) || (first == 0xF4U && second > 0x8FU);
    return refused ? 0 : length;
}

/// text is one character.
std::uint32_t codePoint(std::string_view text)
{
    const auto first = static_cast<unsigned char>(text.front());
    std::uint32_t code = text.size() == 1 ? first
        : text.size() == 2                ? first & 0x1FU
        : text.size() == 3                ? first & 0x0FU
                                          : first & 0x07U;
    for (const char byte : text.substr(1))
        code = (code << 6U) | (static_cast<unsigned char>(byte) & 0x3FU);
    return code;
}

/// Controls, marks of direction, and what has no width (Unicode categories Cc and Cf).
bool isHidden(std::uint32_t code)
{
    constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 9> hidden{
        {{0x00, 0x1F}, {0x7F, 0x9F}, {0xAD, 0xAD}, {0x61C, 0x61C}, {0x200B, 0x200F},
            {0x2028, 0x202E}, {0x2060, 0x206F}, {0xFEFF, 0xFEFF}, {0xE0000, 0xE007F}}};
    return std::ranges::any_of(
        hidden, [code](const auto& range) { return range.first <= code && code <= range.second; });
}

std::string symbolOf(std::uint32_t code)
{
    if (code < 0x20) // U+2400 and following are pictures of the control characters
        return {'\xE2', '\x90', static_cast<char>(0x80 + code)};
    char digits[16];
    const int length = std::snprintf(digits, sizeof digits, "[U+%04X]", code);
    return {digits, static_cast<std::size_t>(length)};
}

} // namespace

std::string_view cutAtCharacter(std::string_view text, std::size_t maximumBytes)
{
    if (text.size() <= maximumBytes)
        return text;
    std::size_t end = maximumBytes;
    while (end > 0 && isContinuation(text[end]))
        --end;
    return text.substr(0, end);
}

std::size_t findInvalidUtf8(std::string_view text)
{
    constexpr std::uint64_t highBits = 0x8080808080808080U;
    std::size_t i = 0;
    while (i < text.size()) {
        std::uint64_t word = highBits;
        if (i + sizeof word <= text.size())
            std::memcpy(&word, text.data() + i, sizeof word);
        if ((word & highBits) == 0) {
            i += sizeof word;
            continue;
        }
        const std::size_t length = characterLength(text.substr(i));
        if (length == 0)
            return i;
        i += length;
    }
    return std::string_view::npos;
}

Character firstCharacter(std::string_view text)
{
    const std::size_t length = characterLength(text);
    return length == 0 ? Character{replacementCode, 1}
                       : Character{codePoint(text.substr(0, length)), length};
}

std::string cleanText(std::string_view text)
{
    text = text.substr(0, text.find('\0'));
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        if (length == 0)
            result += replacement;
        else if (length == 1 && (text.front() < ' ' || text.front() == '\x7F'))
            result += ' ';
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

std::string visibleText(std::string_view text, bool keepsLines)
{
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto [code, length] = firstCharacter(text);
        const bool isKept = keepsLines && (code == '\n' || code == '\t');
        if (code == replacementCode)
            result += replacement;
        else if (isHidden(code) && !isKept)
            result += symbolOf(code);
        else
            result += text.substr(0, length);
        text.remove_prefix(length);
    }
    return result;
}

std::string shownText(std::string_view text, std::size_t maximumBytes)
{
    std::string shown = visibleText(text.substr(0, text.find('\0')));
    if (shown.size() <= maximumBytes)
        return shown;
    return std::string(cutAtCharacter(shown, maximumBytes)) + "\u2026";
}

} // namespace axiscomp
