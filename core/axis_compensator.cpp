// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis_compensator.h"

#include "core/activation.h"
#include "core/axis_reader.h"
#include "core/backup_restore.h"
#include "core/proof.h"
#include "core/tam_table.h"
#include "core/verified_write.h"
#include "core/write_planner.h"
#include "core/write_procedure.h"

#include <algorithm>
#include <charconv>

namespace axiscomp {

struct AxisCompensator::Private {
    DriveLink& link;
    const DriveProfile& profile;
    DriveStore& store;
    std::function<WallTime()> clock;
    SourceDirectory sources;

    [[nodiscard]] DriveAccess access(const OperationOptions& options) const
    {
        return DriveAccess(link, profile, options);
    }

    [[nodiscard]] Result<DriveIdentity> identify(const DriveAccess& access)
    {
        auto drive = link.identify(access.exchange());
        if (drive)
            sources.useDrive(*drive);
        return drive;
    }

    /// Errors: AxisNotFound.
    [[nodiscard]] Result<DriveIdentity> identify(const DriveAccess& access, int axis)
    {
        auto drive = identify(access);
        if (drive && (axis < 0 || axis >= drive->axes))
            return fail(ErrorCode::AxisNotFound,
                {{"axis", std::to_string(axis)},
                    {"known", "0 to " + std::to_string(drive->axes - 1)}});
        return drive;
    }
};

AxisCompensator::AxisCompensator(DriveLink& link, const DriveProfile& profile, DriveStore& store,
    std::function<WallTime()> clock)
    : d(new Private{link, profile, store, std::move(clock), {}})
{
}

AxisCompensator::~AxisCompensator() = default;

Result<DriveIdentity> AxisCompensator::identify(const OperationOptions& options)
{
    return d->identify(d->access(options));
}

Result<std::vector<AxisInfo>> AxisCompensator::axes(const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access);
    if (!drive)
        return fail(drive.error());
    return readAxes(access, *drive);
}

Result<int> AxisCompensator::findAxis(
    const std::string& indexOrName, const OperationOptions& options)
{
    auto all = axes(options);
    if (!all)
        return fail(all.error());
    int index = -1;
    const char* end = indexOrName.data() + indexOrName.size();
    const auto parsed = std::from_chars(indexOrName.data(), end, index);
    if (parsed.ec == std::errc{} && parsed.ptr == end && index >= 0
        && index < static_cast<int>(all->size()))
        return index;
    std::string known;
    std::string matches;
    for (const AxisInfo& info : *all) {
        known += (known.empty() ? "" : ", ") + axisText(info.index, info.name);
        if (info.name != indexOrName)
            continue;
        index = info.index;
        matches += (matches.empty() ? "" : ", ") + std::to_string(info.index);
    }
    if (matches.empty())
        return fail(ErrorCode::AxisNotFound, {{"axis", indexOrName}, {"known", known}});
    if (matches.find(',') != std::string::npos)
        return fail(ErrorCode::AxisAmbiguous, {{"axis", indexOrName}, {"matches", matches}});
    return index;
}

Result<AxisStatus> AxisCompensator::status(int axis, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access, axis);
    if (!drive)
        return fail(drive.error());
    auto status = readStatus(access, *drive, axis, d->sources);
    if (!status)
        return status;
    auto journal = d->store.journal(drive->serialNumber, axis);
    if (!journal)
        return fail(journal.error());
    status->unfinishedWrite = *journal;
    return status;
}

Result<DimSource> AxisCompensator::resolveSource(
    const std::string& source, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access);
    if (!drive)
        return fail(drive.error());
    return d->sources.resolve(access, source);
}

Result<std::vector<DimSource>> AxisCompensator::sourceShortlist(const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access);
    if (!drive)
        return fail(drive.error());
    return d->sources.shortlist(access);
}

Result<WritePlan> AxisCompensator::plan(
    int axis, const WriteRequest& request, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access, axis);
    if (!drive)
        return fail(drive.error());
    auto prepared =
        WritePlanner(access, d->store, d->sources, *drive, d->clock()).prepare(axis, request);
    if (!prepared)
        return fail(prepared.error());
    return prepared->plan;
}

Result<WriteReport> AxisCompensator::write(
    int axis, const WriteRequest& request, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    access.report("plan", 0.0);
    auto drive = d->identify(access, axis);
    if (!drive)
        return fail(drive.error());
    auto lock = d->store.lockWrites(drive->serialNumber);
    if (!lock)
        return fail(lock.error());
    auto prepared =
        WritePlanner(access, d->store, d->sources, *drive, d->clock()).prepare(axis, request);
    if (!prepared)
        return fail(prepared.error());
    // A persistent table whose parameters may not have been saved yet still has to be.
    const bool onlySaves =
        !request.table && request.sources.empty() && request.persistency == Persistency::Persistent;
    auto unfinished = d->store.journal(drive->serialNumber, axis);
    if (!unfinished)
        return fail(unfinished.error());
    if (prepared->plan.changes.empty() && !onlySaves && !*unfinished)
        return fail(ErrorCode::NothingToWrite, {{"axis", std::to_string(axis)}});
    return WriteProcedure(access, d->store, d->sources, d->clock, std::move(*prepared)).run();
}

Result<WriteReport> AxisCompensator::setPersistency(
    int axis, Persistency persistency, const OperationOptions& options)
{
    auto now = status(axis, options);
    if (!now)
        return fail(now.error());
    if (!now->table)
        return fail(ErrorCode::NoTable, {{"axis", std::to_string(axis)}});
    WriteRequest request;
    request.dimensionality = now->setup.dimensionality;
    request.persistency = persistency;
    return write(axis, request, options);
}

Result<AxisStatus> AxisCompensator::evaluate(int axis, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access, axis);
    if (!drive)
        return fail(drive.error());
    return evaluateAxis(access, *drive, axis, d->sources);
}

Result<AxisStatus> AxisCompensator::activate(int axis, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access, axis);
    if (!drive)
        return fail(drive.error());
    return activateAxis(access, *drive, axis, d->sources);
}

Result<AxisStatus> AxisCompensator::deactivate(int axis, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access, axis);
    if (!drive)
        return fail(drive.error());
    return deactivateAxis(access, *drive, axis, d->sources);
}

Result<Proof> AxisCompensator::prove(int axis, int samples, const OperationOptions& options)
{
    auto now = status(axis, options);
    if (!now)
        return fail(now.error());
    auto table = readTable(axis, options);
    if (!table)
        return fail(table.error());
    return proveAxis(d->access(options), *now, *table, samples);
}

Result<CompensationTable> AxisCompensator::readTable(int axis, const OperationOptions& options)
{
    auto now = status(axis, options);
    if (!now)
        return fail(now.error());
    const TableSlot* slot = d->profile.slotNamed(now->setup.slot);
    if (!slot || !now->table)
        return fail(ErrorCode::NoTable, {{"axis", std::to_string(axis)}});
    auto bytes = download(slot->file, options);
    if (!bytes)
        return fail(bytes.error());
    auto decoded = decodeTamTable(*bytes, d->profile.layout);
    if (!decoded)
        return fail(decoded.error());
    return std::move(decoded->table);
}

Result<std::vector<DriveFile>> AxisCompensator::files(const OperationOptions& options)
{
    return d->link.listFiles(d->access(options).exchange());
}

Result<Bytes> AxisCompensator::download(const std::string& path, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    Exchange exchange = access.exchange();
    exchange.progress = [&](std::uint64_t done, std::uint64_t total) {
        if (total > 0)
            access.report("download", static_cast<double>(done) / static_cast<double>(total));
    };
    return d->link.download(path, exchange);
}

Result<void> AxisCompensator::upload(
    const std::string& path, ByteView bytes, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto old = d->link.download(path, access.exchange());
    const bool wasEmpty = !old && old.error().code == ErrorCode::UnknownFile;
    if (!old && !wasEmpty)
        return fail(old.error());
    auto uploaded = uploadSurely(access, path, bytes,
        [&](std::string_view step, double fraction) { access.report(step, fraction); });
    const bool refused = !uploaded && !isUncertain(uploaded.error().code)
        && uploaded.error().code != ErrorCode::VerifyMismatch;
    if (uploaded || refused)
        return uploaded;

    const DriveAccess rest = access.withoutStop();
    const TableSlot* slot = d->profile.slotOfFile(path);
    Result<void> restored;
    if (!wasEmpty && !old->empty())
        restored = uploadSurely(rest, path, *old);
    else if (slot)
        restored = deleteTable(rest, slot->name);
    if (restored)
        return uploaded;
    return fail(ErrorCode::RollbackFailed,
        {{"reason", sentence(uploaded.error())}, {"rollback", sentence(restored.error())},
            {"backup", "its own file"}});
}

Result<DriveBackup> AxisCompensator::backup(const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access);
    if (!drive)
        return fail(drive.error());
    return readBackupOf(access, *drive, d->clock());
}

Result<std::vector<WriteReport>> AxisCompensator::restore(
    const DriveBackup& backup, bool force, const OperationOptions& options)
{
    const DriveAccess access = d->access(options);
    auto drive = d->identify(access);
    if (!drive)
        return fail(drive.error());
    if (auto allowed = checkRestorable(access, backup, *drive, force); !allowed)
        return fail(allowed.error());
    std::vector<WriteReport> reports;
    for (const AxisBackup& axis : backup.axes) {
        auto request = restoreRequest(access, axis);
        if (!request)
            return fail(request.error());
        if (!*request) {
            if (auto disabled = restoreDisabled(access, axis); !disabled)
                return fail(disabled.error());
            continue;
        }
        auto report = write(axis.axis, **request, options);
        if (!report && report.error().code == ErrorCode::NothingToWrite)
            continue;
        if (!report)
            return fail(report.error());
        reports.push_back(std::move(*report));
    }
    for (const AxisBackup::File& file : backup.otherFiles) {
        if (auto restored = restoreFile(access, file, drive->axes); !restored)
            return fail(restored.error());
    }
    return reports;
}

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
