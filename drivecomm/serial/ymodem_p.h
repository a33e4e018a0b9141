// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace axiscomp::drivecomm::ymodem {

constexpr std::uint8_t soh = 0x01; ///< begins a block of 128 bytes
constexpr std::uint8_t stx = 0x02; ///< begins a block of 1024 bytes
constexpr std::uint8_t eot = 0x04;
constexpr std::uint8_t ack = 0x06;
constexpr std::uint8_t nak = 0x15;
constexpr std::uint8_t can = 0x18;
constexpr std::uint8_t backspace = 0x08; ///< some send it after CAN, to tidy up a terminal
constexpr std::uint8_t promptCrc = 'C';
constexpr std::uint8_t padding = 0x1A;

constexpr std::size_t shortBlock = 128;
constexpr std::size_t longBlock = 1024;
constexpr std::size_t blockOverhead = 5; ///< kind, number and its complement, CRC

} // namespace axiscomp::drivecomm::ymodem
