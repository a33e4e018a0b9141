// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine_tables.h"

#include "core/base/parallel.h"
#include "core/conversion/table_choice.h"
#include "core/conversion/table_import.h"
#include "core/io/local_file.h"
#include "core/neutral/drive_note.h"
#include "core/neutral/lookup_note.h"

#include <algorithm>
#include <span>
#include <utility>

namespace axiscomp {

namespace {

/// Of the file itself, whose diagnostics stand beside it.
Error fileError(const std::filesystem::path& file, const TableImport& import)
{
    const auto errors = std::ranges::count(import.problems, Severity::Error, &Diagnostic::severity);
    return {ErrorCode::InvalidCalibration,
        {{"file", Verbatim{file.string()}},
            {"count", static_cast<std::size_t>(errors) + import.suppressedProblems}},
        {}};
}

/// By the name that it gets on the drive, else by that of the file; without one the only table.
Result<std::size_t> chosenTable(const MachineAxis& axis, std::span<const TableName> tables)
{
    if (axis.column.empty() && tables.size() == 1)
        return std::size_t{0};
    if (axis.column.empty())
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT(
                    "Error", "{file} has several tables; name one of them with column: {known}")
                    .with("file", axis.file)
                    .with("known", tableList(tables))}});
    return chooseTable(tables, axis.column);
}

} // namespace

MachineTable readMachineTable(const MachineAxis& axis, const std::filesystem::path& folder,
    const TableLayout& layout, const std::optional<AxisPlace>& place, const std::stop_token& stop)
{
    MachineTable result;
    if (axis.file.empty())
        return result;
    result.file = folder / pathFromText(axis.file);
    TableImportRequest request;
    request.file = result.file;
    request.dimensions = axis.sources ? static_cast<int>(axis.sources->size()) : 1;
    request.choices = axis.choices;
    request.choices.place = place.value_or(AxisPlace{});
    request.layout = &layout;
    request.stop = stop;
    request.choose = [&axis](
                         std::span<const TableName> tables) { return chosenTable(axis, tables); };
    TableImport import = importTables(request);
    result.problems = std::move(import.problems);
    if (import.isCancelled) {
        result.problem = Error{ErrorCode::Cancelled, {}, {}};
    } else if (import.refusal) {
        result.isOpen = !place && dependsOnPlace(*import.refusal);
        result.problem = std::move(import.refusal);
    } else if (!import.data) {
        import.problems = result.problems;
        result.problem = fileError(result.file, import);
    } else if (const auto lookupAt = lookupInNotes(import.data->notes); !lookupAt) {
        result.problem = lookupAt.error();
    } else if (const auto measured = measuredDriveInNotes(import.data->notes); !measured) {
        result.problem = measured.error();
    } else if (!place && import.usedPlace.lookupAt) {
        result.isOpen = true;
    } else {
        result.table = import.data->tables.front();
        result.lookupAt = *lookupAt;
        result.measuredDrive = *measured;
        result.report = std::move(import.report);
    }
    return result;
}

std::vector<std::vector<MachineTable>> readMachineTables(const MachineFile& machine,
    const std::filesystem::path& folder, const TableLayout& layout, const std::stop_token& stop)
{
    std::vector<std::vector<MachineTable>> tables;
    std::vector<std::pair<std::size_t, std::size_t>> places; // drive and axis
    for (const MachineDrive& drive : machine.drives) {
        for (std::size_t axis = 0; axis < drive.axes.size(); ++axis)
            places.emplace_back(tables.size(), axis);
        tables.emplace_back(drive.axes.size());
    }
    forEachAtOnce(places.size(), processorCount(), [&](std::size_t index) {
        const auto [drive, axis] = places[index];
        tables[drive][axis] =
            readMachineTable(machine.drives[drive].axes[axis], folder, layout, {}, stop);
    });
    return tables;
}

} // namespace axiscomp
