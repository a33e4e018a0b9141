// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/table/table_layout.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

namespace axiscomp {

static_assert(
    std::endian::native == std::endian::little || std::endian::native == std::endian::big);

[[nodiscard]] inline bool isNativeOrder(bool littleEndian)
{
    return littleEndian == (std::endian::native == std::endian::little);
}

template <typename T> [[nodiscard]] T reversedBytes(T value)
{
    auto bytes = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
    for (std::size_t i = 0; i < bytes.size() / 2; ++i)
        std::swap(bytes[i], bytes[bytes.size() - 1 - i]);
    return std::bit_cast<T>(bytes);
}

/// bytes.size() >= sizeof(T), as in storeAt.
template <typename T> [[nodiscard]] T loadAt(ByteView bytes, bool littleEndian)
{
    T value{};
    std::memcpy(&value, bytes.data(), sizeof(T));
    return isNativeOrder(littleEndian) ? value : reversedBytes(value);
}

template <typename T> void storeAt(std::span<std::byte> bytes, T value, bool littleEndian)
{
    const T stored = isNativeOrder(littleEndian) ? value : reversedBytes(value);
    std::memcpy(bytes.data(), &stored, sizeof(T));
}

/// Item `index` of an integer field (u8, u16, u32, i32). header holds the whole place.
[[nodiscard]] std::int64_t loadInteger(
    ByteView header, const FieldPlace& place, std::uint32_t index, bool littleEndian);
/// False, and nothing is stored, when the field's type cannot hold the value.
[[nodiscard]] bool storeInteger(std::span<std::byte> header, const FieldPlace& place,
    std::uint32_t index, std::int64_t value, bool littleEndian);

/// Item `index` of a floating field (f32, f64).
[[nodiscard]] double loadNumber(
    ByteView header, const FieldPlace& place, std::uint32_t index, bool littleEndian);
/// Rounds to the field's type; value must be within its range.
void storeNumber(std::span<std::byte> header, const FieldPlace& place, std::uint32_t index,
    double value, bool littleEndian);

} // namespace axiscomp
