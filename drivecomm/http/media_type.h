// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// "text/html" of "Text/HTML; charset=utf-8".
[[nodiscard]] std::string mediaType(std::string_view contentType);

} // namespace axiscomp::drivecomm
