// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/known_tables.h"

#include "core/drive/axis_target.h"
#include "core/io/local_file.h"
#include "core/store/backup_json.h"
#include "core/table/position_unit.h"
#include "core/table/tam_table.h"
#include "core/write/backup_restore.h"
#include "core/write/lookup_side.h"

namespace axiscomp {

namespace {

/// Whether the sources of a backup are others than those of the axis: by their paths, since another
/// version of the firmware may have others at the same addresses.
bool hasOtherSources(const AxisBackup& backup, const AxisOfDrive& axis)
{
    for (std::size_t n = 0; n < axis.sources.size() && n + 1 < backup.registers.size(); ++n) {
        const DimSource& now = axis.sources[n];
        const std::string kept = sourcePath(backup, static_cast<int>(n) + 1);
        const bool isOther = kept.empty() || now.path.empty()
            ? toDouble(backup.registers[n + 1].value) != static_cast<double>(now.address)
            : kept != now.path;
        if (isOther)
            return true;
    }
    return false;
}

/// In which the positions of a source are: those of the axis, where neither its own unit is known
/// nor that it is no position at all.
std::string positionsUnit(const AxisOfDrive& axis, const DriveProfile& profile,
    const std::string& known, const std::string& source)
{
    if (auto symbol = unitSymbol(known); !symbol.empty())
        return symbol;
    if (profile.isTemperature(source))
        return "degC";
    const bool isPosition = source.empty() || profile.axisOfPosition(source);
    return isPosition ? unitSymbol(axis.axis.unit) : std::string();
}

/// The numbers of a backup stay what they were, also where the axis has another unit by now.
void stateUnits(CompensationTable& table, const AxisBackup& backup, const AxisOfDrive& axis,
    const DriveProfile& profile)
{
    const std::string kept = unitSymbol(backup.unit);
    table.unit = kept.empty() ? unitSymbol(axis.axis.unit) : kept;
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n) {
        const std::string path = sourcePath(backup, static_cast<int>(n) + 1);
        const std::string known =
            n < backup.sourceUnits.size() ? backup.sourceUnits[n] : std::string();
        table.grid.axes[n].unit = positionsUnit(axis, profile, known, path);
    }
}

Result<void> addBackup(AxisTables& tables, const std::filesystem::path& file, const AxisOfDrive& of,
    const DriveProfile& profile, const std::string& unit)
{
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
            stateUnits(table.table, axis, of, profile);
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
    return AxisOfDrive{status.axis, status.drive.serialNumber,
        lookupSource(profile, status.axis.index, sources),
        lookupAtSources(profile, status.axis.index, sources), status.setup.sources};
}

Result<AxisTables> tablesOfAxis(const AxisOfDrive& axis, CompensationTable table,
    const DriveProfile& profile, const DriveStore& store, const std::string& unit)
{
    AxisTables tables;
    const TextPattern name = axis.axis.name.empty()
        ? AXISCOMP_TEXT("Measurement", "the table of axis {index}")
        : AXISCOMP_TEXT("Measurement", "the table of axis {index} ({axis})");
    tables.active.name = name.with("index", axis.axis.index).with("axis", Verbatim{axis.axis.name});
    if (table.unit.empty())
        table.unit = unitSymbol(axis.axis.unit);
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n) {
        std::string& positions = table.grid.axes[n].unit;
        if (positions.empty())
            positions = positionsUnit(axis, profile, {}, axis.sources.at(n).path);
    }
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
