// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/utf8.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace axiscomp {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

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

} // namespace axiscomp
