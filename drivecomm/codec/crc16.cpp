// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/crc16.h"

#include <array>

namespace axiscomp::drivecomm {

namespace {

constexpr auto table = [] {
    std::array<std::uint16_t, 256> result{};
    for (std::uint32_t i = 0; i < result.size(); ++i) {
        std::uint32_t crc = i << 8U;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 0x8000U) != 0 ? (crc << 1U) ^ 0x1021U : crc << 1U;
        result[i] = static_cast<std::uint16_t>(crc);
    }
    return result;
}();

} // namespace

std::uint16_t crc16(ByteView bytes, std::uint16_t start)
{
    std::uint16_t crc = start;
    for (const std::byte byte : bytes) {
        const std::uint32_t index = (crc >> 8U) ^ std::to_integer<std::uint32_t>(byte);
        crc = static_cast<std::uint16_t>((static_cast<std::uint32_t>(crc) << 8U) ^ table[index]);
    }
    return crc;
}

} // namespace axiscomp::drivecomm
