// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/known_tables.h"

#include "core/drive/axis_target.h"
#include "core/io/local_file.h"
#include "core/store/backup_json.h"
#include "core/table/position_unit.h"
#include "core/table/tam_table.h"
#include "core/write/lookup_side.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// Whether the sources of a backup are others than those of the axis: of these it has addresses.
bool hasOtherSources(const AxisBackup& backup, const AxisOfDrive& axis)
{
    for (std::size_t n = 0; n < axis.addresses.size() && n + 1 < backup.registers.size(); ++n)
        if (toDouble(backup.registers[n + 1].value) != static_cast<double>(axis.addresses[n]))
            return true;
    return false;
}

Result<void> addBackup(AxisTables& tables, const std::filesystem::path& file, const AxisOfDrive& of,
    const DriveProfile& profile, const std::string& unit)
{
    const std::string driveUnit = unitSymbol(of.axis.unit);
    AXISCOMP_TRY(const auto bytes, loadFile(file, maximumBackupSize));
    AXISCOMP_TRY(const auto backup, readBackup(asText(bytes), file.string()));
    KnownTables known;
    known.name = AXISCOMP_TEXT("Measurement", "the backup {file}")
                     .with("file", Verbatim{file.filename().string()});
    for (const AxisBackup& axis : backup.axes) {
        known.hadOtherSources = known.hadOtherSources || hasOtherSources(axis, of);
        for (const AxisBackup::File& one : axis.files) {
            if (one.bytes.empty())
                continue;
            AXISCOMP_TRY(auto table, decodeTamTable(one.bytes, profile.layout));
            AXISCOMP_TRY(const auto crc, elementCrc(table.table, profile.layout));
            table.table.unit = driveUnit;
            for (GridAxis& along : table.table.grid.axes)
                along.unit = driveUnit;
            AXISCOMP_CHECK(addTable(known, table.table, crc, unit, profile.layout, nullptr));
        }
    }
    if (!known.tables.empty())
        tables.backups.push_back(std::move(known));
    return {};
}

} // namespace

AxisOfDrive axisOfDrive(const AxisStatus& status, const DriveProfile& profile)
{
    const auto sources = sourcePaths(status.setup);
    AxisOfDrive axis{status.axis, status.drive.serialNumber,
        lookupSource(profile, status.axis.index, sources),
        lookupAtSources(profile, status.axis.index, sources), {}};
    std::ranges::transform(status.setup.sources, axis.addresses.begin(), &DimSource::address);
    return axis;
}

Result<AxisTables> tablesOfAxis(const AxisOfDrive& axis, CompensationTable table,
    const DriveProfile& profile, const DriveStore& store, const std::string& unit)
{
    AxisTables tables;
    const TextPattern name = axis.axis.name.empty()
        ? AXISCOMP_TEXT("Measurement", "the table of axis {index}")
        : AXISCOMP_TEXT("Measurement", "the table of axis {index} ({axis})");
    tables.active.name = name.with("index", axis.axis.index).with("axis", Verbatim{axis.axis.name});
    const std::string driveUnit = unitSymbol(axis.axis.unit);
    if (table.unit.empty())
        table.unit = driveUnit;
    for (GridAxis& along : table.grid.axes)
        if (along.unit.empty())
            along.unit = driveUnit;
    AXISCOMP_TRY(const auto crc, elementCrc(table, profile.layout));
    AXISCOMP_CHECK(addTable(tables.active, table, crc, unit, profile.layout, &tables.remarks));
    if (!axis.axis.name.empty()) // what an axis uses corrects that axis
        tables.active.tables.back().target = axis.axis.name;
    tables.source = axis.source;
    if (!axis.source.empty())
        tables.lookupAt = lookupAtSource(profile, axis.source);
    tables.active.hadOtherSources =
        axis.lookupAt && tables.lookupAt && axis.lookupAt != tables.lookupAt;
    for (const auto& file : store.backups(axis.serialNumber, axis.axis.index)) {
        const auto added = addBackup(tables, file, axis, profile, unit);
        if (!added)
            tables.unreadable.push_back(added.error());
    }
    return tables;
}

Result<void> checkLookupAt(LookupAt stated, const DriveProfile& profile, const std::string& source)
{
    const auto found = lookupAtSource(profile, source);
    if (!found || *found == stated)
        return {};
    const TextPattern pattern = *found == LookupAt::Encoder
        ? AXISCOMP_TEXT("Error",
            "the axis looks its table up at {source}, a position before the compensation, which is "
            "--lookup-at encoder")
        : AXISCOMP_TEXT("Error",
            "the axis looks its table up at {source}, a position after the compensation, which is "
            "--lookup-at set");
    return fail(ErrorCode::InvalidArgument, {{"reason", pattern.with("source", Verbatim{source})}});
}

} // namespace axiscomp
