// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace axiscomp {

/// How many bytes have to be inserted, removed or replaced to make one text of the other: finds
/// what was meant by a name that is misspelled.
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

} // namespace axiscomp
