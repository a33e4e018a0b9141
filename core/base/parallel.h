// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace axiscomp {

/// Calls work(0) to work(count - 1), at most mostAtOnce of them at the same time, each on a thread
/// that is not the caller's, and returns when all have ended. A call that waits, as for a drive
/// that does not answer, holds up nothing but itself.
void forEachAtOnce(
    std::size_t count, std::size_t mostAtOnce, const std::function<void(std::size_t)>& work);

} // namespace axiscomp
