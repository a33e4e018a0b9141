// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_parser.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace axiscomp {

namespace {

struct Form {
    std::size_t significantDigits = 0; ///< before the exponent, leading zeros left out
    int lastDecimal = 0;
};

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// text: a number as std::from_chars takes it, perhaps with a '+' before it.
Form formOf(std::string_view text)
{
    constexpr int beyondAnyDouble = 100'000;
    const std::size_t e = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, e);
    int exponent = 0;
    if (e != std::string_view::npos) {
        std::string_view digits = text.substr(e + 1);
        digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        if (read.ec == std::errc::result_out_of_range)
            exponent = digits.starts_with('-') ? -beyondAnyDouble : beyondAnyDouble;
        exponent = std::clamp(exponent, -beyondAnyDouble, beyondAnyDouble);
    }
    const std::size_t point = mantissa.find('.');
    const std::size_t decimals = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
    const auto first = std::ranges::find_if(mantissa, [](char c) { return c >= '1' && c <= '9'; });
    const auto significant = std::count_if(first, mantissa.end(), isDigit);
    return {static_cast<std::size_t>(significant), exponent - static_cast<int>(decimals)};
}

} // namespace

NumberFault parseValue(std::string_view text, double& value)
{
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-'))
            return NumberFault::NotANumber;
    }
    double found = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), found);
    if (read.ec == std::errc::invalid_argument || read.ptr != text.data() + text.size())
        return NumberFault::NotANumber;
    if (read.ec == std::errc::result_out_of_range) {
        const Form form = formOf(text);
        return static_cast<double>(form.significantDigits) + form.lastDecimal > 0
            ? NumberFault::NotFinite
            : NumberFault::TooSmall;
    }
    if (!std::isfinite(found))
        return NumberFault::NotFinite;
    value = found;
    return NumberFault::None;
}

NumberFault parseNumber(std::string_view text, char decimal, Number& number)
{
    std::string withPoint;
    if (decimal != '.') {
        if (text.find('.') != std::string_view::npos)
            return NumberFault::NotANumber;
        withPoint = text;
        std::ranges::replace(withPoint, decimal, '.');
        text = withPoint;
    }
    const NumberFault fault = parseValue(text, number.value);
    if (fault == NumberFault::None)
        number.lastDecimal = formOf(text).lastDecimal;
    return fault;
}

} // namespace axiscomp
