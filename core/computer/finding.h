// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/base/wall_time.h"

#include <cstdint>
#include <vector>

namespace axiscomp {

enum class Grade {
    Ok,
    Note, ///< worth knowing; nothing is wrong
    Problem, ///< something does not work, or will not when it is needed
};

/// One line of what is said about this computer.
struct Finding {
    Text name; ///< what was looked at: "database"
    Grade grade = Grade::Ok;
    Text found;
    Text wayOut = {}; ///< what to do about it; empty: nothing
};

struct FindingSection {
    Text title;
    std::vector<Finding> findings;
};

/// "3.4 MB"
[[nodiscard]] Quantity byteQuantity(std::uint64_t bytes);
/// "2026-11-21T08:02:23Z", whole seconds
[[nodiscard]] Verbatim secondText(WallTime time);

} // namespace axiscomp
