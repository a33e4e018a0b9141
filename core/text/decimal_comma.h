// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/token_scanner.h"

namespace axiscomp {

/// How many commas stand between two digits.
[[nodiscard]] std::size_t commasBetweenDigits(std::string_view text);

/// Looks for decimal commas where a comma separates numbers, and blanks do too: "0,5 1,5" may be
/// two numbers or four. "0.5,1.5" and "1,2,3" cannot be meant otherwise than as lists.
class DecimalCommaCheck {
public:
    void take(const Token& line);
    /// The first number that may have a decimal comma; empty when there is none, or when a number
    /// somewhere shows that commas separate.
    [[nodiscard]] Token doubtful() const { return m_areSeparators ? Token{} : m_doubtful; }

private:
    Token m_doubtful;
    bool m_areSeparators = false;
};

} // namespace axiscomp
