// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace axiscomp {

[[nodiscard]] std::size_t processorCount(); ///< at least 1

/// Calls work(0) to work(count - 1), at most mostAtOnce of them at the same time, each on a thread
/// that is not the caller's where the system has one, and returns when all have ended. An exception
/// is thrown on to the caller; what had not begun by then is left out. A call that waits, as for a
/// drive that does not answer, holds up nothing but itself.
void forEachAtOnce(
    std::size_t count, std::size_t mostAtOnce, const std::function<void(std::size_t)>& work);

/// Calls work(0) to work(count - 1) for work that keeps a processor busy: on the calling thread and
/// as many others as make `threads` of them, 0 for one on each processor. They begin in this order,
/// and all have ended when it returns. An exception is thrown on to the caller; what had not begun
/// by then is left out.
void shareWork(
    std::size_t count, std::size_t threads, const std::function<void(std::size_t)>& work);

} // namespace axiscomp
