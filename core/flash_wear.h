// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_profile.h"

#include <chrono>
#include <vector>

namespace axiscomp {

using WallTime = std::chrono::system_clock::time_point;

/// What may be stored to flash now.
struct FlashBudget {
    int left = 0; ///< operations left in the current window
    std::chrono::seconds wait{0}; ///< until one more is possible, 0 when left > 0
};

/// Counts flash operations in a sliding window (DriveProfile::flashWear). Knows only what it was
/// told; the history across starts is kept by DriveStore.
class FlashWearGuard {
public:
    explicit FlashWearGuard(FlashWearLimits limits, std::vector<WallTime> operations = {});

    [[nodiscard]] FlashBudget budget(WallTime now) const;
    void record(WallTime now, int operations = 1);
    /// The drive itself reported wear: nothing is possible before now + wait.
    void recordRefusal(WallTime now, std::chrono::seconds wait);
    /// Those that still count, oldest first.
    [[nodiscard]] std::vector<WallTime> operations(WallTime now) const;

private:
    FlashWearLimits m_limits;
    std::vector<WallTime> m_operations;
    WallTime m_refusedUntil{};
};

} // namespace axiscomp
