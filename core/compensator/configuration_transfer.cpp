// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/configuration_transfer.h"

#include "core/base/bytes.h"
#include "core/compensator/axis_operations.h"
#include "core/table/tam_table.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>

namespace axiscomp {

namespace {

AxisParameters parametersOf(const AxisStatus& status)
{
    AxisParameters axis;
    axis.axis = status.axis.index;
    axis.unit = status.axis.unit;
    axis.slot = status.setup.slot;
    for (std::size_t n = 0; n < axis.sources.size(); ++n)
        axis.sources[n] = status.setup.sources[n].address;
    return axis;
}

/// As WriteRequest::sources has them; "" where none is set.
std::vector<std::string> sourcesOf(const AxisParameters& axis)
{
    std::vector<std::string> sources;
    for (const std::uint32_t address : axis.sources) {
        char digits[8];
        const auto end = std::to_chars(digits, digits + sizeof(digits), address, 16).ptr;
        sources.push_back(address == 0 ? "" : "0x" + std::string(digits, end));
    }
    return sources;
}

/// The table that the axis shall have, which is on the drive.
Result<TamTable> tableFor(AxisCompensator& compensator, const DriveProfile& profile,
    const AxisParameters& axis, const OperationOptions& options)
{
    const auto missing = fail(ErrorCode::NoTable,
        {{"axis", axis.axis}, {"slot", axis.slot}, {"configured", Verbatim{axis.slot}}});
    const TableSlot* slot = profile.slotNamed(axis.slot);
    if (!slot)
        return missing;
    auto bytes = compensator.download(slot->file, options);
    if (!bytes && bytes.error().code != ErrorCode::UnknownFile)
        return fail(bytes.error());
    if (!bytes || bytes->empty())
        return missing;
    return decodeTamTable(*bytes, profile.layout);
}

Result<AxisWrite> writeOf(AxisCompensator& compensator, const DriveProfile& profile,
    const AxisParameters& axis, const AxisStatus& status, const OperationOptions& options)
{
    AxisWrite write;
    write.axis = axis.axis;
    WriteRequest& request = write.request;
    request.expected = PlannedState{status.setup};
    request.expectedDrive = status.drive.serialNumber;
    request.sources = sourcesOf(axis);
    if (axis.slot.empty()) {
        request.withoutTable = true;
        request.dimensionality = static_cast<int>(request.sources.size());
        return write;
    }
    AXISCOMP_TRY(auto decoded, tableFor(compensator, profile, axis, options));
    request.dimensionality = decoded.table.grid.dimensions();
    while (static_cast<int>(request.sources.size()) > request.dimensionality
        && request.sources.back().empty())
        request.sources.pop_back();
    const auto gap = std::ranges::find(request.sources, std::string());
    if (gap != request.sources.end())
        return fail(ErrorCode::SourceMissing,
            {{"dimension", gap - request.sources.begin() + 1}, {"ofAxis", axis.axis}});
    request.table = std::move(decoded.table);
    request.origin = axis.slot == status.setup.slot ? TableOrigin::InUse : TableOrigin::Drive;
    request.slot = axis.slot;
    request.persistency = decoded.persistent ? Persistency::Persistent : Persistency::Volatile;
    request.acceptsLarge = true; // the drive has it
    return write;
}

} // namespace

Result<CompensationParameters> driveParameters(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const OperationOptions& options)
{
    AXISCOMP_TRY(const auto drive, compensator.identify(options));
    CompensationParameters parameters{drive.name, drive.serialNumber, {}};
    for (int axis = 0; axis < drive.axes; ++axis) {
        auto status = wholeStatus(compensator, storeRoot, axis, options);
        if (!status && status.error().code == ErrorCode::NoCompensation)
            continue;
        if (!status)
            return fail(status.error());
        parameters.axes.push_back(parametersOf(*status));
    }
    return parameters;
}

Result<std::vector<AxisWrite>> parameterWrites(AxisCompensator& compensator,
    const DriveProfile& profile, const CompensationParameters& parameters,
    const OperationOptions& options)
{
    std::vector<AxisWrite> writes;
    for (const AxisParameters& axis : parameters.axes) {
        AXISCOMP_TRY(const auto status, compensator.status(axis.axis, options));
        const AxisParameters now = parametersOf(status);
        if (!axis.unit.empty() && axis.unit != now.unit)
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the configuration has {unit} for axis {axis}, but the axis of the drive "
                        "has {other}")
                        .with("unit", axis.unit)
                        .with("axis", axis.axis)
                        .with("other", now.unit)}});
        if (axis.slot == now.slot && axis.sources == now.sources)
            continue;
        AXISCOMP_TRY(auto write, writeOf(compensator, profile, axis, status, options));
        writes.push_back(std::move(write));
    }
    return writes;
}

Result<PlannedTables> planImport(AxisCompensator& compensator, const DriveProfile& profile,
    const TamConfiguration& configuration, std::size_t station, bool force,
    const OperationOptions& options)
{
    const TamStation& from = configuration.stations.at(station);
    AXISCOMP_TRY(const auto drive, compensator.identify(options));
    if (!force)
        AXISCOMP_CHECK(checkStationOfDrive(from, drive.serialNumber));
    AXISCOMP_TRY(const auto parameters, stationParameters(from, profile, configuration.fileName));
    OperationOptions quiet = options;
    quiet.progress = {};
    AXISCOMP_TRY(auto writes, parameterWrites(compensator, profile, parameters, quiet));
    PlannedTables planned;
    for (AxisWrite& write : writes) {
        LoadedTable table;
        if (write.request.table)
            table =
                loaded(std::make_shared<const CompensationTable>(*std::move(write.request.table)));
        write.request.table.reset();
        planned.tables.push_back({write.axis, std::move(table), std::move(write.request)});
    }
    AXISCOMP_TRY(planned.plans, planTables(compensator, planned.tables, quiet));
    return planned;
}

} // namespace axiscomp
