// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bytes.h"

#include <zlib.h>

namespace axiscomp {

std::uint32_t crc32(ByteView bytes)
{
    return static_cast<std::uint32_t>(
        ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

} // namespace axiscomp
