// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the deletion of an axis's table, or its removal from flash, adds to a write: its plan and
// its steps.
#include "core/axis/slot_state.h"
#include "core/axis/verified_transfer.h"
#include "core/write/unfinished_write.h"
#include "core/write/write_planner.h"
#include "core/write/write_procedure.h"

#include <algorithm>

namespace axiscomp {

WriteRequest deletionRequest()
{
    WriteRequest request;
    request.deletesTable = true;
    request.withoutTable = true;
    request.dimensionality = 3; // whichever sources there are remain
    return request;
}

/// What the axis names, what a deletion that did not end has still to empty, or what the axis would
/// have again after a reboot.
Result<std::string> WritePlanner::slotToDelete(const WriteRequest& request)
{
    std::string name = request.slot.value_or(m_status.setup.slot);
    if (!name.empty())
        return name;
    AXISCOMP_TRY(const auto entry, m_store.journal(m_drive.serialNumber, m_axis));
    if (!entry || entry->deletedSlot.empty())
        return returningSlot();
    AXISCOMP_TRY(const auto unfinished, UnfinishedWrite::load(m_access, *entry));
    AXISCOMP_TRY(const auto rest, unfinished.request(m_store, m_drive));
    return rest.slot.value_or(name);
}

/// Of an axis that uses no table now: the slot that its saved parameters name, where flash has a
/// table. Empty: a reboot brings none back.
Result<std::string> WritePlanner::returningSlot() const
{
    const auto saved = std::ranges::find(m_saved.uses, m_axis, &SavedState::Use::axis);
    if (!m_status.setup.slot.empty() || saved == m_saved.uses.end())
        return std::string();
    AXISCOMP_TRY(const auto readings,
        m_access.readAvailable(slotStatePaths(m_access, m_drive, m_axis, saved->slot)));
    const SlotState state = slotState(m_access, m_drive, m_axis, saved->slot, readings);
    const bool isInFlash = state.persistent || m_saved.isCovered(saved->slot);
    return !state.isEmpty() && isInFlash ? saved->slot : std::string();
}

/// Whoever else uses the slot, now or after a reboot; empty: nobody. Notes what the slot holds.
Result<Text> WritePlanner::otherUser(const std::string& slot)
{
    AXISCOMP_TRY(const auto readings,
        m_access.readAvailable(slotStatePaths(m_access, m_drive, m_axis, slot)));
    m_write.slotBefore = slotState(m_access, m_drive, m_axis, slot, readings);
    if (!m_write.slotBefore.otherUser.isEmpty())
        return m_write.slotBefore.otherUser;
    const auto saved = m_saved.otherUser(slot, m_axis);
    return saved ? AXISCOMP_TEXT("Error", "axis {axis} after a reboot").with("axis", *saved)
                 : Text();
}

/// Flash holds the table for all who use the slot.
Result<void> WritePlanner::decideRemoval()
{
    const WritePlan& plan = m_write.plan;
    if (!removesFromFlash(plan))
        return {};
    AXISCOMP_TRY(auto user, otherUser(plan.after.slot));
    if (user.isEmpty())
        return {};
    return fail(ErrorCode::SlotInUse,
        {{"slot", plan.after.slot}, {"user", std::move(user)}, {"removing", Verbatim{"table"}}});
}

/// The axis must not name the slot any more, in memory or in the saved parameters, before it is
/// emptied.
Result<void> WritePlanner::decideDeletion(const WriteRequest& request)
{
    WritePlan& plan = m_write.plan;
    AXISCOMP_TRY(const std::string name, slotToDelete(request));
    const TableSlot* slot = m_access.profile().slotNamed(name);
    if (!slot)
        return fail(ErrorCode::NoTable, {{"axis", m_axis}, {"deleting", Verbatim{"table"}}});
    AXISCOMP_CHECK(decideNoTable(request));
    m_write.slot = *slot;
    AXISCOMP_TRY(auto user, otherUser(name));
    if (!user.isEmpty())
        return fail(ErrorCode::SlotInUse,
            {{"slot", name}, {"user", std::move(user)}, {"deleting", Verbatim{"table"}}});
    const bool isNamed = std::ranges::any_of(m_saved.uses,
        [&](const SavedState::Use& use) { return use.slot == name && use.axis == m_axis; });
    m_write.saves =
        !m_saved.isKnown || isNamed || m_write.slotBefore.persistent || m_saved.isCovered(name);
    plan.deletedSlot = name;
    if (!m_write.slotBefore.isEmpty())
        plan.changes.push_back(
            {slot->file, slotStateText(m_write.slotBefore).english(), "deleted"});
    return {};
}

void WritePlanner::warnOfDeletion()
{
    WritePlan& plan = m_write.plan;
    const Text axis = axisText(m_axis, m_status.axis.name);
    if (m_saved.isCovered(plan.deletedSlot))
        plan.warnings.push_back(AXISCOMP_TEXT(
            "Error", "Flash may hold an older table in {slot}: that one is deleted too.")
                                    .with("slot", plan.deletedSlot));
    if (m_write.saves) {
        plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "The parameters of all axes are saved before {slot} is emptied: otherwise {axis} could "
            "look for the deleted table after a reboot.")
                                    .with("slot", plan.deletedSlot)
                                    .with("axis", axis));
        return warnOfSaving();
    }
    warnOfSavedTable();
}

/// Of another slot than that of the table that goes.
void WritePlanner::warnOfSavedTable()
{
    const auto saved = std::ranges::find(m_saved.uses, m_axis, &SavedState::Use::axis);
    if (saved != m_saved.uses.end())
        m_write.plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "After a reboot {axis} uses the table in {slot} again, as its saved parameters say.")
                                            .with("axis", axisText(m_axis, m_status.axis.name))
                                            .with("slot", saved->slot));
}

/// The table stays on the drive, and the parameters are not saved.
void WritePlanner::warnOfDetaching()
{
    const WritePlan& plan = m_write.plan;
    const bool isBefore = plan.before.slot.empty(); // by an earlier write
    const std::string& slot = isBefore ? m_returningSlot : plan.before.slot;
    if (slot.empty())
        return;
    const bool isSaved = !m_saved.isKnown
        || std::ranges::any_of(m_saved.uses,
            [&](const SavedState::Use& use) { return use.axis == m_axis && use.slot == slot; });
    if (!isSaved)
        return warnOfSavedTable();
    const bool isInFlash =
        isBefore || m_saved.isCovered(slot) || plan.before.persistency == Persistency::Persistent;
    if (isInFlash)
        m_write.plan.warnings.push_back(AXISCOMP_TEXT("Error",
            "Flash keeps the table in {slot}: after a reboot {axis} uses it again. Delete the "
            "table first ('axiscomp delete') if it must not come back.")
                                            .with("slot", slot)
                                            .with("axis", axisText(m_axis, m_status.axis.name)));
}

/// Whenever this is interrupted, no axis names a table that is gone, not even after a reboot.
Result<void> WriteProcedure::deleteOldTable()
{
    AXISCOMP_CHECK(switchOver());
    if (m_write.saves) {
        AXISCOMP_CHECK(note("save", 0.93));
        m_savedTouched = true;
        AXISCOMP_CHECK(save(m_access));
    }
    AXISCOMP_CHECK(note("delete", 0.96));
    AXISCOMP_CHECK(m_access.checkDrive()); // what is read after saving may fail without a word
    const std::string& slot = m_write.plan.deletedSlot;
    m_slotTouched = deletesUnused();
    m_flashTouched = changesPersistency();
    const auto deleted = deleteTable(m_access, slot);
    if (!deleted) {
        m_flash.noteRefusal(deleted.error());
        if (!mayHaveSpentFlash(deleted.error()))
            return deleted;
    }
    const auto spent = recordSpent(changesPersistency() ? 1 : 0, deleted);
    if (!deleted)
        return deleted;
    AXISCOMP_CHECK(spent);
    return m_store.recordCovered(m_write.plan.drive.serialNumber, slot, false);
}

} // namespace axiscomp
