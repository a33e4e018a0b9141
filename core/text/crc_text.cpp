// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/crc_text.h"

#include <array>
#include <cstdio>

namespace axiscomp {

std::string crcText(std::uint32_t crc)
{
    std::array<char, 9> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%08x", crc);
    return buffer.data();
}

} // namespace axiscomp
