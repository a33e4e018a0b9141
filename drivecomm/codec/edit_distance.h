// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace axiscomp::drivecomm {

/// Levenshtein distance without regard to case; limit when it is not below limit.
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b, std::size_t limit);

} // namespace axiscomp::drivecomm
