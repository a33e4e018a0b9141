// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/axis_reader.h"
#include "core/axis/verified_transfer.h"
#include "core/table/tam_table.h"
#include "core/write/backup_restore.h"
#include "core/write/slot_file.h"
#include "core/write/unfinished_write.h"
#include "core/write/write_planner.h"
#include "core/write/write_procedure.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// There is nothing to be asked or to be put back there.
bool isOutOfReach(ErrorCode code)
{
    return isUnreachable(code) || code == ErrorCode::OtherDrive;
}

} // namespace

const AxisBackup::File* WriteProcedure::backupOf(const std::string& slot) const
{
    const auto file = std::ranges::find(m_backup.files, slot, &AxisBackup::File::slot);
    return file == m_backup.files.end() ? nullptr : &*file;
}

Error WriteProcedure::outcome(ErrorCode code, const Error& reason, Text rollback) const
{
    Error error{code,
        {{"reason", textOf(reason)}, {"rollback", std::move(rollback)},
            {"backup", m_backupFile.string()}},
        std::string(errorName(reason.code)) + ": " + reason.detail};
    if (code == ErrorCode::RollbackFailed)
        error.context.set("unfinished", Verbatim{"yes"});
    return error;
}

/// Undoes what was changed and gives the error to report. The journal stays open unless the old
/// state is known to be back.
Error WriteProcedure::rollBack(const Error& reason)
{
    const RegisterAccess access = m_access.withoutStop();
    access.report("putting back", 0.95);
    auto undone = undo(access);
    accountForUndo(access, undone);
    if (!undone && undone.error().code == ErrorCode::OtherDrive)
        return otherDrive(reason, undone.error());
    const bool isGone = !undone && isUnreachable(undone.error().code) && !mayBeHalfWay();
    if (isGone || (!undone && !hasOldState(access)))
        return notUndone(access, reason, undone.error());
    if (const auto undoable = checkUndoable(); !undoable)
        return outcome(ErrorCode::RollbackFailed, reason, textOf(undoable.error()));
    (void)closeJournal();
    return reason;
}

/// What is said then is what `status` says of the drive right after.
Error WriteProcedure::notUndone(
    const RegisterAccess& access, const Error& reason, const Error& obstacle) const
{
    using Outcome = UnfinishedOutcome;
    const auto held =
        isUnreachable(obstacle.code) ? Result<Outcome>(fail(obstacle)) : heldState(access);
    // As long as the axis was not touched it has its old state, whatever the other slot holds: a
    // refusal says as little against that as silence.
    if (!held && !m_registersTouched)
        return reason;
    const bool isNew = held && (*held == Outcome::New || *held == Outcome::NewUnsaved);
    if (isNew || (!held && !mayBeHalfWay()))
        return outcome(ErrorCode::OutcomeUnknown, reason, {});
    return outcome(ErrorCode::RollbackFailed, reason, textOf(obstacle));
}

/// Errors: of the link, when the drive cannot be asked.
Result<UnfinishedOutcome> WriteProcedure::heldState(const RegisterAccess& access) const
{
    AXISCOMP_CHECK(access.checkDrive());
    return unfinishedOutcome(access, m_store, m_write.plan.drive, m_journal, m_sources);
}

/// By the journal, which goes back to before the first write when this one finishes another.
Result<void> WriteProcedure::checkUndoable() const
{
    if (!m_savedTouched || !deletesUnused())
        return {};
    AXISCOMP_TRY(const auto begun, UnfinishedWrite::load(m_access, m_journal));
    return begun.checkUndoable();
}

/// Registers that are written one by one may have left the axis switched off, and a deletion begins
/// with that.
bool WriteProcedure::mayBeHalfWay() const
{
    return m_registersTouched && !m_isComplete
        && (switchesOff() || deletes() || !m_access.profile().writesAtOneInstant);
}

/// Another drive has the address by now: nothing is put back there, and the journal stays open for
/// the drive that was written.
Error WriteProcedure::otherDrive(const Error& reason, const Error& other) const
{
    return mayBeHalfWay() ? outcome(ErrorCode::RollbackFailed, reason, textOf(other))
                          : outcome(ErrorCode::OutcomeUnknown, other, {});
}

void WriteProcedure::accountForUndo(const RegisterAccess& access, const Result<void>& undone)
{
    if (!undone)
        m_flash.noteRefusal(undone.error());
    const bool mayAsk = undone || !isOutOfReach(undone.error().code);
    if (!mayAsk || (!m_slotTouched && !m_flashTouched))
        return;
    if (auto after = readEraseCounts(access, touchedSlots()))
        m_flash.record(m_eraseCounts, *after, 0);
}

/// Brings the drive back to the backup, whatever it holds now: it may have restarted in between and
/// have lost what this write never touched, or what was put back a moment ago. Half-way the axis
/// may be switched off: what went wrong once is tried again.
Result<void> WriteProcedure::undo(const RegisterAccess& access)
{
    const auto attempt = [&]() -> Result<void> {
        AXISCOMP_CHECK(access.checkDrive());
        AXISCOMP_CHECK(putBack(access));
        AXISCOMP_CHECK(confirmOldState(access));
        return {};
    };
    auto undone = attempt();
    if (!undone && !isOutOfReach(undone.error().code))
        undone = attempt();
    return undone;
}

/// Every step was read back, but only all of it together is the old state.
Result<AxisStatus> WriteProcedure::confirmOldState(const RegisterAccess& access) const
{
    const WritePlan& plan = m_write.plan;
    AXISCOMP_CHECK(compareRegisters(access, m_backup.registers));
    AXISCOMP_TRY(auto now, readStatus(access, plan.drive, plan.axis, m_sources));
    const AxisBackup::File* old = backupOf(plan.before.slot);
    if (!old || old->bytes.empty() || isShownTable(access.profile(), now.table, old->bytes))
        return now;
    return fail(ErrorCode::VerifyMismatch,
        {{"what", AXISCOMP_TEXT("Error", "the table in {slot}").with("slot", old->slot)},
            {"found", setupText(now.setup)}, {"expected", setupText(plan.before)}});
}

Result<void> WriteProcedure::putBack(const RegisterAccess& access)
{
    m_isComplete = false;
    if (overwritesOwn() && m_slotTouched) {
        // While its file is put back the axis must not be able to start, not even after a reboot.
        const std::string table = access.axisPath(access.registers().table, m_write.plan.axis);
        if (auto off = writeVerified(access, {{table, access.enums().tableDisabled}}); !off)
            return off;
        if (m_savedTouched)
            if (auto saved = save(access); !saved)
                return saved;
    }
    if (auto restored = rollBackTable(access); !restored)
        return restored;
    if (auto restored = undoRegisters(access); !restored)
        return restored;
    return undoOtherSlot(access);
}

Result<void> WriteProcedure::rollBackTable(const RegisterAccess& access)
{
    const AxisBackup::File* old = backupOf(m_write.plan.before.slot);
    if (!old || old->bytes.empty())
        return overwritesOwn() && m_slotTouched ? deleteTable(access, m_write.slot.name)
                                                : Result<void>{};
    TableSlot slot;
    slot.name = old->slot;
    slot.file = old->path;
    // A file that the registers do not show may be one that somebody on the way has kept.
    const auto there = readSlotFile(access, slot);
    if (!there && there.error().code != ErrorCode::ChangedMeanwhile
        && there.error().code != ErrorCode::InvalidTable)
        return fail(there.error());
    // Persistency alone is put back with the registers.
    if (there && sameTable(there->bytes, old->bytes, access.profile().layout))
        return {};
    return uploadVerified(access, old->path, old->bytes);
}

Result<void> WriteProcedure::undoRegisters(const RegisterAccess& access)
{
    std::vector<RegisterWrite> values = m_backup.registers;
    std::vector<RegisterWrite> commands;
    const AxisBackup::File* old = backupOf(m_write.plan.before.slot);
    if (m_flashTouched && old && !old->bytes.empty() && (!isNewTable() || overwritesOwn())) {
        values.push_back(
            {access.slotPath(access.registers().tablePersistent, old->slot), old->persistent});
        commands.push_back({access.slotPath(access.registers().tableCommand, old->slot),
            access.enums().tableCommandCommit});
    }
    auto unchanged = compareRegisters(access, values);
    if (!unchanged && unchanged.error().code != ErrorCode::VerifyMismatch)
        return unchanged;
    if (!unchanged) {
        std::vector<RegisterWrite> last;
        if (!access.profile().writesAtOneInstant) {
            if (auto off = writeVerified(access, {{values[0].path, access.enums().tableDisabled}});
                !off)
                return off;
            last = {values[0]};
            values.erase(values.begin());
        }
        if (auto written = writeVerified(access, values, commands); !written)
            return written;
        if (auto written = last.empty() ? Result<void>() : writeVerified(access, last); !written)
            return written;
        values.insert(values.begin(), last.begin(), last.end());
        if (auto same = compareRegisters(access, values); !same)
            return same;
    }
    // Otherwise what would be saved is not what a reboot would have brought back.
    return m_savedTouched && checkUndoable() ? save(access) : Result<void>{};
}

/// Taking the new table out of the flash of its slot costs an operation. The axis has its old state
/// without that: when none is left, the table stays where it is.
bool WriteProcedure::mustStay(const RegisterAccess& access) const
{
    if (!m_flashTouched || m_flash.recorded() == 0)
        return false;
    const auto history = m_store.flashHistory(m_write.plan.drive.serialNumber);
    return history && wearGuard(access.profile().flashWear, *history).budget(m_clock()).left == 0;
}

Result<void> WriteProcedure::undoOtherSlot(const RegisterAccess& access)
{
    if (!m_slotTouched || overwritesOwn() || mustStay(access))
        return {};
    const AxisBackup::File* old = backupOf(m_write.slot.name);
    if (!old || old->bytes.empty())
        return deleteTable(access, m_write.slot.name);
    if (m_flashTouched && !old->persistent)
        (void)m_store.recordCovered(m_write.plan.drive.serialNumber, m_write.slot.name, true);
    return uploadVerified(access, old->path, old->bytes);
}

/// The last resort when undoing failed somewhere: does the axis have its old state all the same, by
/// what its registers show and by the file?
bool WriteProcedure::hasOldState(const RegisterAccess& access)
{
    if (!access.checkDrive() || !confirmOldState(access))
        return false;
    const AxisBackup::File* old = backupOf(m_write.plan.before.slot);
    if (!old || old->bytes.empty())
        return !overwritesOwn() || !m_slotTouched
            || checkEmpty(access, m_write.slot.name).has_value();
    auto bytes = access.link().download(old->path, access.exchange());
    return bytes && compareFiles(old->path, *bytes, old->bytes).has_value();
}

} // namespace axiscomp
