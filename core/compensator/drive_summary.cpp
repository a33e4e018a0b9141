// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/drive_summary.h"

#include "core/compensator/axis_compensator.h"
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
    const AxisStatus& status, const std::filesystem::path& storeRoot)
{
    if (!status.table)
        return std::nullopt;
    auto known = DriveStore(storeRoot).measured(
        status.drive.serialNumber, status.axis.index, status.table->crc);
    return known ? *std::move(known) : std::nullopt;
}

Result<DriveSummary> summarizeDrive(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const OperationOptions& options)
{
    OperationOptions quiet = options;
    quiet.progress = {};
    DriveSummary summary;
    AXISCOMP_TRY(summary.drive, compensator.identify(quiet));
    AXISCOMP_TRY(auto axes, compensator.axes(quiet));
    const DriveStore store(storeRoot);
    for (AxisInfo& axis : axes) {
        AxisSummary& row = summary.axes.emplace_back();
        row.axis = std::move(axis);
        row.lastWrite = lastWriteOf(store, summary.drive.serialNumber, row.axis.index);
        if (!row.axis.hasCompensation())
            continue;
        auto status = compensator.status(row.axis.index, quiet);
        if (!status && endsSummary(status.error()))
            return fail(std::move(status).error());
        if (status) {
            row.axis = status->axis;
            row.measured = measuredWith(*status, storeRoot);
            row.status = *std::move(status);
        } else {
            row.problem = std::move(status).error();
        }
    }
    auto use = compensator.flashUse(quiet);
    if (!use && endsSummary(use.error()))
        return fail(std::move(use).error());
    if (use)
        summary.flashUse = *std::move(use);
    return summary;
}

} // namespace axiscomp
