// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/drive_summary.h"

#include "core/compensator/axis_compensator.h"
#include "core/compensator/drive_record.h"
#include "core/store/backup_folder.h"

namespace axiscomp {

namespace {

bool endsSummary(const Error& error)
{
    return isLinkFailure(error.code) || error.code == ErrorCode::Cancelled;
}

std::optional<WallTime> lastWriteOf(const DriveStore& store, std::int32_t serialNumber, int axis)
{
    const auto backups = store.backups(serialNumber, axis);
    return backups.empty() ? std::nullopt : timeOfBackup(backups.front(), axis);
}

} // namespace

std::optional<MeasuredFigures> measuredWith(
    const AxisStatus& status, const DriveProfile& profile, const std::filesystem::path& storeRoot)
{
    if (!status.table)
        return std::nullopt;
    auto known = DriveStore(storeRoot).measured(
        status.drive.serialNumber, status.axis.index, status.table->crc);
    if (!known || !*known || !isSameTable(identityOf(*status.table), (*known)->table())
        || !isLookedUpAsMade((*known)->madeFor, status, profile) || !isMeantAsKept(**known, status))
        return std::nullopt;
    return *std::move(known);
}

Result<void> readAxes(
    AxisCompensator& compensator, const OperationOptions& options, std::vector<AxisSummary>& rows)
{
    OperationOptions quiet = options;
    quiet.progress = {};
    AXISCOMP_TRY(auto axes, compensator.axes(quiet));
    for (AxisInfo& axis : axes) {
        AxisSummary row{.axis = std::move(axis)};
        if (row.axis.hasCompensation()) {
            auto status = compensator.status(row.axis.index, quiet);
            if (!status && endsSummary(status.error()))
                return fail(std::move(status).error());
            if (status) {
                row.axis = status->axis;
                row.status = *std::move(status);
            } else {
                row.problem = std::move(status).error();
            }
        }
        rows.push_back(std::move(row));
    }
    return {};
}

Result<DriveSummary> summarizeDrive(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const OperationOptions& options)
{
    OperationOptions quiet = options;
    quiet.progress = {};
    DriveSummary summary;
    AXISCOMP_TRY(summary.drive, compensator.identify(quiet));
    AXISCOMP_CHECK(readAxes(compensator, quiet, summary.axes));
    const DriveStore store(storeRoot);
    for (AxisSummary& row : summary.axes) {
        row.lastWrite = lastWriteOf(store, summary.drive.serialNumber, row.axis.index);
        if (row.status)
            row.measured = measuredWith(*row.status, compensator.profile(), storeRoot);
    }
    auto use = compensator.flashUse(quiet);
    if (!use && endsSummary(use.error()))
        return fail(std::move(use).error());
    if (use)
        summary.flashUse = *std::move(use);
    return summary;
}

} // namespace axiscomp
