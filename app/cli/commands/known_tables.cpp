// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/known_tables.h"

#include "app/cli/input/conversion_options.h"
#include "app/cli/output/status_text.h"
#include "app/common/number_text.h"
#include "core/compensator/drive_record.h"
#include "core/drive/axis_target.h"
#include "core/io/local_file.h"
#include "core/store/drive_store.h"
#include "core/table/position_unit.h"
#include "core/table/table_units.h"
#include "core/table/tam_table.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

/// A table with its CRC as the drive has it, in the unit of the measurement.
Result<void> addTable(KnownTables& known, CompensationTable table, std::uint32_t crc,
    const std::string& unit, Environment* environment)
{
    TableUnits units{unit, std::vector<std::string>(table.grid.axes.size(), unit)};
    for (std::size_t n = 0; n < units.positions.size(); ++n)
        if (!table.grid.axes[n].unit.empty() && !isPositionUnit(table.grid.axes[n].unit))
            units.positions[n].clear();
    AXISCOMP_TRY(auto converted, inDriveUnits(table, units));
    if (environment)
        for (const Text& remark : converted.remarks)
            environment->console().note("note: " + remark.english());
    known.tables.push_back(std::move(converted.table));
    known.crcs.push_back(crc);
    return {};
}

Result<void> addBackup(AxisTables& tables, const std::filesystem::path& file,
    const DriveProfile& profile, const std::string& driveUnit, const std::string& unit)
{
    AXISCOMP_TRY(const auto bytes, loadFile(file, maximumBackupSize));
    AXISCOMP_TRY(const auto backup, readBackup(asText(bytes), file.string()));
    KnownTables known;
    known.name = Verbatim{"the backup " + file.filename().string()};
    for (const AxisBackup& axis : backup.axes) {
        for (const AxisBackup::File& one : axis.files) {
            if (one.bytes.empty())
                continue;
            AXISCOMP_TRY(auto table, decodeTamTable(one.bytes, profile.layout));
            AXISCOMP_TRY(const auto crc, elementCrc(table.table, profile.layout));
            table.table.unit = driveUnit;
            for (GridAxis& along : table.table.grid.axes)
                along.unit = driveUnit;
            AXISCOMP_CHECK(addTable(known, std::move(table.table), crc, unit, nullptr));
        }
    }
    if (!known.tables.empty())
        tables.backups.push_back(std::move(known));
    return {};
}

} // namespace

Result<KnownTables> tablesOfFile(
    Environment& environment, const TableInputOptions& options, const std::string& unit)
{
    AXISCOMP_TRY(const auto profile, profileOf(options.profile));
    AXISCOMP_TRY(const auto input, readInput(environment, options));
    std::vector<CompensationTable> tables;
    if (input.data) {
        tables = input.data->tables;
    } else {
        AXISCOMP_TRY(auto table, driveTable(environment, input, options, {}));
        tables.push_back(std::move(table));
    }
    KnownTables known;
    known.name = Verbatim{displayName(options.file)};
    for (CompensationTable& table : tables) {
        // As a drive has it, whose unit is that of the measurement.
        AXISCOMP_CHECK(addTable(known, std::move(table), 0, unit, &environment));
        AXISCOMP_TRY(known.crcs.back(), elementCrc(known.tables.back(), profile.layout));
    }
    return known;
}

Result<AxisTables> tablesOfAxis(
    Environment& environment, CommandSession& session, int axis, const std::string& unit)
{
    AXISCOMP_TRY(const auto settled, settledStatus(environment, session, axis));
    const AxisStatus& status = settled.status;
    AXISCOMP_TRY(auto table, session.compensator().readTable(axis, session.operation()));
    AxisTables tables;
    tables.active.name = Verbatim{"the table of " + axisWords(status.axis)};
    const std::string driveUnit = unitSymbol(status.axis.unit);
    if (table.unit.empty())
        table.unit = driveUnit;
    for (GridAxis& along : table.grid.axes)
        if (along.unit.empty())
            along.unit = driveUnit;
    AXISCOMP_TRY(const auto crc, elementCrc(table, session.profile().layout));
    AXISCOMP_CHECK(addTable(tables.active, std::move(table), crc, unit, &environment));
    const auto sources = sourcePaths(status.setup);
    if (!sources.empty()) {
        tables.source = sources.front();
        tables.lookupAt = lookupAtSource(session.profile(), tables.source);
    }
    const DriveStore store(session.storeRoot());
    for (const auto& file : store.backups(status.drive.serialNumber, axis)) {
        const auto added = addBackup(tables, file, session.profile(), driveUnit, unit);
        if (!added)
            environment.warn(sentence(added.error()));
    }
    return tables;
}

} // namespace axiscomp::app
