// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of a write that did not end.
#include "core/axis_compensator_p.h"
#include "core/backup_restore.h"

namespace axiscomp {

Result<AxisCompensator::UnfinishedOutcome> AxisCompensator::settleUnfinished(
    const JournalEntry& entry, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access, entry.axis);
    if (!drive)
        return fail(drive.error());
    if (drive->serialNumber != entry.serialNumber)
        return fail(ErrorCode::OtherDrive,
            {{"expected", std::to_string(entry.serialNumber)},
                {"found", std::to_string(drive->serialNumber)}});
    auto outcome = unfinishedOutcome(access, *drive, entry, d->sources);
    if (outcome && (*outcome == UnfinishedOutcome::Old || *outcome == UnfinishedOutcome::New)) {
        if (auto closed = d->store.closeJournal(entry.serialNumber, entry.axis); !closed)
            return fail(closed.error());
    }
    return outcome;
}

} // namespace axiscomp
