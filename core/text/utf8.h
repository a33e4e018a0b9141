// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace axiscomp {

/// The longest beginning of text that has at most maximumBytes and does not end inside a character.
[[nodiscard]] std::string_view cutAtCharacter(std::string_view text, std::size_t maximumBytes);

/// The offset of the first byte that is not part of well-formed UTF-8 (RFC 3629), or npos.
[[nodiscard]] std::size_t findInvalidUtf8(std::string_view text);

/// Text from outside that may be shown, logged and put into JSON: ends at the first zero byte; what
/// is not UTF-8 becomes U+FFFD, a control character becomes a blank.
[[nodiscard]] std::string cleanText(std::string_view text);

} // namespace axiscomp
