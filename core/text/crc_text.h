// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace axiscomp {

/// "1c291ca3"
[[nodiscard]] std::string crcText(std::uint32_t crc);

} // namespace axiscomp
