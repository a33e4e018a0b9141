// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/axis_compensator_p.h"

#include "core/axis/activation.h"
#include "core/axis/axis_reader.h"
#include "core/axis/proof.h"
#include "core/axis/shown_grid.h"
#include "core/axis/verified_transfer.h"
#include "core/compensator/axis_naming.h"
#include "core/compensator/table_of_axis.h"
#include "core/table/tam_table.h"
#include "core/text/crc_text.h"
#include "core/write/backup_restore.h"
#include "core/write/write_planner.h"
#include "core/write/write_procedure.h"

namespace axiscomp {

namespace {

/// A persistent table whose parameters may not have been saved yet still has to be.
bool onlySaves(const WriteRequest& request)
{
    return !request.table && request.sources.empty()
        && request.persistency == Persistency::Persistent;
}

} // namespace

AxisCompensator::AxisCompensator(DriveLink& link, const DriveProfile& profile, DriveStore& store,
    std::function<WallTime()> clock)
    : d(new Private{link, profile, store, std::move(clock), {}})
{
}

AxisCompensator::~AxisCompensator() = default;

const DriveProfile& AxisCompensator::profile() const
{
    return d->profile;
}

Result<DriveIdentity> AxisCompensator::identify(const OperationOptions& options)
{
    return d->identify(d->access(options));
}

Result<std::vector<AxisInfo>> AxisCompensator::axes(const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access));
    return readAxes(access, drive);
}

Result<int> AxisCompensator::findAxis(
    const std::string& indexOrName, const OperationOptions& options)
{
    AXISCOMP_TRY(auto all, axes(options));
    return axisAmong(all, indexOrName);
}

Result<AxisStatus> AxisCompensator::status(int axis, const OperationOptions& options)
{
    AXISCOMP_TRY(auto watched, watch(axis, {}, options));
    if (watched.journalProblem)
        return fail(*std::move(watched.journalProblem));
    return std::move(watched.status);
}

Result<WatchedStatus> AxisCompensator::watch(
    int axis, const std::vector<std::string>& registers, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, axis));
    AXISCOMP_TRY(auto reading, readStatusWith(access, drive, axis, d->sources, registers));
    WatchedStatus watched{std::move(reading.status), {}, {}};
    if (auto journal = d->store.journal(drive.serialNumber, axis))
        watched.status.unfinishedWrite = *std::move(journal);
    else
        watched.journalProblem = std::move(journal).error();
    for (const std::string& path : registers)
        watched.values.emplace(path, numberAt(reading.readings, path));
    return watched;
}

Result<DimSource> AxisCompensator::resolveSource(
    const std::string& source, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    auto drive = d->identify(access);
    if (!drive)
        return fail(drive.error());
    return d->sources.resolve(access, source);
}

Result<std::vector<DimSource>> AxisCompensator::sourceShortlist(const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    auto drive = d->identify(access);
    if (!drive)
        return fail(drive.error());
    return d->sources.shortlist(access);
}

Result<WritePlan> AxisCompensator::plan(
    int axis, const WriteRequest& request, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, axis));
    AXISCOMP_TRY(const auto unfinished, d->store.journal(drive.serialNumber, axis));
    AXISCOMP_TRY(auto prepared, d->prepare(access, drive, axis, request, unfinished.has_value()));
    return prepared.plan;
}

Result<WritePlan> AxisCompensator::compare(
    int axis, const WriteRequest& request, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, axis));
    return WritePlanner(access, d->store, d->sources, drive, d->clock()).compare(axis, request);
}

Result<WriteReport> AxisCompensator::write(
    int axis, const WriteRequest& request, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    access.report("plan", 0.0);
    AXISCOMP_TRY(auto drive, d->identify(access, axis));
    AXISCOMP_CHECK(Private::checkExpected(drive, request.expectedDrive));
    auto lock = d->store.lockWrites(drive.serialNumber);
    if (!lock)
        return fail(lock.error());
    return d->write(access, drive, axis, request);
}

/// Where something is written although nothing differs the compensation has to be off.
Result<PreparedWrite> AxisCompensator::Private::prepare(const RegisterAccess& access,
    const DriveIdentity& drive, int axis, const WriteRequest& request, bool isUnfinished)
{
    WritePlanner planner(access, store, sources, drive, clock());
    return isUnfinished || onlySaves(request) ? planner.prepare(axis, request)
                                              : planner.prepareChanges(axis, request);
}

Result<WriteReport> AxisCompensator::Private::write(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, const WriteRequest& request)
{
    AXISCOMP_TRY(auto unfinished, store.journal(drive.serialNumber, axis));
    AXISCOMP_TRY(auto prepared, prepare(access, drive, axis, request, unfinished.has_value()));
    if (prepared.plan.changes.empty() && !onlySaves(request) && !unfinished)
        return fail(ErrorCode::NothingToWrite, {{"axis", axis}});
    AXISCOMP_CHECK(checkLargeAccepted(prepared.plan, request));
    // What an interrupted deletion has left to do is its end, and not another one.
    const bool continues = unfinished && !unfinished->deletedSlot.empty()
        && unfinished->deletedSlot == prepared.plan.deletedSlot;
    WriteProcedure procedure(
        access, store, sources, clock, std::move(prepared), std::move(unfinished));
    return continues ? procedure.finishEarlier() : procedure.run();
}

Result<WriteReport> AxisCompensator::setPersistency(
    int axis, Persistency persistency, const OperationOptions& options)
{
    AXISCOMP_TRY(auto now, status(axis, options));
    if (!now.table)
        return fail(ErrorCode::NoTable, {{"axis", axis}});
    WriteRequest request;
    request.dimensionality = now.setup.dimensionality;
    request.persistency = persistency;
    request.expectedDrive = now.drive.serialNumber;
    request.expected = plannedState(now); // a restart in between brings back another table
    return write(axis, request, options);
}

Result<AxisStatus> AxisCompensator::evaluate(int axis, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, axis));
    AXISCOMP_CHECK(readTable(axis, options));
    return evaluateAxis(access, drive, axis, d->sources);
}

Result<AxisStatus> AxisCompensator::activate(int axis, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, axis));
    AXISCOMP_CHECK(readTable(axis, options));
    return activateAxis(access, drive, axis, d->sources);
}

Result<AxisStatus> AxisCompensator::deactivate(int axis, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, axis));
    return deactivateAxis(access, drive, axis, d->sources);
}

Result<Proof> AxisCompensator::prove(int axis, int samples, const OperationOptions& options)
{
    AXISCOMP_TRY(auto now, status(axis, options));
    AXISCOMP_TRY(auto table, readTable(now, options));
    return proveAxis(d->access(options), now, table, samples);
}

std::optional<Text> Activation::notProved() const
{
    if (!proof || !*proof || (*proof)->extent == Proof::Extent::Proved)
        return std::nullopt;
    const bool isEvaluating = status.axis.state == CompensationState::Evaluating;
    if (isEvaluating && (*proof)->extent == Proof::Extent::IndicesOnly)
        return std::nullopt;
    return notProvedText((*proof)->extent);
}

Result<Activation> AxisCompensator::switchTo(
    int axis, Switch wanted, int samples, const OperationOptions& options)
{
    if (wanted == Switch::Deactivate) {
        AXISCOMP_TRY(auto off, deactivate(axis, options));
        return Activation{std::move(off), std::nullopt};
    }
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto before, status(axis, options));
    if (wanted == Switch::Activate && !before.axis.isHomed && !before.isOn())
        return fail(ErrorCode::NotHomed, {{"axis", axis}});
    AXISCOMP_TRY(const auto table, readTable(before, options));
    auto now = wanted == Switch::Activate ? activateAxis(access, before.drive, axis, d->sources)
                                          : evaluateAxis(access, before.drive, axis, d->sources);
    Activation activation{before, std::nullopt};
    if (!now) {
        Error error = std::move(now).error();
        if (!d->withdraw(before, activation, access))
            error.context.set("compensation", Verbatim{"unknown"});
        return fail(std::move(error));
    }
    activation.status = *std::move(now);
    activation.proof = proveAxis(access, activation.status, table, samples);
    const bool hasChanged = before.axis.state != activation.status.axis.state;
    if (!*activation.proof && hasChanged)
        d->putBack(before, activation, access);
    return activation;
}

/// A switch that was not seen to its end must not happen later, unproved. An error of the
/// compensation stays, to be read.
bool AxisCompensator::Private::withdraw(
    const AxisStatus& before, Activation& activation, const RegisterAccess& access)
{
    const RegisterAccess quiet = access.withoutStop().expecting(before.drive);
    if (!quiet.checkDrive())
        return false;
    const auto now = readStatus(quiet, before.drive, before.axis.index, sources);
    if (!now)
        return false;
    if (now->axis.state == CompensationState::Error || now->activation == before.activation)
        return true;
    putBack(before, activation, access);
    return activation.isPutBack;
}

/// Goes on after the user has stopped, and as well as it can after anything else.
void AxisCompensator::Private::putBack(
    const AxisStatus& before, Activation& activation, const RegisterAccess& access)
{
    const RegisterAccess quiet = access.withoutStop().expecting(before.drive);
    if (!quiet.checkDrive())
        return;
    const int axis = before.axis.index;
    auto off = deactivateAxis(quiet, before.drive, axis, sources);
    if (off && before.axis.state == CompensationState::Evaluating)
        off = evaluateAxis(quiet, before.drive, axis, sources);
    activation.isPutBack = off.has_value();
    if (off)
        activation.status = *std::move(off);
}

Result<void> AxisCompensator::checkUnchanged(
    const AxisStatus& read, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, read.axis.index));
    AXISCOMP_TRY(const auto now, readStatus(access, drive, read.axis.index, d->sources));
    if (now.drive.serialNumber != read.drive.serialNumber)
        return fail(ErrorCode::OtherDrive,
            {{"expected", read.drive.serialNumber}, {"found", now.drive.serialNumber}});
    AXISCOMP_CHECK(checkAsPlanned(plannedState(read), now));
    return checkUnitsAsPlanned(plannedState(read), *plannedState(now).units, now);
}

/// Another program may have written in between: status and file must be of one state.
Result<HeldTable> AxisCompensator::readHeldTable(
    const AxisStatus& status, const OperationOptions& options)
{
    const TableSlot* slot = d->profile.slotNamed(status.setup.slot);
    if (!slot || !status.table)
        return fail(ErrorCode::NoTable, {{"axis", status.axis.index}});
    auto bytes = download(slot->file, options);
    if (!bytes && bytes.error().code != ErrorCode::UnknownFile)
        return fail(std::move(bytes).error());
    AXISCOMP_CHECK(checkUnchanged(status, options)); // also when the file has gone
    if (!bytes)
        return fail(std::move(bytes).error());
    AXISCOMP_TRY(auto decoded, decodeTamTable(*bytes, d->profile.layout));
    // It may have been changed and changed back. A drive that shows no CRC says 0.
    const std::uint32_t crc = elementCrcOf(*bytes, decoded.table);
    if (status.table->crc != 0 && crc != status.table->crc)
        return fail(ErrorCode::ChangedMeanwhile,
            {{"what", AXISCOMP_TEXT("Error", "the table in {slot}").with("slot", slot->name)},
                {"before",
                    AXISCOMP_TEXT("Error", "CRC {crc}").with("crc", crcText(status.table->crc))},
                {"now", AXISCOMP_TEXT("Error", "CRC {crc}").with("crc", crcText(crc))}});
    AXISCOMP_CHECK(checkShownGrid(
        ErrorCode::InvalidTable, slot->name, status.table->grid, decoded.table.grid));
    return HeldTable{std::move(decoded.table), *std::move(bytes)};
}

Result<CompensationTable> AxisCompensator::readTable(int axis, const OperationOptions& options)
{
    AXISCOMP_TRY(const auto now, status(axis, options));
    return readTable(now, options);
}

Result<CompensationTable> AxisCompensator::readTable(
    const AxisStatus& status, const OperationOptions& options)
{
    AXISCOMP_TRY(auto held, readHeldTable(status, options));
    return std::move(held.table);
}

Result<CompensationTable> AxisCompensator::readDescribedTable(
    int axis, const OperationOptions& options)
{
    const RegisterAccess access = d->access(options);
    AXISCOMP_TRY(auto drive, d->identify(access, axis));
    AXISCOMP_TRY(const auto now, readStatus(access, drive, axis, d->sources));
    return readDescribedTable(now, options);
}

Result<CompensationTable> AxisCompensator::readDescribedTable(
    const AxisStatus& status, const OperationOptions& options)
{
    AXISCOMP_TRY(auto table, readTable(status, options));
    AXISCOMP_TRY(const auto all, axes(options));
    describeTable(table, status, all, d->profile);
    return table;
}

} // namespace axiscomp
