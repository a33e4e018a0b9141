// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of a write that did not end.
#include "core/compensator/axis_compensator_p.h"
#include "core/write/backup_restore.h"
#include "core/write/unfinished_write.h"
#include "core/write/write_procedure.h"

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
    auto now = store.journal(entry.serialNumber, entry.axis);
    if (!now)
        return fail(now.error());
    if (!*now)
        return fail(ErrorCode::NothingUnfinished, {{"axis", entry.axis}});
    if (**now == entry)
        return {};
    return fail(ErrorCode::ChangedMeanwhile,
        {{"what",
             AXISCOMP_TEXT("Error", "the unfinished write to axis {axis}")
                 .with("axis", entry.axis)},
            {"before", journalText(entry)}, {"now", journalText(**now)}});
}

} // namespace

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
    return drive;
}

Result<AxisCompensator::Private::ResumedWrite> AxisCompensator::Private::resume(
    const RegisterAccess& access, const JournalEntry& entry)
{
    auto drive = identify(access, entry);
    if (!drive)
        return fail(drive.error());
    auto lock = store.lockWrites(drive->serialNumber);
    if (!lock)
        return fail(lock.error());
    if (auto same = checkJournal(store, entry); !same)
        return fail(same.error());
    auto unfinished = UnfinishedWrite::load(access, entry);
    if (!unfinished)
        return fail(unfinished.error());
    return ResumedWrite{std::move(*drive), std::move(*lock), std::move(*unfinished)};
}

Result<AxisCompensator::UnfinishedOutcome> AxisCompensator::settleUnfinished(
    const JournalEntry& entry, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    auto drive = d->identify(access, entry);
    if (!drive)
        return fail(drive.error());
    auto outcome = unfinishedOutcome(access, *drive, entry, d->sources);
    if (outcome && *outcome == UnfinishedOutcome::New) {
        if (auto closed = d->store.closeJournal(entry.serialNumber, entry.axis); !closed)
            return fail(closed.error());
    }
    return outcome;
}

Result<AxisCompensator::Recovery> AxisCompensator::recovery(
    const JournalEntry& entry, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    auto drive = d->identify(access, entry);
    if (!drive)
        return fail(drive.error());
    auto status = readStatus(access, *drive, entry.axis, d->sources);
    if (!status)
        return fail(status.error());

    Recovery recovery;
    auto unfinished = UnfinishedWrite::load(access, entry);
    if (!unfinished) {
        recovery.finishObstacle = recovery.undoObstacle = unfinished.error();
        return recovery;
    }
    if (status->isOn())
        recovery.undoObstacle = compensationActive(*status);
    auto prepared = d->prepareFinish(access, *drive, *unfinished);
    if (!prepared && isUnreachable(prepared.error().code))
        return fail(prepared.error());
    if (prepared)
        recovery.flashOperations = prepared->plan.flashOperations;
    else
        recovery.finishObstacle = prepared.error();
    return recovery;
}

Result<PreparedWrite> AxisCompensator::Private::prepareFinish(
    const RegisterAccess& access, const DriveIdentity& drive, const UnfinishedWrite& unfinished)
{
    auto request = unfinished.request(store, drive);
    if (!request)
        return fail(request.error());
    return WritePlanner(access, store, sources, drive, clock())
        .prepare(unfinished.entry().axis, *request);
}

Result<WriteReport> AxisCompensator::finishUnfinished(
    const JournalEntry& entry, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    access.report("plan", 0.0);
    auto taken = d->resume(access, entry);
    if (!taken)
        return fail(taken.error());
    auto prepared = d->prepareFinish(access, taken->drive, taken->unfinished);
    if (!prepared)
        return fail(prepared.error());
    auto report =
        WriteProcedure(access, d->store, d->sources, d->clock, std::move(*prepared), entry)
            .finishEarlier();
    // As after a write that was not interrupted: the next one may take the old table's slot.
    const UnfinishedWrite& unfinished = taken->unfinished;
    if (report && unfinished.oldFile() && unfinished.oldSlot() != report->now.setup.slot)
        (void)d->store.recordOwnTable(
            entry.serialNumber, entry.axis, {unfinished.oldSlot(), unfinished.oldCrc()});
    return report;
}

Result<WriteReport> AxisCompensator::undoUnfinished(
    const JournalEntry& entry, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    access.report("plan", 0.0);
    auto taken = d->resume(access, entry);
    if (!taken)
        return fail(taken.error());
    return WriteProcedure(
        access, d->store, d->sources, d->clock, taken->unfinished.prepared(taken->drive), entry)
        .recoverOldState(taken->unfinished);
}

} // namespace axiscomp
