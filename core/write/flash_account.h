// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/base/wall_time.h"
#include "core/drive/flash_wear.h"
#include "core/store/drive_store.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axiscomp {

class RegisterAccess;

/// Flash cycles by slot: the drive's EraseCount registers, as far as it has them.
using EraseCounts = std::map<std::string, std::uint32_t, std::less<>>;
[[nodiscard]] Result<EraseCounts> readEraseCounts(
    const RegisterAccess& access, const std::vector<std::string>& slots);

/// What a drive's flash has gone through, and what it may still do now. Wear is per slot.
struct FlashUse {
    FlashBudget budget;
    std::uint64_t operationsRecorded = 0; ///< by this computer, all slots together
    std::string mostUsedSlot; ///< empty: the drive does not count
    std::uint32_t mostCycles = 0; ///< of that slot, whoever spent them
    std::uint64_t allCycles = 0; ///< of all slots that are counted
    std::uint32_t ratedCycles = 0; ///< usual life of one slot, 0: not known
    std::optional<std::filesystem::path> damagedRecord; ///< DriveStore::FlashHistory
};
[[nodiscard]] Result<FlashUse> readFlashUse(
    const RegisterAccess& access, DriveStore& store, const DriveIdentity& drive, WallTime now);

/// Whether so many operations are possible now, and beside them those that putting back may cost.
/// Errors: FlashWear with the seconds until they are, and with the reserve when only that is
/// missing.
[[nodiscard]] Result<void> checkFlashBudget(
    const FlashWearGuard& guard, WallTime now, int operations, int reserve = 0);

/// The drive may have carried out what failed, and have spent flash on it: it was asked once at
/// least, and did not refuse.
[[nodiscard]] bool mayHaveSpentFlash(const Error& error);

/// Keeps the store's account of one drive's flash operations while an operation runs: counts as the
/// drive counts where it tells, and remembers when the drive refuses.
class FlashAccount {
public:
    FlashAccount(DriveStore& store, std::int32_t serialNumber, std::function<WallTime()> clock)
        : m_store(store)
        , m_serialNumber(serialNumber)
        , m_clock(std::move(clock))
    {
    }

    /// What the counts say has happened between two readings; `assumed` where a slot has no count.
    void record(const EraseCounts& before, const EraseCounts& after, int assumed);
    void record(int operations);
    [[nodiscard]] int recorded() const { return m_recorded; }
    /// The drive itself reported wear; any other error is left aside.
    void noteRefusal(const Error& error);

private:
    DriveStore& m_store;
    std::int32_t m_serialNumber;
    std::function<WallTime()> m_clock;
    int m_recorded = 0;
};

} // namespace axiscomp
