// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/snapshot.h"

#include "core/compensator/axis_naming.h"
#include "core/compensator/axis_operations.h"
#include "core/compensator/table_of_axis.h"
#include "core/csv/calibration_csv.h"
#include "core/drive/axis_target.h"
#include "core/formats/formats.h"
#include "core/io/local_file.h"
#include "core/store/backup_json.h"
#include "core/table/large_correction.h"
#include "core/table/table_units.h"
#include "core/table/tam_table.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <span>
#include <system_error>
#include <utility>

namespace axiscomp {

namespace {

/// "" where none is set, up to the last that is.
std::vector<std::string> sourcesOf(const CompensationSetup& setup)
{
    std::vector<std::string> sources;
    for (const DimSource& source : setup.sources)
        sources.push_back(source.isSet() ? sourceName(source) : std::string());
    while (!sources.empty() && sources.back().empty())
        sources.pop_back();
    return sources;
}

bool isSameTable(const CompensationTable& a, const CompensationTable& b)
{
    return sameSpans(a.grid, b.grid) && a.values.size() == b.values.size()
        && std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

/// Nothing where a calibration file does not give every bit back.
std::optional<std::string> csvText(const CompensationTable& table, std::vector<std::string> notes)
{
    std::string text = writeCalibrationCsv({table.grid, {table}, std::move(notes)});
    CsvOptions options;
    options.dimensions = table.grid.dimensions();
    const CsvReading reading = parseCalibrationCsv(text, options);
    if (!reading.data || !isSameTable(reading.data->tables.front(), table))
        return std::nullopt;
    return text;
}

/// Why there is no machine file of them: the name, which a person has given, or the drives.
Error noMachine(MachineFile machine, const Diagnostic& problem)
{
    const std::string name = std::exchange(machine.name, {});
    const bool isName = readMachine(writeMachine(machine)).machine.has_value();
    return {ErrorCode::InvalidArgument,
        {{"reason",
            isName ? AXISCOMP_TEXT(
                "Error", "a machine cannot be called {name}: a name has no control characters")
                         .with("name", Verbatim{shownText(name)})
                   : AXISCOMP_TEXT("Error", "these drives make no machine: {problem}")
                         .with("problem", textOf(problem))}},
        {}};
}

class Snapshot {
public:
    Snapshot(AxisCompensator& compensator, const DriveProfile& profile,
        const std::filesystem::path& storeRoot, const OperationOptions& options)
        : m_compensator(compensator)
        , m_profile(profile)
        , m_storeRoot(storeRoot)
        , m_options(options)
    {
        m_options.progress = {};
    }

    [[nodiscard]] Result<DriveSnapshot> take(const std::string& endpoint)
    {
        AXISCOMP_TRY(const auto drive, m_compensator.identify(m_options));
        AXISCOMP_TRY(m_axes, m_compensator.axes(m_options));
        m_result.drive.endpoint = endpoint;
        m_result.drive.serialNumber = drive.serialNumber;
        for (const AxisInfo& axis : m_axes)
            if (axis.hasCompensation())
                AXISCOMP_CHECK(takeAxis(axis.index));
        return std::move(m_result);
    }

private:
    [[nodiscard]] Result<void> takeAxis(int index);
    [[nodiscard]] Result<void> takeTable(const AxisStatus& status, MachineAxis& axis);

    AxisCompensator& m_compensator;
    const DriveProfile& m_profile;
    const std::filesystem::path& m_storeRoot;
    OperationOptions m_options;
    std::vector<AxisInfo> m_axes;
    DriveSnapshot m_result;
};

Result<void> Snapshot::takeAxis(int index)
{
    AXISCOMP_TRY(const auto status, wholeStatus(m_compensator, m_storeRoot, index, m_options));
    MachineAxis axis;
    axis.axis = axisIndexText(m_axes, index);
    axis.sources = sourcesOf(status.setup);
    if (status.table)
        AXISCOMP_CHECK(takeTable(status, axis));
    m_result.drive.axes.push_back(std::move(axis));
    return {};
}

/// Of a file that keeps none. Positions that have different units are those of the drive.
StatedUnits statedUnits(const CompensationTable& table)
{
    return {table.unit, haveOneUnit(table.grid) ? table.grid.axes.front().unit : std::string()};
}

Result<void> Snapshot::takeTable(const AxisStatus& status, MachineAxis& axis)
{
    AXISCOMP_TRY(auto table, m_compensator.readTable(status, m_options));
    const auto dimensions = static_cast<std::size_t>(table.grid.dimensions());
    for (std::size_t n = 0; n < dimensions; ++n)
        if (!status.setup.sources[n].isSet())
            return fail(
                ErrorCode::SourceMissing, {{"dimension", n + 1}, {"ofAxis", status.axis.index}});
    axis.sources->resize(dimensions);
    describeTable(table, status, m_axes, m_profile);
    nameParts(table);
    DriveSnapshot::TableFile file;
    file.name =
        std::to_string(status.drive.serialNumber) + "-axis" + std::to_string(status.axis.index);
    if (const auto text = csvText(table, lookupNotes(status, m_profile))) {
        file.name += ".csv";
        const ByteView bytes = asBytes(*text);
        file.bytes.assign(bytes.begin(), bytes.end());
    } else {
        file.name += ".TAMtbl";
        AXISCOMP_TRY(file.bytes, encodeTamTable(table, false, m_profile.layout));
    }
    axis.file = file.name;
    axis.persistency = status.table->persistent ? Persistency::Persistent : Persistency::Volatile;
    axis.isActive = status.isOn();
    axis.acceptsLarge = !largeCorrections(table).empty(); // the drive has it
    const bool isTamTable = file.name.ends_with(".TAMtbl");
    // By its content alone a file may be one of several formats.
    axis.choices.format = isTamTable ? &tam_table::format() : &calibration_csv::format();
    // Where a file says no unit, its numbers are the drive's own.
    if (table.unit.empty())
        axis.choices.units.values = "drive";
    else if (isTamTable)
        axis.choices.units = statedUnits(table);
    // Nor does it say what it corrects, and its name may be that of another axis.
    if (isTamTable)
        axis.choices.target = axisTarget(m_profile, status.axis.index, sourcePaths(status.setup));
    m_result.files.push_back(std::move(file));
    return {};
}

} // namespace

Result<DriveSnapshot> snapshotDrive(AxisCompensator& compensator, const DriveProfile& profile,
    const std::filesystem::path& storeRoot, const std::string& endpoint,
    const OperationOptions& options)
{
    return Snapshot(compensator, profile, storeRoot, options).take(endpoint);
}

Result<MachineSnapshot> joinSnapshots(std::string name, std::vector<DriveSnapshot> drives)
{
    std::ranges::sort(
        drives, {}, [](const DriveSnapshot& snapshot) { return snapshot.drive.serialNumber; });
    MachineFile machine{std::move(name), {}};
    MachineSnapshot result;
    for (DriveSnapshot& snapshot : drives) {
        if (!snapshot.drive.axes.empty())
            machine.drives.push_back(std::move(snapshot.drive));
        std::ranges::move(snapshot.files, std::back_inserter(result.files));
    }
    // What is written must be a machine file: a drive that was named twice is none.
    const std::string text = writeMachine(machine);
    const MachineReading reading = readMachine(text);
    if (!reading.machine)
        return fail(noMachine(std::move(machine), reading.diagnostics.front()));
    const ByteView bytes = asBytes(text);
    result.files.push_back({machineFileName, Bytes(bytes.begin(), bytes.end())});
    result.drives = machine.drives.size();
    return result;
}

std::vector<std::string> replacedFiles(
    const MachineSnapshot& snapshot, const std::filesystem::path& folder)
{
    std::vector<std::string> names;
    for (const DriveSnapshot::TableFile& file : snapshot.files) {
        std::error_code failed;
        const auto kind =
            std::filesystem::symlink_status(folder / pathFromText(file.name), failed).type();
        if (kind == std::filesystem::file_type::not_found)
            continue;
        const auto there = loadOrdinaryFile(folder / pathFromText(file.name), file.bytes.size());
        if (!there || *there != file.bytes)
            names.push_back(file.name);
    }
    return names;
}

Result<void> saveSnapshot(const MachineSnapshot& snapshot, const std::filesystem::path& folder)
{
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed)
        return fail(ErrorCode::FileNotWritable,
            {{"file", Verbatim{folder.string()}}, {"reason", fileErrorReason(failed)}});
    for (const DriveSnapshot::TableFile& file : snapshot.files)
        AXISCOMP_CHECK(saveFile(folder / pathFromText(file.name), file.bytes));
    return {};
}

} // namespace axiscomp
