// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole files of the drive, and backups of all of it.
#include "core/axis/verified_transfer.h"
#include "core/compensator/axis_compensator_p.h"
#include "core/compensator/multi_axis_write.h"
#include "core/table/tam_table.h"
#include "core/write/backup_restore.h"
#include "core/write/file_replacement.h"
#include "core/write/restored_axis.h"
#include "core/write/slot_file.h"
#include "core/write/write_planner.h"

namespace axiscomp {

namespace {

/// What is restored, in the order in which it is written.
std::vector<std::string> namesOf(
    const DriveBackup& backup, const std::vector<AxisBackup::File>& files)
{
    std::vector<std::string> names;
    for (const AxisBackup& axis : backup.axes)
        names.push_back(axis.axisName.empty() ? std::to_string(axis.axis) : axis.axisName);
    for (const AxisBackup::File& file : files)
        names.push_back(file.slot);
    return names;
}

/// requests: one for each axis of the backup.
std::vector<AxisWrite> writesOf(const DriveBackup& backup, std::vector<WriteRequest> requests)
{
    std::vector<AxisWrite> writes;
    for (std::size_t n = 0; n < requests.size(); ++n)
        writes.push_back({backup.axes[n].axis, std::move(requests[n])});
    return writes;
}

Result<TableSlot> knownSlot(const DriveProfile& profile, const std::string& name)
{
    if (const TableSlot* slot = profile.slotNamed(name))
        return *slot;
    std::vector<std::string> known;
    for (const TableSlot& slot : profile.tableSlots)
        known.push_back(slot.name);
    return fail(ErrorCode::SlotNotFound, {{"slot", name}, {"known", known}});
}

} // namespace

Result<std::vector<DriveFile>> AxisCompensator::files(const OperationOptions& options)
{
    return d->link.listFiles(d->access(options).exchange());
}

Result<Bytes> AxisCompensator::download(const std::string& path, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    Exchange exchange = access.exchange();
    exchange.progress = [&](std::uint64_t done, std::uint64_t total) {
        if (total > 0)
            access.report("download", static_cast<double>(done) / static_cast<double>(total));
    };
    if (const TableSlot* slot = d->profile.slotOfFile(path)) {
        AXISCOMP_TRY(auto bytes, downloadSlotFile(access, *slot, exchange));
        if (!bytes.empty())
            return bytes;
    }
    return d->link.download(path, exchange); // of an empty slot: what the drive says
}

Result<std::filesystem::path> AxisCompensator::upload(const std::string& path, ByteView bytes,
    const OperationOptions& options, std::optional<std::int32_t> expectedDrive)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access));
    AXISCOMP_CHECK(Private::checkExpected(drive, expectedDrive));
    auto lock = d->store.lockWrites(drive.serialNumber);
    if (!lock)
        return fail(lock.error());
    const TableSlot* slot = d->profile.slotOfFile(path);
    if (!slot)
        return fail(ErrorCode::UnknownFile, {{"path", path}});
    return FileReplacement(access, d->store, drive, d->clock, *slot)
        .run(bytes, FileReplacement::Users::Allowed);
}

Result<UploadPlan> AxisCompensator::planUpload(
    const std::string& path, ByteView bytes, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access));
    const TableSlot* slot = d->profile.slotOfFile(path);
    if (!slot)
        return fail(ErrorCode::UnknownFile, {{"path", path}});
    AXISCOMP_TRY(const auto cost,
        FileReplacement(access, d->store, drive, d->clock, *slot).planReplacement(bytes));
    AXISCOMP_TRY(const auto history, d->store.flashHistory(drive.serialNumber));
    const auto decoded = decodeTamTable(bytes, d->profile.layout);
    return UploadPlan{drive, decoded && decoded->persistent, cost.operations,
        wearGuard(d->profile.flashWear, history).budget(d->clock())};
}

Result<SlotDeletion> AxisCompensator::planSlotDeletion(
    const std::string& slot, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(const TableSlot found, knownSlot(d->profile, slot));
    AXISCOMP_TRY(auto drive, d->identify(access));
    return FileReplacement(access, d->store, drive, d->clock, found).planDeletion();
}

Result<std::filesystem::path> AxisCompensator::deleteSlot(const std::string& slot,
    const OperationOptions& options, std::optional<std::int32_t> expectedDrive)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(const TableSlot found, knownSlot(d->profile, slot));
    AXISCOMP_TRY(auto drive, d->identify(access));
    AXISCOMP_CHECK(Private::checkExpected(drive, expectedDrive));
    AXISCOMP_TRY(const auto lock, d->store.lockWrites(drive.serialNumber));
    AXISCOMP_CHECK(FileReplacement(access, d->store, drive, d->clock, found).planDeletion());
    return FileReplacement(access, d->store, drive, d->clock, found)
        .run({}, FileReplacement::Users::Refused);
}

Result<FlashUse> AxisCompensator::flashUse(const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access));
    return readFlashUse(access, d->store, drive, d->clock());
}

Result<void> AxisCompensator::checkFlash(
    int operations, int reserve, const OperationOptions& options)
{
    AXISCOMP_TRY(const auto drive, d->identify(d->access(options)));
    return d->checkFlash(drive, operations, reserve);
}

Result<void> AxisCompensator::Private::checkFlash(
    const DriveIdentity& drive, int operations, int reserve)
{
    AXISCOMP_TRY(const auto history, store.flashHistory(drive.serialNumber));
    return checkFlashBudget(wearGuard(profile.flashWear, history), clock(), operations, reserve);
}

Result<void> AxisCompensator::resetFlashCount(const OperationOptions& options)
{
    AXISCOMP_TRY(auto drive, d->identify(d->access(options)));
    return d->store.acceptFlashLoss(drive.serialNumber);
}

Result<DriveBackup> AxisCompensator::backup(const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access));
    return readBackupOf(access, drive, d->sources, d->clock());
}

std::vector<Error> AxisCompensator::unreadableTables(const DriveBackup& backup) const
{
    std::vector<Error> unreadable;
    const auto look = [&](const std::vector<AxisBackup::File>& files) {
        for (const AxisBackup::File& file : files)
            if (!file.bytes.empty() && !decodeTamTable(file.bytes, d->profile.layout))
                unreadable.push_back(Error{ErrorCode::InvalidTable,
                    {{"kept", Verbatim{"file"}}, {"slot", file.slot}}, {}});
    };
    for (const AxisBackup& axis : backup.axes)
        look(axis.files);
    look(backup.otherFiles);
    return unreadable;
}

Result<RestoreReport> AxisCompensator::restore(
    const DriveBackup& backup, bool force, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access));
    auto lock = d->store.lockWrites(drive.serialNumber);
    if (!lock)
        return fail(lock.error());
    // Nothing is begun that cannot be ended.
    AXISCOMP_TRY(auto requests, restoreRequests(backup, force, options));
    const std::vector<AxisWrite> writes = writesOf(backup, std::move(requests));
    AXISCOMP_TRY(const auto plans, planRestorations(backup, writes, options));
    const std::vector<AxisBackup::File> files = filesBesides(backup, plans.axes);
    std::size_t turn = 0;
    auto done = d->restoreAll(access, drive, writes, plans.axes, files, turn);
    if (done)
        return done;
    const std::vector<std::string> names = namesOf(backup, files);
    Error error = ofSeveral(std::move(done).error(), names, turn);
    if (turn < backup.axes.size())
        error.context.set("ofAxis", backup.axes[turn].axis);
    if (turn == names.size())
        error.context.set("lost", Verbatim{"yes"});
    return fail(std::move(error));
}

Result<RestoreReport> AxisCompensator::Private::restoreAll(const RegisterAccess& access,
    const DriveIdentity& drive, std::span<const AxisWrite> writes, std::span<const WritePlan> plans,
    const std::vector<AxisBackup::File>& files, std::size_t& turn)
{
    RestoreReport done;
    std::vector<AxisStatus> restored;
    const auto restoreAxis = [&](std::size_t n,
                                 const WriteRequest& request) -> Result<WriteReport> {
        turn = n;
        auto report = write(access, drive, writes[n].axis, request);
        if (!holdsNewState(report))
            return report;
        AXISCOMP_TRY(
            auto now, report ? report->now : readStatus(access, drive, writes[n].axis, sources));
        restored.push_back(std::move(now));
        return report;
    };
    for (auto& report : writeInTurn(writes, plans, restoreAxis)) {
        if (report)
            done.axes.push_back(std::move(*report));
        else if (!holdsNewState(report))
            return fail(std::move(report).error());
    }
    turn = writes.size();
    for (const AxisBackup::File& file : files) {
        AXISCOMP_TRY(const bool isWritten, restoreFile(access, drive, file));
        if (isWritten)
            done.files.push_back(file);
        ++turn;
    }
    AXISCOMP_CHECK(checkRestored(access, drive, restored, files));
    return done;
}

Result<std::vector<WriteRequest>> AxisCompensator::restoreRequests(
    const DriveBackup& backup, bool force, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(const auto drive, d->identify(access));
    AXISCOMP_CHECK(checkRestorable(access, backup, drive, force));
    for (const AxisBackup::File& file : backup.otherFiles)
        AXISCOMP_CHECK(d->slotOf(file));
    if (!backup.otherFiles.empty()) // which no axis has checked
        for (const AxisBackup& axis : backup.axes)
            AXISCOMP_CHECK(checkLayout(axis, d->profile, drive.serialNumber));
    std::vector<WriteRequest> requests;
    for (const AxisBackup& axis : backup.axes) {
        AXISCOMP_TRY(auto request, restoreRequest(access, d->sources, axis));
        request.acceptsLarge = true; // the drive had it
        requests.push_back(std::move(request));
    }
    return requests;
}

Result<void> AxisCompensator::restoreFiles(
    const std::vector<AxisBackup::File>& files, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(const auto drive, d->identify(access));
    AXISCOMP_TRY(const auto lock, d->store.lockWrites(drive.serialNumber));
    for (const AxisBackup::File& file : files)
        AXISCOMP_CHECK(d->restoreFile(access, drive, file));
    return d->checkRestored(access, drive, {}, files);
}

Result<RestorePlan> AxisCompensator::planRestore(
    const DriveBackup& backup, bool force, const OperationOptions& options)
{
    AXISCOMP_TRY(auto requests, restoreRequests(backup, force, options));
    return planRestorations(backup, writesOf(backup, std::move(requests)), options);
}

Result<RestorePlan> AxisCompensator::planRestorations(
    const DriveBackup& backup, std::span<const AxisWrite> writes, const OperationOptions& options)
{
    OperationOptions quiet = options;
    quiet.progress = {};
    AXISCOMP_TRY(auto plans, planMultiAxis(*this, writes, quiet));
    AXISCOMP_TRY(auto files, planFiles(backup, plans, options));
    for (WritePlan& plan : plans) {
        plan.unitRemarks.clear();
        plan.largeCorrections.clear();
        for (const AxisBackup::File& file : backup.otherFiles)
            if (!file.bytes.empty() && file.slot == plan.after.slot)
                plan.warnings.push_back(AXISCOMP_TEXT("Error",
                    "The table that no axis used in {slot} is not restored: the table of this "
                    "axis is there.")
                                            .with("slot", file.slot));
    }
    return RestorePlan{std::move(plans), std::move(files)};
}

Result<WritePlan> AxisCompensator::planRestore(
    const AxisBackup& backup, bool force, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(const auto drive, d->identify(access));
    AXISCOMP_CHECK(checkRestorable(access, {.axes = {backup}}, drive, force));
    AXISCOMP_TRY(const auto request, restoreRequest(access, d->sources, backup));
    AXISCOMP_TRY(auto planned, plan(backup.axis, request, options));
    planned.unitRemarks.clear();
    planned.largeCorrections.clear();
    return planned;
}

Result<std::vector<PlannedFile>> AxisCompensator::planFiles(
    const DriveBackup& backup, const std::vector<WritePlan>& plans, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(const auto drive, d->identify(access));
    FlashSum flash;
    for (const WritePlan& plan : plans)
        flash.add(plan.flashOperations, plan.flashReserve);
    std::vector<PlannedFile> files;
    for (const AxisBackup::File& file : filesBesides(backup, plans)) {
        AXISCOMP_TRY(auto planned, d->planFile(access, drive, file));
        flash.add(planned.flashOperations, planned.flashReserve);
        files.push_back(std::move(planned));
    }
    AXISCOMP_CHECK(flash.check(*this, options));
    return files;
}

Result<PlannedFile> AxisCompensator::Private::planFile(
    const RegisterAccess& access, const DriveIdentity& drive, const AxisBackup::File& file)
{
    AXISCOMP_TRY(const TableSlot slot, slotOf(file));
    AXISCOMP_TRY(const auto cost,
        FileReplacement(access, store, drive, clock, slot).planReplacement(file.bytes));
    return PlannedFile{file, cost.isThere, cost.operations, cost.reserve};
}

/// A drive that restarted while a later part was restored has lost what was volatile or not saved
/// of an earlier one.
Result<void> AxisCompensator::Private::checkRestored(const RegisterAccess& access,
    const DriveIdentity& drive, const std::vector<AxisStatus>& axes,
    const std::vector<AxisBackup::File>& files)
{
    for (const AxisStatus& wanted : axes) {
        AXISCOMP_TRY(auto now, readStatus(access, drive, wanted.axis.index, sources));
        if (!(now.setup == wanted.setup))
            return fail(ErrorCode::VerifyMismatch,
                {{"what", axisText(wanted.axis.index, wanted.axis.name)},
                    {"found", setupText(now.setup)}, {"expected", setupText(wanted.setup)}});
    }
    for (const AxisBackup::File& wanted : files) {
        AXISCOMP_TRY(auto now, readSlotFile(access, *profile.slotNamed(wanted.slot)));
        if (auto same = compareFiles(wanted.path, now.bytes, wanted.bytes); !same)
            return same;
    }
    return {};
}

Result<TableSlot> AxisCompensator::Private::slotOf(const AxisBackup::File& file) const
{
    const TableSlot* slot = profile.slotNamed(file.slot);
    if (!slot || slot->file != file.path)
        return fail(ErrorCode::UnknownFile, {{"path", file.path}});
    return *slot;
}

Result<bool> AxisCompensator::Private::restoreFile(
    const RegisterAccess& access, const DriveIdentity& drive, const AxisBackup::File& file)
{
    AXISCOMP_TRY(const TableSlot slot, slotOf(file));
    auto replaced = FileReplacement(access, store, drive, clock, slot)
                        .run(file.bytes, FileReplacement::Users::Refused);
    if (!replaced)
        return fail(replaced.error());
    return !replaced->empty();
}

} // namespace axiscomp
