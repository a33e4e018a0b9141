// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/number_text.h"
#include "core/base/portable_math.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace axiscomp::app {

namespace {

constexpr std::size_t comfortableLength = 10;
constexpr int comfortableDigits = 7;

template <typename... Arguments> std::string toChars(Arguments... arguments)
{
    std::array<char, 512> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), arguments...);
    return error == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

} // namespace

std::string shortText(double value)
{
    const auto single = static_cast<float>(value);
    const bool isSingle = static_cast<double>(single) == value;
    std::string text = isSingle ? toChars(single) : toChars(value);
    if (text.size() > comfortableLength)
        text = toChars(value, std::chars_format::general, comfortableDigits);
    return text;
}

std::string floatText(double value)
{
    return toChars(static_cast<float>(value));
}

std::string fixedText(double value, int decimals)
{
    return toChars(value, std::chars_format::fixed, decimals);
}

int decimalsOf(double value, int most)
{
    const auto single = static_cast<float>(value);
    const bool isSingle = static_cast<double>(single) == value;
    const std::string text = isSingle ? toChars(single, std::chars_format::fixed)
                                      : toChars(value, std::chars_format::fixed);
    const std::size_t point = text.find('.');
    const std::size_t digits = point == std::string::npos ? 0 : text.size() - point - 1;
    return static_cast<int>(std::min(digits, static_cast<std::size_t>(most)));
}

std::vector<std::string> columnTexts(const std::vector<double>& values)
{
    constexpr int mostDecimals = 15;
    double largest = 0.0;
    int needed = 0;
    for (const double value : values) {
        if (!std::isfinite(value))
            continue;
        largest = std::max(largest, std::abs(value));
        needed = std::max(needed, decimalsOf(value, mostDecimals));
    }
    const int wholeDigits =
        largest > 0.0 ? static_cast<int>(std::floor(portable::log10(largest))) + 1 : 1;
    const int decimals =
        std::min(needed, std::clamp(comfortableDigits - wholeDigits, 0, mostDecimals));
    std::vector<std::string> texts;
    for (const double value : values)
        texts.push_back(fixedText(value, decimals));
    return texts;
}

std::string signedText(std::string text)
{
    return text.starts_with('-') || text == "0" ? text : "+" + text;
}

std::string hexText(std::uint32_t value)
{
    const std::string digits = toChars(value, 16);
    return std::string(8 - digits.size(), '0') + digits;
}

std::string countText(std::uint64_t value)
{
    std::string text = std::to_string(value);
    for (std::size_t place = text.size(); place > 3; place -= 3)
        text.insert(place - 3, 1, ' ');
    return text;
}

std::string plural(std::uint64_t count, std::string_view one, std::string_view many)
{
    return countText(count) + " " + std::string(count == 1 ? one : many);
}

std::optional<double> numberFromText(std::string_view text)
{
    const bool hasTwoSigns =
        text.size() > 1 && text[0] == '+' && (text[1] == '+' || text[1] == '-');
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = error == std::errc{} && end == text.data() + text.size();
    if (!isWhole || hasTwoSigns || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string withUnit(const std::string& number, std::string_view unit)
{
    return unit.empty() ? number : number + " " + std::string(unit);
}

} // namespace axiscomp::app
