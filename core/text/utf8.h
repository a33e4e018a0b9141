// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace axiscomp {

/// The longest beginning of text that has at most maximumBytes and does not end inside a character.
[[nodiscard]] std::string_view cutAtCharacter(std::string_view text, std::size_t maximumBytes);

/// The offset of the first byte that is not part of well-formed UTF-8 (RFC 3629), or npos.
[[nodiscard]] std::size_t findInvalidUtf8(std::string_view text);

struct Character {
    std::uint32_t code = 0; ///< U+FFFD for a byte that is no part of UTF-8
    std::size_t length = 1; ///< in bytes
};
/// That a text begins with, which is not empty.
[[nodiscard]] Character firstCharacter(std::string_view text);

/// Text from outside that may be shown, logged and put into JSON: ends at the first zero byte; what
/// is not UTF-8 becomes U+FFFD, a control character becomes a blank.
[[nodiscard]] std::string cleanText(std::string_view text);

/// Characters that move the cursor, hide or reorder text, made visible: "␛" for U+001B, "[U+202E]"
/// for a mark of direction. keepsLines: line ends and tabs stay as they are.
[[nodiscard]] std::string visibleText(std::string_view text, bool keepsLines = false);

/// Text of a drive or a file for people: cleanText() with visibleText() before it loses the control
/// characters, and cut with "…" where it has more than maximumBytes.
[[nodiscard]] std::string shownText(std::string_view text, std::size_t maximumBytes = 200);

} // namespace axiscomp
