// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/verified_transfer.h"
#include "core/write/parameter_saving.h"
#include "core/write/restored_axis.h"
#include "core/write/slot_file.h"
#include "core/write/unfinished_write.h"
#include "core/write/write_procedure.h"

#include <algorithm>

namespace axiscomp {

namespace {

Bytes bytesOf(const AxisBackup& backup, const std::string& slot)
{
    const auto file = std::ranges::find(backup.files, slot, &AxisBackup::File::slot);
    return file == backup.files.end() ? Bytes{} : file->bytes;
}

} // namespace

/// What that write may have changed so far.
Result<void> WriteProcedure::takeUp(const UnfinishedWrite& unfinished)
{
    m_backup = unfinished.before();
    const int step = stepRank(unfinished.entry().step);
    m_slotTouched = isNewTable() && step >= stepRank("upload");
    const char* const flashStep = deletes() ? "delete" : isNewTable() ? "commit" : "switch";
    m_flashTouched = changesPersistency() && step >= stepRank(flashStep);
    m_savedTouched = (step >= stepRank("save") && (!deletes() || m_write.saves))
        || (overwritesOwn() && wantsPersistent());
    AXISCOMP_TRY(auto saved, m_store.savedState(m_write.plan.drive.serialNumber));
    // It is switched off in the saved parameters as well, by this write or by the next of another
    // axis.
    const bool isSavedOff = saved.isKnown
        && std::ranges::find(saved.uses, m_write.plan.axis, &SavedState::Use::axis)
            == saved.uses.end();
    const bool wasPersistent = unfinished.oldFile() && unfinished.oldFile()->persistent;
    m_savedTouched = m_savedTouched || (isSavedOff && (m_flashTouched || wasPersistent));
    // Another axis's write has saved what this one had put there: sources that are not the old
    // table's, which goes into flash again.
    const bool isSavedOtherwise =
        saved.isKnown && std::ranges::any_of(saved.uses, [&](const SavedState::Use& use) {
            return use.axis == m_write.plan.axis
                && (use.slot != unfinished.oldSlot() || use.crc != unfinished.oldCrc());
        });
    m_savedTouched = m_savedTouched || (isSavedOtherwise && wasPersistent);
    return {};
}

Result<int> WriteProcedure::costOfRecovery(const UnfinishedWrite& unfinished)
{
    AXISCOMP_CHECK(takeUp(unfinished));
    return costOfUndo();
}

Result<WriteReport> WriteProcedure::recoverOldState(const UnfinishedWrite& unfinished)
{
    AXISCOMP_CHECK(takeUp(unfinished));
    AXISCOMP_TRY(m_backup.registers, keptRegisters(m_access, m_sources, m_backup));
    // What reached flash has to leave it again: better not to begin than to stop half-way, with the
    // axis switched off.
    AXISCOMP_TRY(const int operations, costOfUndo());
    AXISCOMP_TRY(auto history, m_store.flashHistory(m_write.plan.drive.serialNumber));
    AXISCOMP_CHECK(
        checkFlashBudget(wearGuard(m_access.profile().flashWear, history), m_clock(), operations));
    AXISCOMP_TRY(auto status, inspectBeforeRecovery(unfinished));

    // Half of the way back is no better than half of the way there: it cannot be stopped.
    const RegisterAccess access = m_access.withoutStop();
    access.report("putting back", 0.3);
    auto undone = undo(access);
    accountForUndo(access, undone);
    if (!undone && !hasOldState(access))
        return fail(undone.error());
    AXISCOMP_TRY(auto now, confirmOldState(access));
    WritePlan& plan = m_write.plan;
    plan.before = status.setup;
    plan.after = now.setup;
    plan.flashOperations = m_flash.recorded();
    AXISCOMP_CHECK(m_store.closeJournal(plan.drive.serialNumber, plan.axis));
    access.report("done", 1.0);
    return WriteReport{plan, std::move(now), m_backupFile};
}

/// Flash operations, at most: what somebody else has put into the slot meanwhile stays.
Result<int> WriteProcedure::costOfUndo()
{
    int operations = m_flashTouched ? 1 : 0;
    if (m_savedTouched) {
        AXISCOMP_TRY(auto cost, costOfSaving(m_access, m_store, m_write.plan.drive));
        operations += cost;
    }
    // Then the axis has its volatile table again, which is saved as well.
    const std::string& slot = m_write.plan.before.slot;
    const AxisBackup::File* old = backupOf(slot);
    AXISCOMP_TRY(auto saved, m_store.savedState(m_write.plan.drive.serialNumber));
    if (m_savedTouched && !overwritesOwn() && old && !old->persistent && saved.isCovered(slot))
        ++operations;
    return operations;
}

/// Keeps what there is now, and looks who uses the slots: what somebody else has put there
/// meanwhile stays.
Result<AxisStatus> WriteProcedure::inspectBeforeRecovery(const UnfinishedWrite& unfinished)
{
    const WritePlan& plan = m_write.plan;
    const std::vector<std::string> slots = touchedSlots();
    AXISCOMP_TRY(auto present, keepPresent(slots));
    AXISCOMP_TRY(
        auto reading, readStatusWith(m_access, plan.drive, plan.axis, m_sources, lastLookPaths()));
    if (reading.status.isOn())
        return fail(compensationActive(reading.status));
    noteEraseCounts(reading.readings);
    for (const std::string& slot : slots) {
        const SlotState state = slotState(m_access, plan.drive, plan.axis, slot, reading.readings);
        const bool isOld = slot == plan.before.slot;
        if (isOld && !state.otherUser.isEmpty())
            return fail(ErrorCode::SlotInUse, {{"slot", slot}, {"user", state.otherUser}});
        // It was empty: what has come into it since is not this axis's, which had no table.
        if (isOld && !overwritesOwn() && !state.isEmpty() && bytesOf(m_backup, slot).empty())
            m_backup.registers.front().value = m_access.enums().tableDisabled;
        const bool isTheirs = !state.otherUser.isEmpty() || !unfinished.isKnown(state, slot);
        if (!isOld && (isTheirs || bytesOf(present, slot) == bytesOf(m_backup, slot)))
            m_slotTouched = false;
    }
    return std::move(reading.status);
}

/// The slots' tables, and that of the axis where a reboot has given it another one.
Result<AxisBackup> WriteProcedure::keepPresent(std::vector<std::string> slots)
{
    m_access.report("backup", 0.05);
    AxisBackup present{m_write.plan.drive, m_write.plan.axis, {}, m_clock(), {}, {}};
    AXISCOMP_TRY(auto registers, readAxisRegisters(m_access, present.axis));
    present.registers = std::move(registers);
    AXISCOMP_CHECK(describeAxis(m_access, m_sources, present));
    const std::string used = toText(present.registers.front().value);
    if (std::ranges::find(slots, used) == slots.end())
        slots.push_back(used);
    for (const std::string& name : slots) {
        const TableSlot* slot = m_access.profile().slotNamed(name);
        if (!slot)
            continue;
        AXISCOMP_TRY(auto file, readSlotFile(m_access, *slot));
        present.files.push_back(std::move(file));
    }
    AXISCOMP_TRY(auto saved, m_store.saveBackup(present));
    m_backupFile = std::move(saved);
    return present;
}

} // namespace axiscomp
