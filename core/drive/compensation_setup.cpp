// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/compensation_setup.h"

#include "core/text/crc_text.h"

namespace axiscomp {

std::string sourceName(const DimSource& source)
{
    return source.path.empty() ? "0x" + crcText(source.address) : source.path;
}

std::string sourceUri(const std::string& drive, const std::string& path)
{
    return "tam://mc/" + drive + "/" + path;
}

} // namespace axiscomp
