// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/decimal_comma.h"

namespace axiscomp {

namespace {

constexpr char wordSeparators[] = " \t";

} // namespace

std::size_t commasBetweenDigits(std::string_view text)
{
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t count = 0;
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
        count += text[i] == ',' && isDigit(text[i - 1]) && isDigit(text[i + 1]) ? 1 : 0;
    return count;
}

void DecimalCommaCheck::take(const Token& line)
{
    if (m_areSeparators)
        return;
    m_areSeparators = line.text.find('.') != std::string_view::npos;
    if (m_areSeparators || line.text.find(',') == std::string_view::npos)
        return;
    for (Token rest = trimmedToken(line); rest;) {
        const Token word = firstToken(rest, wordSeparators);
        const std::size_t commas = commasBetweenDigits(word.text);
        m_areSeparators = m_areSeparators || commas > 1;
        if (commas == 1 && !m_doubtful)
            m_doubtful = word.part(0, word.text.find_last_not_of(',') + 1);
        rest = trimmedToken(rest.part(word.text.size()));
    }
}

} // namespace axiscomp
