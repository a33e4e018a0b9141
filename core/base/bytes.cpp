// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bytes.h"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t noDigit = 0xff;

constexpr auto digitValues = [] {
    std::array<std::uint8_t, 256> result{};
    result.fill(noDigit);
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        result[static_cast<unsigned char>(alphabet[i])] = static_cast<std::uint8_t>(i);
    return result;
}();

} // namespace

std::uint32_t crc32(ByteView bytes)
{
    return static_cast<std::uint32_t>(
        ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string toBase64(ByteView bytes)
{
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? alphabet[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

std::optional<Bytes> fromBase64(std::string_view text)
{
    if (text.size() % 4 != 0)
        return std::nullopt;
    const std::size_t padding = text.ends_with("==") ? 2U : text.ends_with("=") ? 1U : 0U;

    Bytes bytes;
    bytes.reserve(text.size() / 4 * 3);
    for (std::size_t i = 0; i < text.size(); i += 4) {
        const std::size_t digits = i + 4 < text.size() ? 4 : 4 - padding;
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint8_t value =
                k < digits ? digitValues[static_cast<unsigned char>(text[i + k])] : 0;
            if (value == noDigit)
                return std::nullopt;
            group = group << 6 | value;
        }
        const std::size_t count = digits - 1;
        if ((group & (0xffffffU >> (8 * count))) != 0)
            return std::nullopt;
        for (std::size_t k = 0; k < count; ++k)
            bytes.push_back(static_cast<std::byte>(group >> (16 - 8 * k) & 0xffU));
    }
    return bytes;
}

} // namespace axiscomp
