// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/field_codec.h"

#include <limits>

namespace axiscomp {

namespace {

template <typename Span> Span item(Span header, const FieldPlace& place, std::uint32_t index)
{
    const std::uint32_t size = place.byteCount() / place.count;
    return header.subspan(place.offset + std::size_t{size} * index, size);
}

template <typename T>
bool storeExact(std::span<std::byte> bytes, std::int64_t value, bool littleEndian)
{
    if (value < std::int64_t{std::numeric_limits<T>::min()}
        || value > std::int64_t{std::numeric_limits<T>::max()})
        return false;
    storeAt(bytes, static_cast<T>(value), littleEndian);
    return true;
}

} // namespace

std::int64_t loadInteger(
    ByteView header, const FieldPlace& place, std::uint32_t index, bool littleEndian)
{
    const ByteView bytes = item(header, place, index);
    switch (place.type) {
    case FieldType::U8:
        return loadAt<std::uint8_t>(bytes, littleEndian);
    case FieldType::U16:
        return loadAt<std::uint16_t>(bytes, littleEndian);
    case FieldType::I32:
        return loadAt<std::int32_t>(bytes, littleEndian);
    default:
        return loadAt<std::uint32_t>(bytes, littleEndian);
    }
}

bool storeInteger(std::span<std::byte> header, const FieldPlace& place, std::uint32_t index,
    std::int64_t value, bool littleEndian)
{
    const std::span<std::byte> bytes = item(header, place, index);
    switch (place.type) {
    case FieldType::U8:
        return storeExact<std::uint8_t>(bytes, value, littleEndian);
    case FieldType::U16:
        return storeExact<std::uint16_t>(bytes, value, littleEndian);
    case FieldType::I32:
        return storeExact<std::int32_t>(bytes, value, littleEndian);
    default:
        return storeExact<std::uint32_t>(bytes, value, littleEndian);
    }
}

double loadNumber(ByteView header, const FieldPlace& place, std::uint32_t index, bool littleEndian)
{
    const ByteView bytes = item(header, place, index);
    if (place.type == FieldType::F32)
        return static_cast<double>(loadAt<float>(bytes, littleEndian));
    return loadAt<double>(bytes, littleEndian);
}

void storeNumber(std::span<std::byte> header, const FieldPlace& place, std::uint32_t index,
    double value, bool littleEndian)
{
    const std::span<std::byte> bytes = item(header, place, index);
    if (place.type == FieldType::F32)
        storeAt(bytes, static_cast<float>(value), littleEndian);
    else
        storeAt(bytes, value, littleEndian);
}

} // namespace axiscomp
