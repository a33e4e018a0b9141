// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/drive_record.h"

#include "core/drive/axis_target.h"
#include "core/metrology/fit/known_tables.h"
#include "core/neutral/drive_note.h"
#include "core/store/backup_json.h"
#include "core/table/position_unit.h"
#include "core/table/table_units.h"
#include "core/table/tam_table.h"
#include "core/write/lookup_side.h"

#include <algorithm>
#include <array>
#include <utility>

namespace axiscomp {

namespace {

auto notOfRecord(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

/// "axis 0 (X) of Virtual-1 (serial number 100001)"
Text axisText(int index, const std::string& name, const std::string& drive, std::int32_t serial)
{
    const TextPattern pattern = name.empty()
        ? AXISCOMP_TEXT("Error", "axis {index} of {drive} (serial number {serial})")
        : AXISCOMP_TEXT("Error", "axis {index} ({name}) of {drive} (serial number {serial})");
    return pattern.with("index", index)
        .with("name", name)
        .with("drive", drive)
        .with("serial", Verbatim{std::to_string(serial)});
}

/// checkMeasuredDrive, with the way out of a record.
Result<void> checkDriveOfRecord(const CalibrationRecord& record, const AxisStatus& status)
{
    const auto measured = record.before ? statedDrive(*record.before) : std::nullopt;
    if (checkMeasuredDrive(measured, status.drive.serialNumber))
        return {};
    return notOfRecord(AXISCOMP_TEXT("Error",
        "the record was made of a measurement of the drive with the serial number {measured}, and "
        "this is {found}; connect the drive that was measured, or, where it was replaced since, "
        "correct the line // drive: of the measurement's file and begin a new record with it")
                           .with("measured", Verbatim{std::to_string(*measured)})
                           .with("found",
                               axisText(status.axis.index, status.axis.name, status.drive.name,
                                   status.drive.serialNumber)));
}

std::optional<LookupAt> statedLookupAt(const CalibrationRecord& record)
{
    return record.fit ? record.fit->settings.lookupAt : std::nullopt;
}

/// A source may have been changed since the write, and the table left as it is. made: nothing where
/// it is not stated.
Result<void> checkLookup(std::optional<LookupAt> made, std::span<const RecordedTable> tables,
    const AxisStatus& status, const DriveProfile& profile)
{
    const auto sources = sourcePaths(status.setup);
    if (made)
        AXISCOMP_CHECK(checkLookupSources(*made, profile, status.axis.index, sources));
    // Of several tables the record does not say which was written.
    Result<void> fits;
    for (const RecordedTable& recorded : tables) {
        fits = checkTarget(profile, status.axis.index, sources, recorded.table);
        if (fits)
            break;
    }
    return fits;
}

bool hasCrc(const RecordedTable& recorded, std::uint32_t crc, const TableLayout& layout)
{
    if (recorded.crc == crc)
        return true;
    const CompensationTable& table = recorded.table;
    const auto asItIs = elementCrc(table, layout);
    const auto inMeters = crcInMeters(table, table.unit, layout);
    return (asItIs && *asItIs == crc) || (inMeters && *inMeters == crc);
}

/// As they are, or as a drive shows them whose axis is in metres or radians.
bool arePositionsOf(const GridAxis& recorded, const GridAxis& found)
{
    if (areSamePositions(recorded, found))
        return true;
    return std::ranges::any_of(std::array{"m", "rad"}, [&](const char* unit) {
        const auto factor = unitFactor(recorded.unit, unit);
        if (!factor)
            return false;
        GridAxis converted = recorded;
        converted.start *= *factor;
        converted.distance *= *factor;
        return areSamePositions(converted, found);
    });
}

/// The same values may lie over other positions.
bool isRecordedTable(
    const RecordedTable& recorded, const TableIdentity& found, const TableLayout& layout)
{
    return hasCrc(recorded, found.crc, layout)
        && (!found.grid
            || std::ranges::equal(recorded.table.grid.axes, found.grid->axes, arePositionsOf));
}

KeptMeaning meaningOf(const AxisStatus& status)
{
    return {unitsOfTable(status), status.axis.name};
}

/// Nothing where the drive does not say any.
std::optional<TableUnits> unitsToNote(TableUnits units)
{
    const bool isKnown = !units.values.empty()
        || std::ranges::any_of(
            units.positions, [](const std::string& unit) { return !unit.empty(); });
    if (!isKnown)
        return std::nullopt;
    units.values = symbolOrWord(units.values);
    for (std::string& unit : units.positions)
        unit = symbolOrWord(unit);
    return units;
}

/// Whether one of the record's tables, in the units of the axis as it is now, is the one that was
/// written.
bool isWrittenIn(const TableUnits& now, const CalibrationRecord& record, const AxisStatus& status,
    const DriveProfile& profile)
{
    const auto own = ownDimension(profile, status.axis.index, sourcePaths(status.setup));
    return std::ranges::any_of(record.tables, [&](const RecordedTable& recorded) {
        const auto converted = inUnitsOfAxis(recorded.table, now, own);
        if (!converted)
            return false;
        const auto crc = elementCrc(converted->table, profile.layout);
        return crc
            && isSameTable(TableIdentity{*crc, converted->table.grid}, record.write->table());
    });
}

/// The same numbers may have come to mean something else.
Result<void> checkRecordUnits(
    const CalibrationRecord& record, const AxisStatus& status, const DriveProfile& profile)
{
    const TableUnits now = unitsOfTable(status);
    if (!record.write->units) {
        if (now.values.empty() || isWrittenIn(now, record, status, profile))
            return {};
        return notOfRecord(AXISCOMP_TEXT("Error",
            "the record does not say in which unit the axis was when its table was written, and in "
            "{unit}, as the axis is now, none of its tables is the one on the drive: set the unit "
            "that the axis had, or write the record's table again (`axiscomp write --record`)")
                               .with("unit", symbolOrWord(now.values)));
    }
    const auto change = changedMeaning({*record.write->units, {}}, meaningOf(status)).unit;
    if (!change)
        return {};
    const Text what = change->dimension ? AXISCOMP_TEXT("Error", "positions of dimension {number}")
                                              .with("number", *change->dimension + 1)
                                        : Text(AXISCOMP_TEXT("Error", "values"));
    return fail(ErrorCode::UnitMismatch,
        {{"what", what}, {"unit", change->before}, {"other", unitNow(*change)},
            {"recorded", Verbatim{"table"}}});
}

Grid spansOf(Grid grid)
{
    for (GridAxis& axis : grid.axes) {
        axis.name.clear();
        axis.unit.clear();
    }
    return grid;
}

} // namespace

Result<void> checkRecordAxis(const CalibrationRecord& record, const AxisStatus& status)
{
    AXISCOMP_CHECK(checkDriveOfRecord(record, status));
    if (!record.drive
        || (record.drive->serialNumber == status.drive.serialNumber
            && record.drive->axis == status.axis.index
            && !changedMeaning({{}, record.drive->axisName}, meaningOf(status)).isOtherAxis))
        return {};
    return notOfRecord(AXISCOMP_TEXT(
        "Error", "the record is of {recorded}, and this is {found}; begin a record for each axis")
                           .with("recorded",
                               axisText(record.drive->axis, record.drive->axisName,
                                   record.drive->name, record.drive->serialNumber))
                           .with("found",
                               axisText(status.axis.index, status.axis.name, status.drive.name,
                                   status.drive.serialNumber)));
}

bool hasTable(
    const CalibrationRecord& record, const TableIdentity& found, const TableLayout& layout)
{
    return std::ranges::any_of(record.tables,
        [&](const RecordedTable& recorded) { return isRecordedTable(recorded, found, layout); });
}

Result<void> checkRecordSources(const CalibrationRecord& record, const DriveProfile& profile,
    int axis, std::span<const std::string> sources)
{
    const auto made = statedLookupAt(record);
    return made ? checkLookupSources(*made, profile, axis, sources) : Result<void>();
}

Result<void> recordWrite(
    CalibrationRecord& record, const AxisStatus& now, const std::string& profileName, WallTime time)
{
    AXISCOMP_CHECK(checkRecordAxis(record, now));
    if (!now.table)
        return fail(ErrorCode::NoTable, {{"axis", std::to_string(now.axis.index)}});
    if (!record.drive) {
        record.drive = RecordedDrive{
            now.drive.name, now.drive.serialNumber, profileName, now.axis.index, now.axis.name};
        if (record.before && !record.before->files.empty())
            record.drive->state = record.before->files.front().measurement.header.compensation;
    }
    RecordedWrite write;
    if (record.write)
        write.others = std::move(record.write->others);
    write.time = time;
    write.slot = now.setup.slot;
    write.isPersistent = now.table->persistent;
    write.crc = now.table->crc;
    if (auto known = identityOf(*now.table); known.grid)
        write.grid = spansOf(*std::move(known.grid));
    write.units = unitsToNote(unitsOfTable(now));
    record.write = std::move(write);
    return {};
}

Result<void> checkRecordTable(
    const CalibrationRecord& record, const AxisStatus& status, const DriveProfile& profile)
{
    AXISCOMP_CHECK(checkRecordAxis(record, status));
    if (!record.write)
        return notOfRecord(AXISCOMP_TEXT("Error",
            "the record does not say that its table was written: `axiscomp write --record` writes "
            "it and notes that"));
    if (!status.table)
        return fail(ErrorCode::NoTable, {{"axis", std::to_string(status.axis.index)}});
    const TableIdentity found = identityOf(*status.table);
    if (isSameTable(found, record.write->table())) {
        AXISCOMP_CHECK(checkRecordUnits(record, status, profile));
        return checkLookup(statedLookupAt(record), record.tables, status, profile);
    }
    if (found.crc == record.write->crc)
        return notOfRecord(AXISCOMP_TEXT("Error",
            "the axis has the values of the record's table, {crc}, over other positions: write the "
            "record's table again (`axiscomp write --record`), or leave the record out")
                               .with("crc", crcText(found.crc)));
    return notOfRecord(AXISCOMP_TEXT("Error",
        "the axis has the table {found}, and that of the record is {recorded}: write the record's "
        "table again (`axiscomp write --record`), or leave the record out")
                           .with("found", crcText(found.crc))
                           .with("recorded", crcText(record.write->crc)));
}

bool isLookedUpAsMade(
    const MadeForLookup& made, const AxisStatus& status, const DriveProfile& profile)
{
    std::vector<RecordedTable> tables;
    for (const std::string& target : made.targets) {
        CompensationTable& table = tables.emplace_back().table;
        table.target = target;
        table.grid.axes.resize(status.setup.sources.size());
    }
    return checkLookup(made.at, tables, status, profile).has_value();
}

bool isMeantAsKept(const MeasuredFigures& kept, const AxisStatus& status)
{
    return isMeantAsKept(kept.meaning(), meaningOf(status));
}

Result<void> recordProof(CalibrationRecord& record, const AxisStatus& now, const Proof& proof,
    const DriveProfile& profile)
{
    AXISCOMP_CHECK(checkRecordTable(record, now, profile));
    if (proof.extent != Proof::Extent::Proved)
        return {};
    record.write->proof = RecordedWrite::Proof{true, static_cast<int>(proof.samples.size()),
        proof.largestDifference, proof.tolerance, proof.provedShare};
    return {};
}

} // namespace axiscomp
