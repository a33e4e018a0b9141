// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"
#include "core/base/portable_math.h"

#include <array>
#include <charconv>
#include <cmath>

namespace axiscomp {

namespace {

template <typename Float> char* writePlainText(Float value, char* buffer)
{
    constexpr Float smallest = static_cast<Float>(1e-7);
    constexpr Float largest = static_cast<Float>(1e15);
    const Float size = value < 0 ? -value : value;
    const bool plain = size == 0 || (size >= smallest && size < largest);
    // Without an exponent: a sign, "0.", six zeros and 17 digits at most; with one, 24 characters.
    return std::to_chars(buffer, buffer + longestText, value,
        plain ? std::chars_format::fixed : std::chars_format::scientific)
        .ptr;
}

template <typename Float> std::string plainText(Float value)
{
    std::array<char, longestText> buffer{};
    return {buffer.data(), writePlainText(value, buffer.data())};
}

template <typename Float> std::string fewestCharacters(Float value)
{
    // 17 digits, sign, point and a four character exponent are the longest.
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

} // namespace

std::string toText(double value)
{
    return plainText(value);
}

std::string toText(float value)
{
    return plainText(value);
}

char* writeText(float value, char* buffer)
{
    return writePlainText(value, buffer);
}

char* writeText(double value, char* buffer)
{
    return writePlainText(value, buffer);
}

std::string fixedDigits(double value, int decimals)
{
    std::array<char, 400> buffer{}; // the largest double has 309 digits
    const auto end = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    std::string digits(buffer.data(), end.ptr);
    if (digits.starts_with('-') && digits.find_first_of("123456789") == std::string::npos)
        digits.erase(0, 1);
    return digits;
}

std::string significantText(double value, int digits)
{
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    return {buffer.data(), result.ptr};
}

std::string roundedText(double value)
{
    constexpr int digits = 12;
    return significantText(value, digits);
}

std::string sizeText(std::span<const std::size_t> counts)
{
    std::string text;
    for (const std::size_t count : counts)
        text += (text.empty() ? "" : " x ") + std::to_string(count);
    return text;
}

std::string percentText(double share)
{
    constexpr double roundingAllowance = 1.0 + 1e-12;
    const double percent = 100.0 * share * roundingAllowance;
    if (!(percent > 0.0))
        return "0";
    if (share >= 1.0)
        return "100";
    const double scale =
        percent >= 10.0 ? 1.0 : portable::pow(10.0, 1.0 - std::floor(portable::log10(percent)));
    return roundedText(std::floor(percent * scale) / scale);
}

std::string shortestText(double value)
{
    return fewestCharacters(value);
}

std::string shortestText(float value)
{
    return fewestCharacters(value);
}

} // namespace axiscomp
