// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

namespace axiscomp {

enum class LetterCase { Matters, Ignored };

/// How many bytes have to be inserted, removed or replaced to make one text of the other: finds
/// what was meant by a name that is misspelled. limit when it is not below that.
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b,
    LetterCase letters = LetterCase::Matters,
    std::size_t limit = std::numeric_limits<std::size_t>::max());

} // namespace axiscomp
