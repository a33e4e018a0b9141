// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/reference_lines.h"

#include <string>

namespace axiscomp::drivecomm {

/// The number of a line by a regular expression, whose first group, or all of it, is the number.
/// pattern: empty: none. Errors: InvalidArgument.
[[nodiscard]] Result<NumberFinder> numberPattern(const std::string& pattern);

} // namespace axiscomp::drivecomm
