// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http/media_type.h"

namespace axiscomp::drivecomm {

std::string mediaType(std::string_view contentType)
{
    std::string type;
    for (const char c : contentType.substr(0, contentType.find(';')))
        if (c != ' ' && c != '\t')
            type += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    return type;
}

} // namespace axiscomp::drivecomm
