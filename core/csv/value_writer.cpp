// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/value_writer.h"

#include "core/text/number_parser.h"
#include "core/text/number_text.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

namespace axiscomp::csv {

namespace {

constexpr int mostDecimals = 12;
// A float32 of 24 bits times 10^12, of which 28 bits are odd, is exact in a double.
constexpr std::array<double, mostDecimals + 1> powers{
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
constexpr double mostWhole = 4e9; // float32 needs nine digits

/// The number whole / 10^decimals.
struct Decimal {
    double whole = 0.0; ///< up to mostWhole
    int decimals = 0;
};

/// The nearest whole number; of two that are as near, the even one. number: below 2^51.
double nearestWhole(double number)
{
    constexpr double ulpIsOne = 0x1.8p52;
    return (number + ulpIsOne) - ulpIsOne;
}

/// size with so many decimals.
Decimal rounded(float size, int decimals)
{
    return {nearestWhole(static_cast<double>(size) * powers[static_cast<std::size_t>(decimals)]),
        decimals};
}

bool isReadAs(float size, Decimal decimal)
{
    return static_cast<float>(decimal.whole / powers[static_cast<std::size_t>(decimal.decimals)])
        == size;
}

/// That with the fewest decimals which is read as this size; decimals: where to begin. Nothing: it
/// takes more than are tried.
std::optional<Decimal> shortest(float size, int decimals)
{
    Decimal found = rounded(size, decimals);
    while (found.whole > mostWhole && found.decimals > 0)
        found = rounded(size, found.decimals - 1);
    if (isReadAs(size, found)) {
        while (found.decimals > 0) {
            const Decimal shorter = rounded(size, found.decimals - 1);
            if (!isReadAs(size, shorter))
                break;
            found = shorter;
        }
        return found;
    }
    while (found.decimals < mostDecimals) {
        found = rounded(size, found.decimals + 1);
        if (found.whole > mostWhole)
            break;
        if (isReadAs(size, found))
            return found;
    }
    return std::nullopt;
}

struct DigitPairs {
    std::array<char, 200> text{};
    constexpr DigitPairs()
    {
        for (std::size_t n = 0; n < 100; ++n) {
            text[2 * n] = static_cast<char>('0' + n / 10);
            text[2 * n + 1] = static_cast<char>('0' + n % 10);
        }
    }
};
constexpr DigitPairs pairs;

/// 16 digits, leading zeros among them, and room behind them.
std::array<char, 32> digitsOf(std::uint64_t whole)
{
    std::array<char, 32> digits{'0', '0', '0', '0', '0', '0'};
    const auto put = [&digits](std::size_t place, std::uint32_t pair) {
        std::memcpy(digits.data() + place, pairs.text.data() + 2 * std::size_t{pair}, 2);
    };
    const auto high = static_cast<std::uint32_t>(whole / 100'000'000);
    const auto low = static_cast<std::uint32_t>(whole % 100'000'000);
    put(6, high);
    put(8, low / 1'000'000);
    put(10, low / 10'000 % 100);
    put(12, low / 100 % 100);
    put(14, low % 100);
    return digits;
}

char* writeDecimal(Decimal decimal, bool isNegative, char* buffer)
{
    *buffer = '-';
    buffer += isNegative ? 1 : 0;
    const auto decimals = static_cast<std::size_t>(decimal.decimals);
    std::size_t before = 1; // digits before the point
    for (double next = 10.0 * powers[decimals]; decimal.whole >= next; next *= 10.0)
        ++before;
    const auto digits = digitsOf(static_cast<std::uint64_t>(decimal.whole));
    std::memcpy(buffer, digits.data() + 16 - decimals - before, 16);
    if (decimals == 0)
        return buffer + before;
    buffer[before] = '.';
    std::memcpy(buffer + before + 1, digits.data() + 16 - decimals, 16);
    return buffer + before + 1 + decimals;
}

/// Any float32: with an exponent, or more digits.
char* writeAny(float value, char* buffer)
{
    char* end = writeText(value, buffer);
    *end = ','; // which parseShortNumber needs
    Number read;
    const bool isRead = parseShortNumber(buffer, '.', read) == end
        || parseNumber({buffer, end}, '.', read) == NumberFault::None;
    if (!isRead || static_cast<float>(read.value) != value)
        end = writeText(static_cast<double>(value), buffer);
    return end;
}

} // namespace

char* ValueWriter::write(float value, char* buffer)
{
    const float size = std::abs(value);
    const bool isPlain = size == 0.0F || (size >= 1e-7F && size < 1e9F); // as writeText has it
    const auto decimal = isPlain ? shortest(size, m_decimals) : std::nullopt;
    char* end = nullptr;
    if (decimal) {
        m_decimals = decimal->decimals;
        end = writeDecimal(*decimal, std::signbit(value), buffer);
    } else {
        end = writeAny(value, buffer);
    }
    *end = ',';
    return end + 1;
}

} // namespace axiscomp::csv
