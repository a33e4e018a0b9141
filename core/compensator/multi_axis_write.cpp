// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/multi_axis_write.h"

#include "core/write/backup_restore.h"

#include <algorithm>
#include <optional>
#include <set>

namespace axiscomp {

namespace {

auto refuse(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

std::vector<AxisWrite> axisWrites(std::span<const AxisTable> tables)
{
    std::vector<AxisWrite> writes;
    for (const AxisTable& table : tables) {
        writes.push_back({table.axis, table.request});
        if (table.table.table)
            writes.back().request.table = *table.table.table;
    }
    return writes;
}

Result<MultiAxisReport> writeAll(AxisCompensator& compensator, std::span<const AxisTable> tables,
    std::atomic<std::size_t>& turn, const OperationOptions& options)
{
    const std::vector<AxisWrite> writes = axisWrites(tables);
    AXISCOMP_TRY(const auto plans, planMultiAxis(compensator, writes, options));
    for (std::size_t n = 0; n < writes.size(); ++n)
        AXISCOMP_CHECK(checkLargeAccepted(plans[n], writes[n].request));
    const auto write = [&](std::size_t n, const WriteRequest& request) {
        turn = n;
        OperationOptions part = options;
        part.progress = [&](const Progress& progress) {
            if (options.progress)
                options.progress({progress.step,
                    (static_cast<double>(n) + progress.fraction)
                        / static_cast<double>(writes.size())});
        };
        return compensator.write(writes[n].axis, request, part);
    };
    return MultiAxisReport{.writes = writeInTurn(writes, plans, write)};
}

} // namespace

WriteSequence sequenceOf(std::span<const AxisWrite> writes)
{
    WriteSequence sequence;
    for (const auto& [axis, request] : writes)
        sequence.expect(axis,
            !request.withoutTable && request.persistency == std::optional(Persistency::Persistent));
    return sequence;
}

Result<std::vector<WritePlan>> planMultiAxis(AxisCompensator& compensator,
    std::span<const AxisWrite> writes, const OperationOptions& options)
{
    std::set<int> axes;
    for (const AxisWrite& write : writes)
        if (!axes.insert(write.axis).second)
            return refuse(
                AXISCOMP_TEXT("Error", "axis {axis} is named twice").with("axis", write.axis));
    std::vector<WritePlan> plans;
    FlashSum flash;
    WriteSequence sequence = sequenceOf(writes);
    for (const AxisWrite& write : writes) {
        WriteRequest request = write.request;
        sequence.begin(write.axis, request);
        auto plan = compensator.plan(write.axis, request, options);
        if (!plan) {
            Error error = plan.error();
            error.context.set("ofAxis", write.axis);
            return fail(std::move(error));
        }
        flash.add(plan->flashOperations, plan->flashReserve);
        sequence.add(*plan);
        plans.push_back(*std::move(plan));
    }
    AXISCOMP_CHECK(flash.check(compensator, options));
    return plans;
}

std::vector<Result<WriteReport>> writeInTurn(std::span<const AxisWrite> writes,
    std::span<const WritePlan> plans,
    const std::function<Result<WriteReport>(std::size_t, const WriteRequest&)>& write)
{
    std::vector<Result<WriteReport>> reports;
    WriteSequence sequence = sequenceOf(writes);
    for (std::size_t n = 0; n < writes.size(); ++n) {
        WriteRequest request = writes[n].request;
        sequence.begin(writes[n].axis, request);
        const auto& report = reports.emplace_back(write(n, request));
        if (!holdsNewState(report))
            break;
        sequence.add(report ? report->plan : plans[n]);
    }
    return reports;
}

Error ofSeveral(Error error, std::span<const std::string> names, std::size_t failed)
{
    const bool isOpen =
        error.code == ErrorCode::OutcomeUnknown || error.code == ErrorCode::RollbackFailed;
    const auto written = names.first(failed);
    const auto notWritten = names.subspan(std::min(names.size(), failed + (isOpen ? 1 : 0)));
    error.context.set("written", std::vector(written.begin(), written.end()));
    error.context.set("notWritten", std::vector(notWritten.begin(), notWritten.end()));
    return error;
}

void FlashSum::add(int operations, int reserve)
{
    m_changes += operations > 0 ? 1 : 0;
    m_operations += operations;
    m_needed = std::max(m_needed, m_operations + reserve);
}

Result<void> FlashSum::check(AxisCompensator& compensator, const OperationOptions& options) const
{
    if (m_needed == 0)
        return {};
    auto possible = compensator.checkFlash(m_operations, m_needed - m_operations, options);
    if (!possible && possible.error().code == ErrorCode::FlashWear && m_changes > 1)
        possible.error().context.set("together", m_operations);
    return possible;
}

Result<std::vector<WritePlan>> planTables(AxisCompensator& compensator,
    std::span<const AxisTable> tables, const OperationOptions& options)
{
    OperationOptions quiet = options;
    quiet.progress = {};
    return planMultiAxis(compensator, axisWrites(tables), quiet);
}

Result<PlannedTables> planDriveRestoration(AxisCompensator& compensator, const DriveBackup& backup,
    bool force, const OperationOptions& options)
{
    AXISCOMP_TRY(auto plan, compensator.planRestore(backup, force, options));
    AXISCOMP_TRY(auto requests, compensator.restoreRequests(backup, force, options));
    std::vector<AxisBackup::File> files = filesBesides(backup, plan.axes);
    PlannedTables planned{{}, std::move(plan.axes), std::move(files)};
    for (std::size_t n = 0; n < requests.size(); ++n)
        planned.tables.push_back({backup.axes[n].axis, {}, std::move(requests[n])});
    return planned;
}

bool holdsNewState(const Result<WriteReport>& write)
{
    return write || write.error().code == ErrorCode::NothingToWrite;
}

OperationEnd<MultiAxisReport> writeTables(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int shownAxis, std::span<const AxisTable> tables,
    std::atomic<std::size_t>& turn, const OperationOptions& options,
    const std::vector<AxisBackup::File>& files)
{
    auto report = writeAll(compensator, tables, turn, options);
    if (report && !files.empty() && std::ranges::all_of(report->writes, holdsNewState))
        if (auto restored = compensator.restoreFiles(files, options); !restored)
            report->filesProblem = restored.error();
    // What the drive has afterwards is read even when the user has stopped the writes.
    OperationOptions quiet = options;
    quiet.stop = {};
    quiet.progress = {};
    return {std::move(report), readAxis(compensator, storeRoot, shownAxis, quiet)};
}

} // namespace axiscomp
