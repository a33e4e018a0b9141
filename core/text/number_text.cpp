// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"

#include <array>
#include <charconv>

namespace axiscomp {

namespace {

template <typename Float> std::string plainText(Float value)
{
    constexpr Float smallest = static_cast<Float>(1e-7);
    constexpr Float largest = static_cast<Float>(1e15);
    const Float size = value < 0 ? -value : value;
    const bool plain = size == 0 || (size >= smallest && size < largest);
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
        plain ? std::chars_format::fixed : std::chars_format::scientific);
    return {buffer.data(), result.ptr};
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

std::string roundedText(double value)
{
    constexpr int digits = 12;
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    return {buffer.data(), result.ptr};
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
