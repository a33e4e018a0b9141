// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/write_procedure.h"

#include "core/axis/shown_grid.h"
#include "core/axis/verified_transfer.h"
#include "core/table/tam_table.h"
#include "core/write/parameter_saving.h"
#include "core/write/restored_axis.h"
#include "core/write/slot_file.h"
#include "core/write/unfinished_write.h"

#include <algorithm>

namespace axiscomp {

WriteProcedure::WriteProcedure(const RegisterAccess& access, DriveStore& store,
    SourceDirectory& sources, std::function<WallTime()> clock, PreparedWrite prepared,
    std::optional<JournalEntry> earlier)
    : m_access(access.expecting(prepared.plan.drive))
    , m_store(store)
    , m_sources(sources)
    , m_clock(std::move(clock))
    , m_write(std::move(prepared))
    , m_earlier(std::move(earlier))
    , m_flash(store, m_write.plan.drive.serialNumber, m_clock)
{
}

bool WriteProcedure::overwritesOwn() const
{
    return isNewTable() && m_write.slot.name == m_write.plan.before.slot;
}

/// The axis has no table for a time: the one that it uses is replaced, in its slot or in the flash
/// of its slot.
bool WriteProcedure::switchesOff() const
{
    return overwritesOwn()
        || (m_write.releases && m_write.plan.after.slot == m_write.plan.before.slot);
}

bool WriteProcedure::wantsPersistent() const
{
    return m_write.plan.after.persistency == Persistency::Persistent;
}

bool WriteProcedure::changesPersistency() const
{
    return m_write.plan.flashOperations > m_write.uncovered;
}

/// The axis keeps its table, in flash or not in flash from then on.
bool WriteProcedure::commitsOnSwitch() const
{
    return !isNewTable() && !deletes() && changesPersistency();
}

std::vector<std::string> WriteProcedure::touchedSlots() const
{
    std::vector<std::string> slots;
    const WritePlan& plan = m_write.plan;
    for (const std::string& slot : {plan.before.slot, plan.after.slot, plan.deletedSlot}) {
        if (!slot.empty() && std::ranges::find(slots, slot) == slots.end())
            slots.push_back(slot);
    }
    return slots;
}

Result<WriteReport> WriteProcedure::finishEarlier()
{
    m_finishesEarlier = m_earlier.has_value();
    return run();
}

Result<WriteReport> WriteProcedure::run()
{
    AXISCOMP_CHECK(keepOldState());
    AXISCOMP_CHECK(checkUnchanged());
    if (auto changed = change(); !changed)
        return fail(rollBack(changed.error()));
    auto now = confirm();
    m_isComplete = now || now.error().code != ErrorCode::VerifyMismatch;
    if (!now && isUnreachable(now.error().code))
        return fail(outcome(ErrorCode::OutcomeUnknown, now.error(), {}));
    if (!now)
        return fail(rollBack(now.error()));
    return finish(std::move(*now));
}

Result<void> WriteProcedure::keepOldState()
{
    m_access.report("backup", 0.05);
    const WritePlan& plan = m_write.plan;
    AXISCOMP_TRY(auto registers, readAxisRegisters(m_access, plan.axis));
    m_backup.drive = plan.drive;
    m_backup.axis = plan.axis;
    m_backup.time = m_clock();
    m_backup.registers = std::move(registers);
    AXISCOMP_CHECK(describeAxis(m_access, m_sources, m_backup));

    std::vector<const TableSlot*> slots{m_access.profile().slotNamed(plan.before.slot)};
    if ((isNewTable() || deletes()) && m_write.slot.name != plan.before.slot)
        slots.push_back(&m_write.slot);
    for (const TableSlot* slot : slots) {
        if (!slot)
            continue;
        AXISCOMP_TRY(auto file, readSlotFile(m_access, *slot));
        m_backup.files.push_back(std::move(file));
    }
    // A table that is deleted and that the axis does not use comes back as one that no axis uses.
    std::vector<AxisBackup::File> others;
    if (const AxisBackup::File* file = backupOf(plan.deletedSlot);
        file && file->slot != plan.before.slot && !file->bytes.empty())
        others.push_back(*file);
    AXISCOMP_TRY(auto saved, m_store.saveBackup(m_backup, others));
    m_backupFile = saved;

    m_journal.serialNumber = plan.drive.serialNumber;
    m_journal.axis = plan.axis;
    m_journal.time = m_backup.time;
    m_journal.backup = m_finishesEarlier ? m_earlier->backup : m_backupFile;
    m_journal.newRegisters = axisRegisters(m_access, plan.axis, plan.after);
    m_journal.newSlot = plan.after.slot;
    m_journal.newCrc = m_write.elementCrc;
    m_journal.persistent = deletes() ? m_write.saves : wantsPersistent();
    m_journal.deletedSlot = plan.deletedSlot;
    m_journal.newUnits = plan.units;
    m_journal.newSourcePaths.clear();
    for (const DimSource& source : plan.after.sources)
        m_journal.newSourcePaths.push_back(source.path);
    if (m_finishesEarlier) { // what that one has done already has to be undone too
        m_journal.time = m_earlier->time;
        m_journal.step = m_earlier->step;
        m_journal.newTable = m_earlier->newTable;
    }
    return {};
}

/// Announces a step that changes the drive, to the user and, before it begins, in the journal.
Result<void> WriteProcedure::note(const std::string& step, double progress)
{
    if (auto stopped = m_access.checkStop(); !stopped)
        return stopped;
    m_access.report(step, progress);
    if (!m_finishesEarlier || stepRank(step) > stepRank(m_journal.step))
        m_journal.step = step;
    if (isNewTable() && !m_journal.newTable) {
        AXISCOMP_TRY(
            auto kept, m_store.keepTable(m_journal.serialNumber, m_journal.axis, m_write.file));
        m_journal.newTable = std::move(kept);
    }
    return m_store.openJournal(m_journal);
}

/// The drive has the state from before this write: what was unfinished then is so again.
Result<void> WriteProcedure::closeJournal()
{
    return m_earlier ? m_store.openJournal(*m_earlier)
                     : m_store.closeJournal(m_backup.drive.serialNumber, m_backup.axis);
}

Result<void> WriteProcedure::change()
{
    if (deletes())
        return deleteOldTable();
    if (switchesOff() || m_write.releases) {
        if (auto released = switchesOff() ? switchOff() : release(); !released)
            return released;
    }
    if (isNewTable()) {
        if (auto uploaded = uploadTable(); !uploaded)
            return uploaded;
        if (wantsPersistent()) {
            if (auto committed = commitTable(); !committed)
                return committed;
        }
    }
    if (auto switched = switchOver(); !switched)
        return switched;
    if (!wantsPersistent())
        return {};
    if (auto noted = note("save", 0.95); !noted)
        return noted;
    m_savedTouched = true;
    return save(m_access);
}

Result<void> WriteProcedure::save(const RegisterAccess& access)
{
    return saveParameters(access, m_store, m_write.plan.drive, m_flash, m_eraseCounts);
}

/// Saved parameters name the slot with another table than it will have: they are replaced by what
/// the axes have now, before the new table reaches flash.
Result<void> WriteProcedure::release()
{
    if (auto noted = note("release", 0.12); !noted)
        return noted;
    return save(m_access);
}

/// An axis whose table is being replaced in place must not be able to start with half of it; nor
/// after a reboot, with the new table from flash and the old sources.
Result<void> WriteProcedure::switchOff()
{
    if (auto noted = note("switch off", 0.12); !noted)
        return noted;
    m_registersTouched = true;
    const std::vector<RegisterWrite> off{
        {m_access.axisPath(m_access.registers().table, m_write.plan.axis),
            m_access.enums().tableDisabled}};
    if (auto written = writeVerified(m_access, off); !written)
        return written;
    if (auto same = compareRegisters(m_access, off); !same)
        return same;
    if (!wantsPersistent())
        return {};
    m_savedTouched = true;
    return save(m_access);
}

/// Uploads and reads back, byte by byte; the two halves share the progress.
Result<void> WriteProcedure::uploadTable()
{
    if (auto noted = note("upload", 0.15); !noted)
        return noted;
    // Whatever happens to this write, a later one may take the slot again.
    if (auto recorded = m_store.recordOwnTable(m_write.plan.drive.serialNumber, m_write.plan.axis,
            {m_write.slot.name, m_write.elementCrc});
        !recorded)
        return recorded;
    const AxisBackup::File* there = backupOf(m_write.slot.name);
    if (there && sameTable(there->bytes, m_write.file, m_access.profile().layout)
        && (wantsPersistent() || !there->persistent))
        return {};
    m_slotTouched = true;
    if (there && there->persistent) {
        if (auto noted =
                m_store.recordCovered(m_write.plan.drive.serialNumber, m_write.slot.name, true);
            !noted)
            return noted;
    }
    return uploadVerified(
        m_access, m_write.slot.file, m_write.file, [this](std::string_view step, double fraction) {
            m_access.report(step, 0.15 + 0.7 * fraction);
        });
}

std::vector<RegisterWrite> WriteProcedure::persistencyWrites() const
{
    return {{m_access.slotPath(m_access.registers().tablePersistent, m_write.plan.after.slot),
        wantsPersistent()}};
}

/// The new table reaches flash while the axis still uses the old one: whenever the program is
/// interrupted, the axis has one of the two completely.
Result<void> WriteProcedure::commitTable()
{
    if (auto noted = note("commit", 0.86); !noted)
        return noted;
    return commitWith(persistencyWrites());
}

/// Writes values and the commit of the slot in one request, and keeps account of it.
Result<void> WriteProcedure::commitWith(const std::vector<RegisterWrite>& values)
{
    m_flashTouched = true;
    bool isCommitted = false;
    auto reached = reachFlash(values, isCommitted);
    if (!reached) {
        m_flash.noteRefusal(reached.error());
        if (!isCommitted && !mayHaveSpentFlash(reached.error()))
            return reached;
    }
    auto spent = recordSpent(m_write.plan.flashOperations, reached);
    if (reached && !spent)
        return spent;
    if (reached) // what flash holds there is what the drive uses, or nothing
        (void)m_store.recordCovered(
            m_write.plan.drive.serialNumber, m_write.plan.after.slot, false);
    return reached;
}

/// What the slots' counts say now; assumed: where they do not say it. outcome: of what has spent
/// it; the counts of another drive would say nothing about this one.
Result<void> WriteProcedure::recordSpent(int assumed, const Result<void>& outcome)
{
    const bool isOther = !outcome && outcome.error().code == ErrorCode::OtherDrive;
    auto after = isOther ? Result<EraseCounts>(fail(outcome.error()))
                         : readEraseCounts(m_access, touchedSlots());
    // What cannot be asked has been spent, as far as anybody knows.
    m_flash.record(
        m_eraseCounts, after.value_or(EraseCounts{}), after ? assumed : std::min(assumed, 1));
    if (!after)
        return fail(after.error());
    m_eraseCounts = std::move(*after);
    return {};
}

/// A commit that did nothing is repeated, which costs nothing when flash already holds the table. A
/// table that the drive then still counts no cycle for is not said to be in flash. isCommitted: the
/// drive has said yes once, whatever happened after that.
Result<void> WriteProcedure::reachFlash(const std::vector<RegisterWrite>& values, bool& isCommitted)
{
    const std::string& slot = m_write.plan.after.slot;
    const std::vector<RegisterWrite> commit{
        {m_access.slotPath(m_access.registers().tableCommand, slot),
            m_access.enums().tableCommandCommit}};
    if (auto committed = writeVerified(m_access, values, commit); !committed)
        return committed;
    isCommitted = true;
    if (auto same = compareRegisters(m_access, values); !same)
        return same;
    AXISCOMP_TRY(auto after, readEraseCounts(m_access, {slot}));
    const auto before = m_eraseCounts.find(slot);
    if (before == m_eraseCounts.end() || after[slot] != before->second)
        return {};
    AXISCOMP_CHECK(m_access.checkDrive());
    AXISCOMP_CHECK(writeVerified(m_access, {}, commit));
    AXISCOMP_TRY(after, readEraseCounts(m_access, {slot}));
    if (after[slot] != before->second || !mustSpendFlash())
        return {};
    return fail(ErrorCode::VerifyMismatch, {{"cycles", before->second}, {"slot", slot}});
}

/// Whether the table that is made persistent cannot be in flash yet, as far as anybody here knows:
/// under a volatile table flash may hold the same one already, also after a write that did not end.
bool WriteProcedure::mustSpendFlash() const
{
    if (m_earlier || !wantsPersistent() || !changesPersistency())
        return false;
    const std::string& slot = m_write.plan.after.slot;
    const AxisBackup::File* there = backupOf(slot);
    if (there && there->persistent)
        return true; // flash has that one
    const auto saved = m_store.savedState(m_write.plan.drive.serialNumber);
    return saved && !saved->isCovered(slot);
}

Result<void> WriteProcedure::switchOver()
{
    if (auto noted = note("switch", 0.9); !noted)
        return noted;
    const WritePlan& plan = m_write.plan;
    std::vector<RegisterWrite> values = axisRegisters(m_access, plan.axis, plan.after);
    m_registersTouched = true;
    if (!m_access.profile().writesAtOneInstant)
        return switchOverOneByOne(values);
    if (commitsOnSwitch()) {
        const auto persistency = persistencyWrites();
        values.insert(values.end(), persistency.begin(), persistency.end());
        return commitWith(values);
    }
    if (auto switched = writeVerified(m_access, values); !switched)
        return switched;
    return compareRegisters(m_access, values);
}

/// Table is Disabled first and has its slot last: an interruption leaves an axis that cannot be
/// activated instead of a mixture.
Result<void> WriteProcedure::switchOverOneByOne(const std::vector<RegisterWrite>& values)
{
    const std::vector<RegisterWrite> off{{values[0].path, m_access.enums().tableDisabled}};
    if (auto written = writeVerified(m_access, off); !written)
        return written;
    if (auto same = compareRegisters(m_access, off); !same)
        return same;
    if (auto written = writeVerified(m_access, {values.begin() + 1, values.end()}); !written)
        return written;
    if (commitsOnSwitch()) {
        if (auto committed = commitWith(persistencyWrites()); !committed)
            return committed;
    }
    if (auto written = writeVerified(m_access, {values[0]}); !written)
        return written;
    return compareRegisters(m_access, values);
}

/// Every step was read back, but a drive that restarted between two steps has forgotten the first:
/// only all of it together is success. From here on the user cannot stop any more.
Result<AxisStatus> WriteProcedure::confirm()
{
    const WritePlan& plan = m_write.plan;
    const RegisterAccess access = m_access.withoutStop();
    // The state comes last: a drive that restarts after it was asked who it is must not pass.
    const auto readState = [&]() -> Result<AxisStatus> {
        AXISCOMP_CHECK(access.checkDrive());
        return readStatus(access, plan.drive, plan.axis, m_sources);
    };
    auto now = readState();
    if (!now && isUnreachable(now.error().code))
        now = readState();
    if (now && !(now->setup == plan.after))
        return fail(ErrorCode::VerifyMismatch,
            {{"what", axisText(plan.axis, now->axis.name)}, {"found", setupText(now->setup)},
                {"expected", setupText(plan.after)}});
    if (now && now->table && plan.table && isNewTable())
        AXISCOMP_CHECK(checkShownGrid(
            ErrorCode::VerifyMismatch, plan.after.slot, now->table->grid, plan.table->grid));
    if (!now || !deletes())
        return now;
    auto empty = checkEmpty(access, plan.deletedSlot);
    if (!empty && isUnreachable(empty.error().code))
        empty = checkEmpty(access, plan.deletedSlot);
    if (!empty)
        return fail(empty.error());
    return now;
}

Result<WriteReport> WriteProcedure::finish(AxisStatus now)
{
    const WritePlan& plan = m_write.plan;
    // The next write may take the slot of the old table.
    if (!deletes() && !plan.before.slot.empty() && plan.before.slot != plan.after.slot)
        (void)m_store.recordOwnTable(
            plan.drive.serialNumber, plan.axis, {plan.before.slot, plan.before.tableCrc});
    AXISCOMP_CHECK(m_store.closeJournal(plan.drive.serialNumber, plan.axis));
    m_access.report("done", 1.0);
    return WriteReport{plan, std::move(now), m_backupFile};
}

} // namespace axiscomp
