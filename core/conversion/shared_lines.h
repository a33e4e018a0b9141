// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/neutral/table_motion.h"

#include <algorithm>
#include <cstddef>

namespace axiscomp {

/// Calls visit(part, number of a line) for all lines; those of a part one after the other, the
/// parts on all processors. What each part finds is put together in their order, so that the result
/// is the same for any number of threads.
template <typename Visit> void shareLines(const TableLines& lines, Visit visit)
{
    shareWork(lines.parts(), 0, [&](std::size_t part) {
        const std::size_t end = std::min(lines.count, (part + 1) * lines.perPart());
        for (std::size_t n = part * lines.perPart(); n < end; ++n)
            visit(part, n);
    });
}

} // namespace axiscomp
