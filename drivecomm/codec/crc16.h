// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"

#include <cstdint>

namespace axiscomp::drivecomm {

/// CRC-16 with the polynomial 0x1021, most significant bit first, no final XOR. Where it starts
/// tells its two kinds apart.
constexpr std::uint16_t crcCcittFalse = 0xFFFF; ///< lines of the serial link
constexpr std::uint16_t crcXmodem = 0; ///< blocks of YMODEM

[[nodiscard]] std::uint16_t crc16(ByteView bytes, std::uint16_t start);

} // namespace axiscomp::drivecomm
