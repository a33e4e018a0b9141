// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/multi_axis_write.h"

#include "core/compensator/several_writes.h"

namespace axiscomp {

namespace {

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

Result<SeveralReport> writeAll(AxisCompensator& compensator, std::span<const AxisTable> tables,
    std::atomic<std::size_t>& turn, const OperationOptions& options)
{
    const std::vector<AxisWrite> writes = axisWrites(tables);
    if (const auto plans = planSeveral(compensator, writes, options); !plans)
        return fail(plans.error());
    SeveralReport report;
    for (std::size_t n = 0; n < writes.size(); ++n) {
        turn = n;
        OperationOptions part = options;
        part.progress = [&](const Progress& progress) {
            if (options.progress)
                options.progress({progress.step,
                    (static_cast<double>(n) + progress.fraction)
                        / static_cast<double>(writes.size())});
        };
        report.writes.push_back(compensator.write(writes[n].axis, writes[n].request, part));
        if (!holdsNewState(report.writes.back()))
            break;
    }
    return report;
}

} // namespace

Result<std::vector<WritePlan>> planTables(AxisCompensator& compensator,
    std::span<const AxisTable> tables, const OperationOptions& options)
{
    OperationOptions quiet = options;
    quiet.progress = {};
    return planSeveral(compensator, axisWrites(tables), quiet);
}

bool holdsNewState(const Result<WriteReport>& write)
{
    return write || write.error().code == ErrorCode::NothingToWrite;
}

OperationEnd<SeveralReport> writeTables(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int shownAxis, std::span<const AxisTable> tables,
    std::atomic<std::size_t>& turn, const OperationOptions& options)
{
    auto report = writeAll(compensator, tables, turn, options);
    // What the drive has afterwards is read even when the user has stopped the writes.
    OperationOptions quiet = options;
    quiet.stop = {};
    quiet.progress = {};
    return {std::move(report), readAxis(compensator, storeRoot, shownAxis, quiet)};
}

} // namespace axiscomp
