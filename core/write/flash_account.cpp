// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/flash_account.h"

#include "core/axis/register_access.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace axiscomp {

Result<EraseCounts> readEraseCounts(
    const RegisterAccess& access, const std::vector<std::string>& slots)
{
    std::vector<std::string> paths;
    for (const std::string& slot : slots)
        paths.push_back(access.slotPath(access.registers().tableEraseCount, slot));
    AXISCOMP_TRY(auto readings, access.readAvailable(paths));
    EraseCounts counts;
    for (std::size_t n = 0; n < slots.size(); ++n) {
        if (readings.contains(paths[n]))
            counts[slots[n]] = unsignedAt(readings, paths[n]);
    }
    return counts;
}

Result<FlashUse> readFlashUse(
    const RegisterAccess& access, DriveStore& store, const DriveIdentity& drive, WallTime now)
{
    AXISCOMP_TRY(auto history, store.flashHistory(drive.serialNumber));
    std::vector<std::string> slots;
    for (const TableSlot& slot : access.profile().tableSlots)
        slots.push_back(slot.name);
    AXISCOMP_TRY(auto counts, readEraseCounts(access, slots));
    const FlashWearLimits& limits = access.profile().flashWear;
    FlashUse use;
    use.budget = wearGuard(limits, history).budget(now);
    use.operationsRecorded = history.total;
    use.ratedCycles = limits.ratedCycles;
    use.damagedRecord = history.damagedRecord;
    for (const std::string& slot : slots) { // the first of several with the same count
        const auto count = counts.find(slot);
        if (count == counts.end())
            continue;
        use.allCycles += count->second;
        if (use.mostUsedSlot.empty() || count->second > use.mostCycles) {
            use.mostUsedSlot = slot;
            use.mostCycles = count->second;
        }
    }
    return use;
}

Result<void> checkFlashBudget(
    const FlashWearGuard& guard, WallTime now, int operations, int reserve)
{
    const FlashBudget budget = guard.budget(now, operations + reserve);
    if (operations + reserve <= budget.left)
        return {};
    ErrorContext context{{"seconds", budget.wait.count()}};
    if (budget.isRecordLost)
        context.set("record", Verbatim{"damaged"});
    else if (operations <= budget.left)
        context.set("reserve", reserve);
    return fail(ErrorCode::FlashWear, std::move(context));
}

bool mayHaveSpentFlash(const Error& error)
{
    // What was asked before the connection was found to be gone, or to lead to another drive, may
    // have arrived.
    return isUncertain(error.code) || isUnreachable(error.code)
        || error.code == ErrorCode::OtherDrive || error.code == ErrorCode::VerifyMismatch;
}

void FlashAccount::record(const EraseCounts& before, const EraseCounts& after, int assumed)
{
    std::int64_t operations = before.empty() ? assumed : 0;
    for (const auto& [slot, count] : before) {
        const auto now = after.find(slot);
        if (now == after.end())
            operations += assumed;
        else if (now->second > count)
            operations += now->second - count;
    }
    record(static_cast<int>(std::min<std::int64_t>(operations, std::numeric_limits<int>::max())));
}

void FlashAccount::record(int operations)
{
    m_recorded += operations;
    // A write that has reached flash is not undone because of a full disk here.
    (void)m_store.recordFlash(m_serialNumber, m_clock(), operations);
}

void FlashAccount::noteRefusal(const Error& error)
{
    const auto seconds = error.context.integer("seconds");
    if (error.code == ErrorCode::FlashWear && seconds && *seconds > 0)
        (void)m_store.recordFlashRefusal(m_serialNumber, m_clock(), std::chrono::seconds(*seconds));
}

} // namespace axiscomp
