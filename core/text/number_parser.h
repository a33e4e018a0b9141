// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace axiscomp {

struct Number {
    double value = 0.0;
    int lastDecimal = 0; ///< exponent of ten of the last digit: -3 for 0.125, 2 for 1e2
};

enum class NumberFault {
    None,
    NotANumber,
    NotFinite, ///< nan, inf, or too large for a double
    TooSmall, ///< so small that a double cannot hold it
};

/// Reads what std::from_chars reads in the whole of text, with decimal in place of the point, and a
/// leading '+'. Exact: the nearest double.
[[nodiscard]] NumberFault parseNumber(std::string_view text, char decimal, Number& number);
/// The value alone, of a number with a decimal point: in half the time.
[[nodiscard]] NumberFault parseValue(std::string_view text, double& value);

/// The longest text that parseShortNumber looks at, with what it loads in advance.
inline constexpr std::size_t shortNumberReach = 40;

namespace detail {

inline constexpr double powersOfTen[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10,
    1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
inline constexpr std::uint32_t wholePowersOfTen[] = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

struct Digits {
    std::uint64_t value;
    unsigned count; ///< 0 to 8
};

/// 10 and more: none.
inline unsigned digitAt(const char* p)
{
    return static_cast<unsigned char>(*p) - unsigned{'0'};
}

/// The decimal digits at the beginning of 8 readable characters, all at once.
inline Digits leadingDigits(const char* p)
{
    static_assert(std::endian::native == std::endian::little);
    std::uint64_t word = 0;
    std::memcpy(&word, p, sizeof word);
    word ^= 0x3030303030303030U;
    const std::uint64_t others = ((word + 0x7676767676767676U) | word) & 0x8080808080808080U;
    const auto bits = static_cast<unsigned>(std::countr_zero(others)) & ~7U; // 64 without others
    if (bits == 0)
        return {0, 0};
    word <<= 64U - bits;
    word = word * 10 + (word >> 8U);
    const std::uint64_t high = (word & 0x000000FF000000FFU) * 0x000F424000000064U;
    const std::uint64_t low = ((word >> 16U) & 0x000000FF000000FFU) * 0x0000271000000001U;
    return {(high + low) >> 32U, bits / 8};
}

/// The same behind eight others. Nanometres in millimetres with three digits more are one.
inline Digits digitsAfterEight(const char* p)
{
    const unsigned first = digitAt(p);
    return first < 10 && digitAt(p + 1) >= 10 ? Digits{first, 1} : leadingDigits(p);
}

} // namespace detail

/// A number of few digits, before its one rounding: value() is the nearest double.
struct ShortNumber {
    double digits = 0.0; ///< a whole number, with the sign
    unsigned decimals = 0; ///< of them

    [[nodiscard]] double value() const { return digits / detail::powersOfTen[decimals]; }
};

/// The common case of parseNumber: digits with or without decimals, no exponent. Returns what
/// follows the number, or nullptr when it takes parseNumber to tell. shortNumberReach characters
/// must be readable.
inline const char* parseShortNumber(const char* p, char decimal, ShortNumber& number)
{
    // Clinger's fast path: a mantissa up to 2^53 and a power of ten up to 10^22 are exact doubles,
    // and the division rounds once.
    constexpr std::uint64_t exactMantissa = std::uint64_t{1} << 53U;
    constexpr std::ptrdiff_t mostWholeDigits = 7;
    // Signs come at random: nothing here branches on them.
    const auto negative = static_cast<std::uint64_t>(*p == '-');
    p += negative | static_cast<std::uint64_t>(*p == '+');
    const char* const first = p;
    std::uint64_t mantissa = 0;
    for (unsigned digit = detail::digitAt(p); digit < 10; digit = detail::digitAt(p)) {
        if (p - first == mostWholeDigits)
            return nullptr;
        mantissa = mantissa * 10 + digit;
        ++p;
    }
    auto digits = static_cast<unsigned>(p - first);
    unsigned decimals = 0;
    if (*p == decimal) {
        detail::Digits part = detail::leadingDigits(p + 1);
        mantissa = mantissa * detail::wholePowersOfTen[part.count] + part.value;
        decimals = part.count;
        if (part.count == 8) {
            part = detail::digitsAfterEight(p + 9);
            if (digits + part.count > 10)
                return nullptr;
            mantissa = mantissa * detail::wholePowersOfTen[part.count] + part.value;
            decimals += part.count;
        }
        p += decimals + 1;
        digits += decimals;
    }
    const bool goesOn = detail::digitAt(p) < 10 || (static_cast<unsigned char>(*p) | 0x20U) == 'e';
    if (digits == 0 || goesOn || mantissa > exactMantissa)
        return nullptr;
    const auto size = std::bit_cast<std::uint64_t>(static_cast<double>(mantissa));
    number = {std::bit_cast<double>(size | negative << 63U), decimals};
    return p;
}

inline const char* parseShortNumber(const char* p, char decimal, Number& number)
{
    ShortNumber found;
    p = parseShortNumber(p, decimal, found);
    if (p != nullptr)
        number = {found.value(), -static_cast<int>(found.decimals)};
    return p;
}

} // namespace axiscomp
