// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/previous_state.h"

#include "core/axis/shown_grid.h"
#include "core/table/tam_table.h"
#include "core/write/kept_backup.h"

#include <algorithm>

namespace axiscomp {

namespace {

std::string registerText(const AxisBackup& backup, const std::string& path)
{
    const auto found = std::ranges::find(backup.registers, path, &RegisterWrite::path);
    return found == backup.registers.end() ? std::string() : toText(found->value);
}

bool sameSources(const DriveProfile& profile, const AxisBackup& backup, const AxisStatus& status)
{
    for (int n = 1; n <= 3; ++n) {
        const std::string path =
            expandPath(profile.registers.source, {.axis = backup.axis, .slot = {}, .n = n});
        const DimSource& now = status.setup.sources[static_cast<std::size_t>(n - 1)];
        if (registerText(backup, path) != toText(RegisterValue{now.address}))
            return false;
    }
    return true;
}

/// The slot may be another one: an axis uses two in turn.
bool sameTable(const DriveProfile& profile, const AxisBackup::File& file, const AxisStatus& status)
{
    if (!status.table || status.table->persistent != file.persistent)
        return false;
    const auto decoded = decodeTamTable(file.bytes, profile.layout);
    if (!decoded)
        return false;
    const std::size_t elements = decoded->table.values.size() * sizeof(float);
    return crc32(ByteView(file.bytes).last(elements)) == status.table->crc
        && isShownAs(status.table->grid, decoded->table.grid);
}

bool isCurrent(const DriveProfile& profile, const AxisBackup& backup, const AxisStatus& status)
{
    if (!sameSources(profile, backup, status))
        return false;
    const bool hasTable = !backup.files.empty() && !backup.files.front().bytes.empty();
    return hasTable ? sameTable(profile, backup.files.front(), status) : !status.table;
}

} // namespace

Result<PreviousState> previousState(
    const DriveStore& store, const DriveProfile& profile, const AxisStatus& status)
{
    const int axis = status.axis.index;
    std::optional<Error> problem;
    for (const std::filesystem::path& file : store.backups(status.drive.serialNumber, axis)) {
        auto read = axisBackupsIn(file, profile);
        if (!read) {
            problem = problem.value_or(read.error());
            continue;
        }
        for (AxisBackup& backup : *read) {
            if (backup.axis == axis && !isCurrent(profile, backup, status))
                return PreviousState{std::move(backup), file};
        }
    }
    if (problem)
        return fail(*problem);
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error", "there is no backup that differs from what the axis has now")}});
}

} // namespace axiscomp
