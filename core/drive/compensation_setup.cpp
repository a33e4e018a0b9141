// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/compensation_setup.h"

namespace axiscomp {

std::string sourceUri(const std::string& drive, const std::string& path)
{
    return "tam://mc/" + drive + "/" + path;
}

} // namespace axiscomp
