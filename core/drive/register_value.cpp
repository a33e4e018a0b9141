// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/register_value.h"

#include "core/text/number_text.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <type_traits>

namespace axiscomp {

namespace {

constexpr std::size_t longestQuote = 80;

tl::unexpected<Error> notA(std::string_view type, std::string_view text, Text expected)
{
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error", "\"{text}\" is not a value of type {type}; expected {expected}")
                .with("text", cutAtCharacter(text, longestQuote))
                .with("type", type)
                .with("expected", std::move(expected))}});
}

template <typename T>
Result<RegisterValue> number(std::string_view type, std::string_view text, std::string_view digits,
    Text expected, int base = 10)
{
    const char* const end = digits.data() + digits.size();
    T value{};
    std::from_chars_result result{};
    if constexpr (std::is_floating_point_v<T>)
        result = std::from_chars(digits.data(), end, value);
    else
        result = std::from_chars(digits.data(), end, value, base);
    if (result.ec != std::errc{} || result.ptr != end)
        return notA(type, text, std::move(expected));
    return RegisterValue{value};
}

template <typename T> Text integerRange(const TextPattern& pattern)
{
    return pattern.with("least", std::numeric_limits<T>::min())
        .with("most", std::numeric_limits<T>::max());
}

template <typename T> Text floatRange()
{
    return AXISCOMP_TEXT("Error", "a number such as 12.5, at most {most} in magnitude")
        .with("most", Quantity{shortestText(std::numeric_limits<T>::max())});
}

Result<RegisterValue> boolean(std::string_view text)
{
    if (text == "true" || text == "True" || text == "1")
        return RegisterValue{true};
    if (text == "false" || text == "False" || text == "0")
        return RegisterValue{false};
    return notA("Boolean", text, AXISCOMP_TEXT("Error", "true or false"));
}

Result<RegisterValue> unsignedInteger(std::string_view text)
{
    const Text expected = integerRange<std::uint32_t>(AXISCOMP_TEXT(
        "Error", "a whole number from {least} to {most}, or an address such as 0x1234"));
    if (text.starts_with("0x") || text.starts_with("0X"))
        return number<std::uint32_t>("UInt32", text, text.substr(2), expected, 16);
    return number<std::uint32_t>("UInt32", text, text, expected);
}

Result<RegisterValue> enumValue(std::string_view type, std::string_view text)
{
    const auto isGraphic = [](char c) { return c > ' ' && c != '\x7F' && c != '"'; };
    if (type.empty() || text.empty() || !std::ranges::all_of(text, isGraphic))
        return notA(type.empty() ? "?" : type, text,
            AXISCOMP_TEXT("Error", "the name of an enum value, without blanks"));
    return RegisterValue{std::string(text)};
}

} // namespace

double toDouble(const RegisterValue& value)
{
    return std::visit(
        [](const auto& held) {
            if constexpr (std::is_arithmetic_v<std::decay_t<decltype(held)>>)
                return static_cast<double>(held);
            else
                return std::numeric_limits<double>::quiet_NaN();
        },
        value);
}

std::string toText(const RegisterValue& value)
{
    return std::visit(
        [](const auto& held) -> std::string {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, bool>)
                return held ? "true" : "false";
            else if constexpr (std::is_same_v<Held, std::string>)
                return held;
            else if constexpr (std::is_floating_point_v<Held>)
                return shortestText(held);
            else
                return std::to_string(held);
        },
        value);
}

Result<RegisterValue> registerValueFromText(std::string_view type, std::string_view text)
{
    if (type == "Boolean")
        return boolean(text);
    if (type == "Int32")
        return number<std::int32_t>(type, text, text,
            integerRange<std::int32_t>(
                AXISCOMP_TEXT("Error", "a whole number from {least} to {most}")));
    if (type == "UInt32")
        return unsignedInteger(text);
    if (type == "Single")
        return number<float>(type, text, text, floatRange<float>());
    if (type == "Double")
        return number<double>(type, text, text, floatRange<double>());
    return enumValue(type, text);
}

std::string normalisedPath(std::string_view path)
{
    const auto isSeparator = [](char c) { return c == '/' || c == '.'; };
    while (!path.empty() && isSeparator(path.front()))
        path.remove_prefix(1);
    while (!path.empty() && isSeparator(path.back()))
        path.remove_suffix(1);
    std::string result(path);
    std::ranges::replace(result, '.', '/');
    return result;
}

} // namespace axiscomp
