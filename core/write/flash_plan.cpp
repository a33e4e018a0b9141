// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a write costs in flash operations, and what putting it back may cost.
#include "core/write/flash_account.h"
#include "core/write/write_planner.h"

namespace axiscomp {

Result<void> WritePlanner::decideFlash()
{
    AXISCOMP_TRY(auto history, m_store.flashHistory(m_drive.serialNumber));
    WritePlan& plan = m_write.plan;
    const FlashWearGuard guard = wearGuard(m_access.profile().flashWear, history);
    plan.flashBudget = guard.budget(m_now);
    if (!plan.deletedSlot.empty()) {
        const bool isCovering = m_saved.isCovered(plan.deletedSlot);
        const bool isStored = m_write.slotBefore.persistent;
        plan.flashOperations = (isStored || isCovering ? 1 : 0) + m_write.uncovered;
        plan.flashReserve = isStored ? 1 : 0; // flash gets it back
        auto possible = checkFlashBudget(guard, m_now, plan.flashOperations, plan.flashReserve);
        if (!possible)
            possible.error().context.set("waiting", Verbatim{plan.deletedSlot});
        return possible;
    }
    if (plan.after.slot.empty())
        return {};
    const bool persistent = plan.after.persistency == Persistency::Persistent;
    const bool changes = plan.slotReason != SlotReason::KeepTable
        ? persistent && !m_isStored
        : plan.after.persistency != plan.before.persistency;
    plan.flashOperations = (changes ? 1 : 0) + m_write.uncovered;
    plan.flashReserve = flashReserve(changes);
    auto possible = checkFlashBudget(guard, m_now, plan.flashOperations, plan.flashReserve);
    // To write volatile is the way out of neither of these.
    if (!possible && plan.slotReason == SlotReason::KeepTable)
        possible.error().context.set(
            removesFromFlash(plan) ? "removing" : "waiting", Verbatim{plan.after.slot});
    return possible;
}

bool removesFromFlash(const WritePlan& plan)
{
    return plan.slotReason == SlotReason::KeepTable && !plan.after.slot.empty()
        && plan.before.persistency == Persistency::Persistent
        && plan.after.persistency == Persistency::Volatile;
}

/// The flash operations that WriteProcedure::undo may need beyond those that the write has not
/// spent by then. A table that is left over in a slot that no axis uses costs none: it may stay.
int WritePlanner::flashReserve(bool isStoring) const
{
    const WritePlan& plan = m_write.plan;
    int operations = 0;
    const bool isInSlot =
        plan.slotReason == SlotReason::KeepTable || plan.after.slot == plan.before.slot;
    if (isInSlot)
        return isStoring ? 1 : 0; // flash gets back what the axis had
    if (plan.after.persistency != Persistency::Persistent)
        return 0;
    // What the user names may be a table that somebody needs.
    if (plan.slotReason == SlotReason::Named && isStoring && m_write.slotBefore.persistent)
        ++operations;
    // The parameters are saved once more, with the axis's volatile table.
    const bool wasCovering = m_status.table && !m_status.table->persistent
        && m_saved.isCovered(plan.before.slot) && !m_write.releases;
    return operations + (wasCovering ? 1 : 0);
}

} // namespace axiscomp
