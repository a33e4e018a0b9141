// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of a write that did not end.
#include "core/compensator/axis_compensator_p.h"
#include "core/write/backup_restore.h"
#include "core/write/restored_axis.h"
#include "core/write/unfinished_write.h"
#include "core/write/write_procedure.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace axiscomp {

namespace {

Text journalText(const JournalEntry& entry)
{
    return AXISCOMP_TEXT("Error", "{time} ({step})")
        .with("time", utcText(entry.time))
        .with("step", entry.step);
}

/// Another program may have finished it, or begun the next one.
Result<void> checkJournal(DriveStore& store, const JournalEntry& entry)
{
    AXISCOMP_TRY(auto now, store.journal(entry.serialNumber, entry.axis));
    if (!now)
        return fail(ErrorCode::NothingUnfinished, {{"axis", entry.axis}});
    if (*now == entry)
        return {};
    return fail(ErrorCode::ChangedMeanwhile,
        {{"what",
             AXISCOMP_TEXT("Error", "the unfinished write to axis {axis}")
                 .with("axis", entry.axis)},
            {"before", journalText(entry)}, {"now", journalText(*now)}});
}

/// Two drives may have one serial number, as those of a copied configuration or two virtual ones
/// do. One's write is not finished on the other.
Result<void> checkTwin(
    const RegisterAccess& access, const JournalEntry& entry, const DriveIdentity& drive)
{
    const auto unfinished = UnfinishedWrite::load(access, entry);
    if (!unfinished || unfinished->before().drive == drive)
        return {}; // what cannot be read is said by who needs it
    const auto text = [](const DriveIdentity& identity) {
        return AXISCOMP_TEXT("Error", "{number} ({name}, axes: {axes})")
            .with("number", identity.serialNumber)
            .with("name", identity.name)
            .with("axes", identity.axes);
    };
    return fail(ErrorCode::OtherDrive,
        {{"expected", text(unfinished->before().drive)}, {"found", text(drive)}});
}

} // namespace

struct AxisCompensator::Private::PreparedFinish {
    PreparedWrite write;
    std::vector<Text> doubts; ///< of RestoredAxis; among the warnings of the plan, too
};

struct AxisCompensator::Private::ResumedWrite {
    DriveIdentity drive;
    FileLock lock;
    UnfinishedWrite unfinished;
};

Result<DriveIdentity> AxisCompensator::Private::identify(
    const RegisterAccess& access, const JournalEntry& entry)
{
    auto drive = identify(access, entry.axis);
    if (drive && drive->serialNumber != entry.serialNumber)
        return fail(ErrorCode::OtherDrive,
            {{"expected", entry.serialNumber}, {"found", drive->serialNumber}});
    if (drive)
        AXISCOMP_CHECK(checkTwin(access, entry, *drive));
    return drive;
}

Result<AxisCompensator::Private::ResumedWrite> AxisCompensator::Private::resume(
    const RegisterAccess& access, const JournalEntry& entry)
{
    AXISCOMP_TRY(auto drive, identify(access, entry));
    AXISCOMP_TRY(auto lock, store.lockWrites(drive.serialNumber));
    AXISCOMP_CHECK(checkJournal(store, entry));
    AXISCOMP_TRY(auto unfinished, UnfinishedWrite::load(access, entry));
    return ResumedWrite{std::move(drive), std::move(lock), std::move(unfinished)};
}

Result<AxisCompensator::UnfinishedOutcome> AxisCompensator::settleUnfinished(
    const JournalEntry& entry, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, entry));
    auto outcome = unfinishedOutcome(access, d->store, drive, entry, d->sources);
    if (outcome && *outcome == UnfinishedOutcome::New) {
        AXISCOMP_CHECK(d->store.closeJournal(entry.serialNumber, entry.axis));
    }
    return outcome;
}

Result<AxisCompensator::Recovery> AxisCompensator::recovery(
    const JournalEntry& entry, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, entry));
    AXISCOMP_TRY(auto status, readStatus(access, drive, entry.axis, d->sources));

    Recovery recovery;
    auto unfinished = UnfinishedWrite::load(access, entry);
    if (!unfinished) {
        recovery.isBackupUnread = true;
        recovery.finishObstacle = recovery.undoObstacle = unfinished.error();
        return recovery;
    }
    AXISCOMP_TRY(recovery.undoFlashOperations,
        WriteProcedure(access, d->store, d->sources, d->clock, unfinished->prepared(drive), entry)
            .costOfRecovery(*unfinished));
    if (auto fits = d->checkFlash(drive, recovery.undoFlashOperations, 0); !fits)
        recovery.undoObstacle = std::move(fits).error();
    auto axis = checkSameAxis(access, d->sources, unfinished->before(), BroughtBackBy::Recovery);
    if (!axis && isUnreachable(axis.error().code))
        return fail(axis.error());
    if (axis)
        recovery.doubts = std::move(axis->doubts);
    else
        recovery.undoObstacle = axis.error();
    if (status.isOn())
        recovery.undoObstacle = compensationActive(status);
    if (auto undoable = unfinished->checkUndoable(); !undoable)
        recovery.undoObstacle = std::move(undoable).error();
    auto finish = d->prepareFinish(access, drive, *unfinished);
    if (!finish && isUnreachable(finish.error().code))
        return fail(finish.error());
    if (!finish) {
        recovery.finishObstacle = finish.error();
        return recovery;
    }
    recovery.finishFlashOperations = finish->write.plan.flashOperations;
    for (Text& doubt : finish->doubts)
        if (std::ranges::find(recovery.doubts, doubt) == recovery.doubts.end())
            recovery.doubts.push_back(std::move(doubt));
    return recovery;
}

Result<AxisCompensator::Private::PreparedFinish> AxisCompensator::Private::prepareFinish(
    const RegisterAccess& access, const DriveIdentity& drive, const UnfinishedWrite& unfinished)
{
    AXISCOMP_TRY(const auto after, unfinished.after(store));
    AXISCOMP_TRY(auto axis, checkSameAxis(access, sources, after, BroughtBackBy::Recovery));
    AXISCOMP_TRY(auto request, unfinished.request(store, drive));
    request.doubts = axis.doubts;
    request.origin = axis.hasSameName ? TableOrigin::Axis : TableOrigin::Drive;
    AXISCOMP_TRY(auto write,
        WritePlanner(access, store, sources, drive, clock())
            .prepare(unfinished.entry().axis, request));
    return PreparedFinish{std::move(write), std::move(axis.doubts)};
}

Result<WriteReport> AxisCompensator::finishUnfinished(
    const JournalEntry& entry, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    access.report("plan", 0.0);
    AXISCOMP_TRY(auto taken, d->resume(access, entry));
    AXISCOMP_TRY(auto finish, d->prepareFinish(access, taken.drive, taken.unfinished));
    auto report =
        WriteProcedure(access, d->store, d->sources, d->clock, std::move(finish.write), entry)
            .finishEarlier();
    // As after a write that was not interrupted: the next one may take the old table's slot.
    const UnfinishedWrite& unfinished = taken.unfinished;
    if (report && unfinished.entry().deletedSlot.empty() && unfinished.oldFile()
        && unfinished.oldSlot() != report->now.setup.slot)
        (void)d->store.recordOwnTable(
            entry.serialNumber, entry.axis, {unfinished.oldSlot(), unfinished.oldCrc()});
    return report;
}

Result<WriteReport> AxisCompensator::undoUnfinished(
    const JournalEntry& entry, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    access.report("plan", 0.0);
    AXISCOMP_TRY(auto taken, d->resume(access, entry));
    AXISCOMP_CHECK(taken.unfinished.checkUndoable());
    AXISCOMP_TRY(auto axis,
        checkSameAxis(access, d->sources, taken.unfinished.before(), BroughtBackBy::Recovery));
    PreparedWrite prepared = taken.unfinished.prepared(taken.drive);
    prepared.plan.warnings = std::move(axis.doubts);
    return WriteProcedure(access, d->store, d->sources, d->clock, std::move(prepared), entry)
        .recoverOldState(taken.unfinished);
}

} // namespace axiscomp
