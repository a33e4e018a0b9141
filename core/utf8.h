// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace axiscomp {

/// The longest beginning of text that has at most maximumBytes and does not end inside a character.
[[nodiscard]] std::string_view cutAtCharacter(std::string_view text, std::size_t maximumBytes);

/// Text from outside that may be shown, logged and put into JSON: ends at the first zero byte; what
/// is not UTF-8 becomes U+FFFD, a control character becomes a blank.
[[nodiscard]] std::string cleanText(std::string_view text);

} // namespace axiscomp
