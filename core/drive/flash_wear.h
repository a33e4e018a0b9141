// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"
#include "core/drive/drive_profile.h"

#include <chrono>
#include <vector>

namespace axiscomp {

/// What may be stored to flash now.
struct FlashBudget {
    int left = 0; ///< operations left in the current window
    std::chrono::seconds wait{0}; ///< until those wanted are possible, 0 when now; rounded up
    /// What was recorded is lost: none are left until the user decides otherwise, however long one
    /// waits.
    bool isRecordLost = false;
};

/// Counts flash operations in a sliding window (DriveProfile::flashWear) as the drive does: an
/// operation counts from its moment until exactly one window later, and at that moment no longer.
/// Limits of 0 operations mean that none are known: everything is possible. Knows only what it was
/// told; the history across starts is kept by DriveStore.
///
/// The clock may be set. An operation that seems to lie in the future counts too, as it must have
/// happened, unless it lies a whole window or more ahead: then the clock was wrong when it was
/// recorded, or is now, and waiting for it could last for years. The drive still has the last word.
class FlashWearGuard {
public:
    explicit FlashWearGuard(FlashWearLimits limits, std::vector<WallTime> operations = {});

    [[nodiscard]] FlashBudget budget(WallTime now, int wanted = 1) const;
    void record(WallTime now, int operations = 1);
    /// The drive itself reported wear: nothing is possible before now + wait.
    void recordRefusal(WallTime now, std::chrono::seconds wait);
    /// Operations may be missing: nothing is possible where there is a limit.
    void recordLoss() { m_isRecordLost = true; }
    /// Those that still count, oldest first.
    [[nodiscard]] std::vector<WallTime> operations(WallTime now) const;

private:
    [[nodiscard]] bool counts(WallTime operation, WallTime now) const;

    FlashWearLimits m_limits;
    std::vector<WallTime> m_operations; ///< oldest first
    WallTime m_refusedAt{};
    std::chrono::seconds m_refusalWait{0}; ///< 0: the drive has not refused
    bool m_isRecordLost = false;
};

} // namespace axiscomp
