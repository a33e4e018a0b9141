// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/axis_operations.h"

#include "core/base/error.h"
#include "core/write/kept_backup.h"
#include "core/write/previous_state.h"

#include <algorithm>
#include <system_error>

namespace axiscomp {

namespace {

/// What the drive has afterwards is read even when the user has stopped the operation.
OperationOptions quietly(const OperationOptions& options)
{
    OperationOptions quiet = options;
    quiet.stop = {};
    quiet.progress = {};
    return quiet;
}

Result<SettledWrite> settle(
    AxisCompensator& compensator, const JournalEntry& entry, const OperationOptions& options)
{
    AXISCOMP_TRY(const auto outcome, compensator.settleUnfinished(entry, options));
    SettledWrite settled{entry, outcome, {}};
    if (outcome != AxisCompensator::UnfinishedOutcome::New) {
        AXISCOMP_TRY(settled.recovery, compensator.recovery(entry, options));
    }
    return settled;
}

/// Without its journal the axis can still be looked at and switched off.
Result<void> look(
    AxisCompensator& compensator, int axis, const OperationOptions& options, SettledStatus& now)
{
    AXISCOMP_TRY(auto watched, compensator.watch(axis, {}, options));
    now.status = std::move(watched.status);
    now.settlingProblem = std::move(watched.journalProblem);
    return {};
}

/// why: the argument that tells the sentences apart. Errors: VerifyMismatch.
Result<void> checkNoHalf(const SettledStatus& now, const char* why)
{
    using Outcome = AxisCompensator::UnfinishedOutcome;
    const auto& settled = now.settled;
    const bool isUnread = settled && settled->outcome == Outcome::Unknown;
    if (!settled || (settled->outcome != Outcome::Neither && !isUnread))
        return {};
    return fail(ErrorCode::VerifyMismatch,
        {{"axis", settled->entry.axis}, {"backup", settled->entry.backup.string()},
            {isUnread ? "unread" : why, Verbatim{"yes"}}});
}

bool endsBackup(const Error& error)
{
    return isLinkFailure(error.code) || error.code == ErrorCode::Cancelled;
}

Result<AxisBackup> chosenBackup(const BackupChoice& choice, const DriveProfile& profile)
{
    AXISCOMP_TRY(auto axes, axisBackupsIn(choice.file, profile));
    const auto found = std::ranges::find(axes, choice.axis, &AxisBackup::axis);
    if (found != axes.end())
        return std::move(*found);
    return fail(ErrorCode::InvalidBackup,
        {{"file", Verbatim{choice.file.string()}},
            {"reason",
                AXISCOMP_TEXT("Error", "it has nothing of axis {axis}")
                    .with("axis", choice.axis)}});
}

/// Whether this computer made the file for a write to the drive and axis of the plan.
bool isKept(const DriveStore& store, const WritePlan& plan, const std::filesystem::path& file)
{
    return std::ranges::any_of(
        store.backups(plan.drive.serialNumber, plan.axis), [&](const std::filesystem::path& kept) {
            std::error_code ignored;
            return std::filesystem::equivalent(kept, file, ignored);
        });
}

Result<Restoration> restorePlanned(AxisCompensator& compensator, const PlannedRestoration& planned,
    const OperationOptions& options)
{
    AXISCOMP_TRY(auto requests,
        compensator.restoreRequests({.axes = {planned.backup}}, planned.acceptsOther, options));
    WriteRequest& request = requests.front();
    expectAsPlanned(request, planned.plan);
    const auto report = compensator.write(planned.backup.axis, request, options);
    if (!report && report.error().code != ErrorCode::NothingToWrite)
        return fail(report.error());
    return planned.state;
}

} // namespace

Result<DriveFindings> exploreDrive(AxisCompensator& compensator, const OperationOptions& options)
{
    DriveFindings findings;
    AXISCOMP_TRY(auto drive, compensator.identify(options));
    findings.drive = std::move(drive);
    AXISCOMP_TRY(auto axes, compensator.axes(options));
    findings.axes = std::move(axes);
    AXISCOMP_TRY(auto sources, compensator.sourceShortlist(options));
    findings.sources = std::move(sources);
    return findings;
}

Result<SettledStatus> settledStatus(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int axis, const OperationOptions& options)
{
    SettledStatus now;
    AXISCOMP_CHECK(look(compensator, axis, options, now));
    if (!now.status.unfinishedWrite)
        return now;
    auto lock = DriveStore(storeRoot).tryLockWrites(now.status.drive.serialNumber);
    if (lock && !*lock) {
        now.isBeingWritten = true;
        return now;
    }
    // The other program may have ended its write between the first look and the lock. Where there
    // can be no lock, nobody can write either.
    AXISCOMP_CHECK(look(compensator, axis, options, now));
    if (!now.status.unfinishedWrite)
        return now;
    auto settled = settle(compensator, *now.status.unfinishedWrite, options);
    if (!settled) {
        now.settlingProblem = std::move(settled).error();
        return now;
    }
    if (settled->outcome == AxisCompensator::UnfinishedOutcome::New)
        now.status.unfinishedWrite.reset();
    now.settled = *std::move(settled);
    return now;
}

Result<void> checkMayActivate(const SettledStatus& now)
{
    return checkNoHalf(now, "unfinished");
}

Result<void> checkIsSettled(const SettledStatus& now)
{
    if (now.isBeingWritten)
        return fail(ErrorCode::ChangedMeanwhile,
            {{"what",
                 AXISCOMP_TEXT("Error", "the settings of axis {axis}")
                     .with("axis", now.status.axis.index)},
                {"before", AXISCOMP_TEXT("Error", "the old state")},
                {"now", AXISCOMP_TEXT("Error", "what it is writing at this moment")}});
    if (now.settlingProblem)
        return fail(*now.settlingProblem);
    return {};
}

Result<void> checkIsWhole(const SettledStatus& now)
{
    AXISCOMP_CHECK(checkIsSettled(now));
    return checkNoHalf(now, "half");
}

Result<AxisStatus> wholeStatus(AxisCompensator& compensator, const std::filesystem::path& storeRoot,
    int axis, const OperationOptions& options)
{
    AXISCOMP_TRY(auto now, settledStatus(compensator, storeRoot, axis, options));
    AXISCOMP_CHECK(checkIsWhole(now));
    // A write that ended between the registers and the journal has left no trace in either.
    AXISCOMP_CHECK(compensator.checkUnchanged(now.status, options));
    return std::move(now.status);
}

Result<DriveRescue> backUpDrive(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const OperationOptions& options)
{
    OperationOptions quiet = options;
    quiet.progress = {};
    AXISCOMP_TRY(const auto axes, compensator.axes(quiet));
    DriveRescue rescue;
    std::vector<AxisStatus> before;
    for (const AxisInfo& axis : axes) {
        if (!axis.hasCompensation())
            continue;
        auto now = settledStatus(compensator, storeRoot, axis.index, quiet);
        if (!now && endsBackup(now.error()))
            return fail(std::move(now).error());
        auto whole = now ? checkIsWhole(*now) : Result<void>(fail(now.error()));
        if (!whole)
            rescue.doubts.push_back(std::move(whole).error());
        if (now)
            before.push_back(std::move(now->status));
    }
    AXISCOMP_TRY(rescue.backup, compensator.backup(options));
    // A write may have begun, and even ended, since they were looked at.
    for (const AxisStatus& status : before)
        AXISCOMP_CHECK(compensator.checkUnchanged(status, quiet));
    for (Error& unreadable : compensator.unreadableTables(rescue.backup))
        rescue.doubts.push_back(std::move(unreadable));
    return rescue;
}

Result<AxisReading> readAxis(AxisCompensator& compensator, const std::filesystem::path& storeRoot,
    int axis, const OperationOptions& options)
{
    AxisReading reading;
    AXISCOMP_TRY(
        static_cast<SettledStatus&>(reading), settledStatus(compensator, storeRoot, axis, options));

    // Without its memory the program knows less, but the drive can be used all the same.
    DriveStore store(storeRoot);
    const std::int32_t serialNumber = reading.status.drive.serialNumber;
    if (auto history = store.flashHistory(serialNumber))
        reading.flashHistory = std::move(*history);
    auto use = compensator.flashUse(options);
    if (!use && isLinkFailure(use.error().code))
        return fail(use.error());
    if (use)
        reading.flashUse = std::move(*use);
    reading.hasBackup = !store.backups(serialNumber, axis).empty();
    return reading;
}

OperationEnd<WriteReport> writeAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int axis, WriteRequest request,
    const OperationOptions& options)
{
    auto report = compensator.write(axis, request, options);
    return {std::move(report), readAxis(compensator, storeRoot, axis, quietly(options))};
}

OperationEnd<Activation> switchAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int axis, Switch wanted,
    const OperationOptions& options)
{
    auto outcome = compensator.switchTo(axis, wanted, proofSamples, options);
    return {std::move(outcome), readAxis(compensator, storeRoot, axis, quietly(options))};
}

Result<PlannedRestoration> planRestoration(AxisCompensator& compensator,
    const DriveProfile& profile, const std::filesystem::path& storeRoot, int axis,
    const OperationOptions& options)
{
    AXISCOMP_TRY(const auto status, compensator.status(axis, options));
    AXISCOMP_TRY(auto previous, previousState(DriveStore(storeRoot), profile, status));
    AXISCOMP_TRY(auto plan, compensator.planRestore(previous.backup, false, options));
    return PlannedRestoration{
        {.backupTime = previous.backup.time, .backup = previous.file, .otherDrive = {}},
        std::move(previous.backup), false, std::move(plan)};
}

Result<PlannedRestoration> planRestoration(AxisCompensator& compensator,
    const DriveProfile& profile, const std::filesystem::path& storeRoot, const BackupChoice& choice,
    const OperationOptions& options)
{
    AXISCOMP_TRY(auto backup, chosenBackup(choice, profile));
    AXISCOMP_TRY(auto plan, compensator.planRestore(backup, choice.acceptsOther, options));
    Restoration state{.backupTime = backup.time, .backup = choice.file, .otherDrive = {}};
    state.isBeforeWrite = isKept(DriveStore(storeRoot), plan, choice.file);
    if (backup.drive.serialNumber != plan.drive.serialNumber) {
        state.isBeforeWrite = false;
        state.otherDrive = backup.drive.serialNumber;
        plan.warnings.push_back(AXISCOMP_TEXT(
            "Error", "The backup is of another drive, the one with the serial number {number}.")
                                    .with("number", backup.drive.serialNumber));
    }
    return PlannedRestoration{
        std::move(state), std::move(backup), choice.acceptsOther, std::move(plan)};
}

OperationEnd<Restoration> restoreAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const PlannedRestoration& planned,
    const OperationOptions& options)
{
    auto outcome = restorePlanned(compensator, planned, options);
    return {std::move(outcome),
        readAxis(compensator, storeRoot, planned.backup.axis, quietly(options))};
}

OperationEnd<WriteReport> recoverAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const JournalEntry& entry, bool finishes,
    const OperationOptions& options)
{
    auto report = finishes ? compensator.finishUnfinished(entry, options)
                           : compensator.undoUnfinished(entry, options);
    return {std::move(report), readAxis(compensator, storeRoot, entry.axis, quietly(options))};
}

Result<LoadedTable> downloadTable(AxisCompensator& compensator, int axis,
    const LoadedTable& expected, const OperationOptions& options)
{
    AXISCOMP_TRY(auto table, compensator.readDescribedTable(axis, options));
    if (expected.table && sameSpans(expected.table->grid, table.grid)
        && expected.table->values == table.values)
        return expected;
    return loaded(std::make_shared<const CompensationTable>(std::move(table)));
}

} // namespace axiscomp
