// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/commands/record_figures.h"
#include "app/cli/input/conversion_options.h"
#include "app/cli/input/table_input.h"
#include "app/cli/session/write_run.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "core/axis/proposals.h"
#include "core/compensator/drive_record.h"
#include "core/compensator/multi_axis_write.h"
#include "core/conversion/axis_place.h"
#include "core/drive/axis_target.h"
#include "core/formats/formats.h"
#include "core/io/local_file.h"
#include "core/metrology/record/reference_reading.h"
#include "core/neutral/lookup_note.h"
#include "core/table/table_units.h"
#include "core/write/lookup_side.h"

#include <algorithm>
#include <array>

namespace axiscomp::app {

namespace {

struct WriteOptions {
    DriveOptions drive;
    TableInputOptions input;
    ConversionOptions conversion;
    std::array<std::string, 3> sources;
    std::string slot;
    std::vector<std::string> map; ///< COLUMN=AXIS, or AXIS for the column that is called so
    bool usesOwnPosition = false; ///< as the source, of each axis
    bool persistent = false;
    bool isVolatile = false;
    bool isDryRun = false;
    bool acceptsLarge = false;
    std::string record; ///< whose table is written
};

/// Those that were given, from dimension 1 on. Errors: SourceMissing for a gap.
Result<std::vector<std::string>> givenSources(const WriteOptions& options)
{
    std::vector<std::string> sources;
    for (std::size_t n = 0; n < options.sources.size(); ++n) {
        if (options.sources[n].empty())
            continue;
        if (sources.size() < n)
            return fail(
                ErrorCode::SourceMissing, {{"dimension", std::to_string(sources.size() + 1)}});
        sources.push_back(options.sources[n]);
    }
    return sources;
}

/// Everything but the table. Errors: those of givenSources.
Result<WriteRequest> requestWithoutTable(const WriteOptions& options)
{
    WriteRequest request;
    AXISCOMP_TRY(auto sources, givenSources(options));
    request.sources = std::move(sources);
    if (options.persistent || options.isVolatile)
        request.persistency = options.persistent ? Persistency::Persistent : Persistency::Volatile;
    request.acceptsLarge = options.acceptsLarge;
    return request;
}

Result<TableInput> readData(
    Environment& environment, const WriteOptions& options, TableInputOptions& inputOptions)
{
    inputOptions = options.input;
    inputOptions.profile = options.drive.profile;
    inputOptions.acceptsUneven = options.conversion.resamples();
    inputOptions.units = options.conversion.units;
    return readInput(environment, inputOptions);
}

/// A request and the table for it. Where the file leaves open what its values correct, that is what
/// the axis is among its sources; and by these a table of another controller is made for the
/// position before the compensation, or for the one after it.
struct TableRequest {
    WriteRequest request;
    TableInputOptions inputOptions;
    std::vector<std::string> targets; ///< as stated; empty: as the file or the axis says
    std::vector<std::string> report; ///< of what was converted
    bool needsTarget = false;
    bool needsLookup = false;
};

Result<void> takeTable(const WriteOptions& options, const TableInput& input, TableRequest& pending,
    const std::string& target, std::optional<LookupAt> lookupAt)
{
    ConversionOptions conversion = options.conversion;
    conversion.targets = pending.targets;
    if (conversion.targets.empty() && !target.empty())
        conversion.targets = {target};
    if (!isOfDrive(input, conversion))
        conversion.lookupAt = lookupAt;
    AXISCOMP_TRY(auto made, driveTable(input, pending.inputOptions, conversion));
    made.table.isTargetOfDrive = pending.targets.empty() && !target.empty();
    pending.request.unstatedUnit = unstatedUnit(conversion.units.values);
    pending.request.dimensionality = made.table.grid.dimensions();
    pending.request.table = std::move(made.table);
    pending.request.lookupAt = made.lookupAt;
    pending.request.measuredDrive = made.measuredDrive;
    pending.report = std::move(made.report);
    return {};
}

/// What can be done before the drive is asked, so that a bad file is said even when none is there.
Result<void> beginTable(const WriteOptions& options, const TableInput& input, TableRequest& pending)
{
    auto taken = takeTable(options, input, pending, {}, {});
    pending.needsTarget = !taken && taken.error().code == ErrorCode::TargetNotKnown;
    pending.needsLookup = !isOfDrive(input, options.conversion);
    const bool isOpen =
        !taken && (pending.needsTarget || (pending.needsLookup && dependsOnPlace(taken.error())));
    if (isOpen && input.data)
        pending.request.dimensionality = input.data->grid.dimensions();
    return isOpen ? Result<void>() : taken;
}

Result<void> finishTable(Environment& environment, const WriteOptions& options,
    const TableInput& input, TableRequest& pending, CommandSession& session, int axis)
{
    if (pending.needsTarget || pending.needsLookup) {
        std::vector<std::string> sources;
        for (const std::string& given : pending.request.sources) {
            AXISCOMP_TRY(
                auto source, session.compensator().resolveSource(given, session.operation()));
            sources.push_back(std::move(source.path));
        }
        if (sources.empty()) {
            AXISCOMP_TRY(const auto now, session.compensator().status(axis, session.operation()));
            sources = sourcePaths(now.setup);
        }
        const std::string target = axisTarget(session.profile(), axis, sources);
        const auto lookupAt = lookupAtSources(session.profile(), axis, sources);
        auto taken =
            takeTable(options, input, pending, pending.needsTarget ? target : "", lookupAt);
        // What can be taken as it is before the compensation needs its target behind it.
        if (!taken && taken.error().code == ErrorCode::TargetNotKnown && !pending.needsTarget)
            taken = takeTable(options, input, pending, target, lookupAt);
        AXISCOMP_CHECK(taken);
    }
    noteReport(environment, pending.report);
    return {};
}

/// The position of the axis itself. Errors: InvalidArgument where no register is known for it.
Result<void> takeOwnPosition(
    CommandSession& session, const WriteOptions& options, WriteRequest& request, int axis)
{
    if (!options.usesOwnPosition)
        return {};
    if (request.dimensionality != 1)
        return wrongUsage("--own-position is for tables of one dimension, and this one has "
                + std::to_string(request.dimensionality),
            options.drive.command);
    AXISCOMP_TRY(const auto shortlist, session.compensator().sourceShortlist(session.operation()));
    const DimSource source = positionSource({session.profile(), shortlist, {}}, axis);
    if (!source.isSet())
        return wrongUsage("no register is known for the position of axis " + std::to_string(axis)
                + ": give --source1",
            options.drive.command);
    request.sources = {source.path};
    return {};
}

/// What the columns of positions propose for sources that neither the user nor the drive names.
void proposeSources(
    Environment& environment, CommandSession& session, const WriteRequest& request, int axis)
{
    if (!request.table)
        return;
    const auto shortlist = session.compensator().sourceShortlist(session.operation());
    const auto axes = session.compensator().axes(session.operation());
    if (!shortlist || !axes)
        return;
    std::string proposal;
    const auto sources =
        proposedSources({session.profile(), *shortlist, *axes}, axis, request.table->grid);
    for (std::size_t n = 0; n < sources.size(); ++n)
        if (sources[n].isSet())
            proposal += " --source" + std::to_string(n + 1) + " '" + sources[n].path + "'";
    if (!proposal.empty())
        environment.console().note("note: the file proposes" + proposal);
}

/// The column that is called as an axis, by its number. Errors: InvalidArgument.
Result<std::string> columnCalled(
    const TableInput& input, const std::string& axis, const WriteOptions& options)
{
    std::vector<CompensationTable> tables;
    if (input.data) {
        tables = input.data->tables;
    } else {
        for (const NeutralTable& column : neutralColumns(input)) {
            tables.emplace_back();
            tables.back().name = column.columns.front().name;
        }
    }
    AxisInfo called;
    called.name = axis;
    const auto found = proposedTable(tables, std::span(&called, 1), called.index);
    if (!found)
        return wrongUsage(
            "no column is named as axis " + axis + ": give COLUMN=AXIS", options.drive.command);
    return std::to_string(*found + 1);
}

/// What one --map asks for: an axis as the user names it, and what it shall have.
struct MappedColumn {
    std::string axis;
    TableRequest pending;
};

/// One target is for all; of several each is for the --map at its place.
Result<void> checkTargetsOfMaps(const WriteOptions& options)
{
    const std::size_t count = options.conversion.targets.size();
    if (count <= 1 || count == options.map.size())
        return {};
    return wrongUsage("--target states " + std::to_string(count) + " targets for "
            + plural(options.map.size(), "--map", "--map")
            + ": state one for all, or one for each in the order of --map",
        options.drive.command);
}

std::vector<std::string> targetsOfMap(const WriteOptions& options, std::size_t map)
{
    const std::vector<std::string>& targets = options.conversion.targets;
    if (targets.size() <= 1)
        return targets;
    return {targets[map]};
}

Result<std::vector<MappedColumn>> mappedColumns(
    const WriteOptions& options, const TableInput& input, TableInputOptions inputOptions)
{
    std::vector<MappedColumn> columns;
    for (std::size_t n = 0; n < options.map.size(); ++n) {
        const std::string& pair = options.map[n];
        const std::size_t equals = pair.rfind('=');
        if (pair.empty() || equals == 0 || equals + 1 == pair.size())
            return wrongUsage("\"" + pair + "\" is no COLUMN=AXIS", options.drive.command);
        const std::string axis = equals == std::string::npos ? pair : pair.substr(equals + 1);
        if (equals == std::string::npos) {
            AXISCOMP_TRY(inputOptions.table, columnCalled(input, axis, options));
        } else {
            inputOptions.table = pair.substr(0, equals);
        }
        AXISCOMP_TRY(auto request, requestWithoutTable(options));
        MappedColumn column{axis, {std::move(request), inputOptions, targetsOfMap(options, n), {}}};
        AXISCOMP_CHECK(beginTable(options, input, column.pending));
        columns.push_back(std::move(column));
    }
    return columns;
}

/// All are planned before the first is written; then one after the other.
Result<ExitCode> writeMapped(Environment& environment, CommandSession& session,
    const WriteOptions& options, const TableInput& input, std::vector<MappedColumn> columns)
{
    std::vector<AxisWrite> writes;
    for (MappedColumn& column : columns) {
        AXISCOMP_TRY(
            const auto axis, session.compensator().findAxis(column.axis, session.operation()));
        AXISCOMP_CHECK(takeOwnPosition(session, options, column.pending.request, axis));
        AXISCOMP_CHECK(finishTable(environment, options, input, column.pending, session, axis));
        writes.push_back({axis, column.pending.request});
    }
    std::vector<std::string> names;
    for (const MappedColumn& column : columns)
        names.push_back(column.axis);
    auto written = writeSeveral(environment, session, writes, names, options.isDryRun);
    if (!written && written.error().code == ErrorCode::SourceMissing)
        for (const AxisWrite& write : writes)
            if (written.error().context.integer("ofAxis") == write.axis)
                proposeSources(environment, session, write.request, write.axis);
    AXISCOMP_TRY(auto documents, std::move(written));
    environment.document({{"writes", std::move(documents)}});
    return ExitCode::Done;
}

Result<ExitCode> runMapped(Environment& environment, const WriteOptions& options)
{
    if (options.input.file.empty())
        return wrongUsage("--map says which column of --data FILE is for which axis: give --data",
            options.drive.command);
    AXISCOMP_CHECK(checkTargetsOfMaps(options));
    TableInputOptions inputOptions;
    AXISCOMP_TRY(const auto input, readData(environment, options, inputOptions));
    AXISCOMP_TRY(const auto columns, mappedColumns(options, input, inputOptions));
    return withDrive(environment, options.drive, [&](Environment& same, CommandSession& session) {
        return writeMapped(same, session, options, input, columns);
    });
}

/// The tables of a record as if a file had been read.
Result<TableInput> inputOfRecord(const CalibrationRecord& record, const WriteOptions& options)
{
    if (record.tables.empty())
        return wrongUsage(options.record + " has no table: axiscomp fit --record makes one",
            options.drive.command);
    TableInput input;
    input.format = &calibration_csv::format();
    input.data = CalibrationData{record.tables.front().table.grid, {}, {}};
    for (const RecordedTable& recorded : record.tables)
        input.data->tables.push_back(recorded.table);
    if (record.fit && record.fit->settings.lookupAt)
        input.data->notes.push_back(lookupNote(*record.fit->settings.lookupAt));
    return input;
}

/// Whether something is asked for that makes another table of a table.
bool isConverted(const ConversionOptions& options)
{
    return options.isAnything() || options.holdsEnds || options.units != StatedUnits{};
}

/// What would make another table of it, or is about the reading of a file.
Result<void> checkRecordAlone(const CalibrationRecord& record, const WriteOptions& options)
{
    const TableInputOptions& input = options.input;
    ConversionOptions conversion = options.conversion;
    if (record.tables.front().table.target.empty())
        conversion.targets.clear(); // it is asked for
    const bool isChanged = isConverted(conversion) || !input.from.empty() || !input.settings.empty()
        || input.dimensions != 0 || !input.fill.empty() || input.crops || input.snap != 0.0;
    if (isChanged)
        return wrongUsage("the table of a record is written as it is, with its own units: leave "
                          "out --dims, --from and everything that converts or resamples",
            options.drive.command);
    return {};
}

/// Without a file or a record the axis keeps its table: what is about reading or converting one
/// would change nothing.
Result<void> checkNoTable(const WriteOptions& options)
{
    const TableInputOptions& input = options.input;
    const bool isForTable = isConverted(options.conversion) || !input.from.empty()
        || !input.settings.empty() || !input.table.empty() || !input.fill.empty() || input.crops
        || input.snap != 0.0 || !options.slot.empty();
    if (isForTable)
        return wrongUsage("without --data the axis keeps its table as it is: give --data FILE, or "
                          "leave out --table, --from, --slot, units and everything that "
                          "converts or resamples",
            options.drive.command);
    return {};
}

/// Whether a table is looked up where it was made for cannot always be told.
Result<void> warnOfSources(Environment& environment, CommandSession& session, LookupAt made,
    const WriteRequest& request, const AxisStatus& status)
{
    const auto sources = request.sources.empty() ? sourcePaths(status.setup) : request.sources;
    for (const std::string& text : sources) {
        AXISCOMP_TRY(
            const auto source, session.compensator().resolveSource(text, session.operation()));
        if (!lookupAtSource(session.profile(), source.path))
            environment.warn("the profile does not say whether " + source.path
                + " is a position before or after the compensation; the table was made for "
                  "--lookup-at "
                + std::string(lookupAtName(made)));
    }
    return {};
}

/// Writes, and notes in the record, where there is one, what the drive holds then.
Result<ExitCode> writeAndNote(Environment& environment, CommandSession& session,
    const WriteOptions& options, const WriteRequest& request, CalibrationRecord record, int axis)
{
    if (options.record.empty())
        return runWrite(environment, session, axis, request, options.isDryRun);
    AXISCOMP_TRY(const auto before, session.compensator().status(axis, session.operation()));
    AXISCOMP_CHECK(checkRecordAxis(record, before));
    if (request.lookupAt)
        AXISCOMP_CHECK(warnOfSources(environment, session, *request.lookupAt, request, before));
    AXISCOMP_TRY(
        const auto outcome, writeAndReport(environment, session, axis, request, options.isDryRun));
    if (outcome.now) {
        auto noted = recordWrite(
            record, *outcome.now, session.profile().name, std::chrono::system_clock::now());
        if (noted)
            noted = saveRecord(pathFromText(options.record), record);
        if (noted)
            keepFiguresOrWarn(environment, session.store(), record, Measuring::Known);
        if (!noted) {
            environment.console().note(
                "note: the drive has the table; only the record does not say so");
            return fail(noted.error());
        }
    }
    environment.document(outcome.document);
    return ExitCode::Done;
}

Result<ExitCode> runWriteCommand(Environment& environment, const WriteOptions& options)
{
    if (!options.map.empty())
        return runMapped(environment, options);
    TableRequest pending;
    AXISCOMP_TRY(pending.request, requestWithoutTable(options));
    pending.targets = options.conversion.targets;
    WriteRequest& request = pending.request;
    TableInput input;
    CalibrationRecord record;
    if (!options.record.empty()) {
        AXISCOMP_TRY(record, loadRecord(pathFromText(options.record)));
        AXISCOMP_TRY(input, inputOfRecord(record, options));
        AXISCOMP_CHECK(checkRecordAlone(record, options));
        request.isComputed = !isReferenceReadAtLargest(record);
        pending.inputOptions = options.input;
        pending.inputOptions.file = options.record;
        AXISCOMP_CHECK(beginTable(options, input, pending));
    } else if (!options.input.file.empty()) {
        AXISCOMP_TRY(input, readData(environment, options, pending.inputOptions));
        AXISCOMP_CHECK(beginTable(options, input, pending));
    } else if (request.sources.empty() && !options.usesOwnPosition && !request.persistency) {
        return wrongUsage("there is nothing to write: give --data FILE, or a new --source1",
            options.drive.command);
    } else {
        AXISCOMP_CHECK(checkNoTable(options));
        request.dimensionality = options.input.dimensions;
    }
    return withAxis(environment, options.drive,
        [&](Environment& same, CommandSession& session, int axis) -> Result<ExitCode> {
            if (request.dimensionality == 0) {
                AXISCOMP_TRY(
                    const auto now, session.compensator().status(axis, session.operation()));
                request.dimensionality = now.setup.dimensionality;
            }
            AXISCOMP_CHECK(takeOwnPosition(session, options, request, axis));
            AXISCOMP_CHECK(finishTable(same, options, input, pending, session, axis));
            if (!options.slot.empty())
                request.slot = slotName(session.profile(), options.slot);
            auto ended = writeAndNote(same, session, options, request, record, axis);
            if (!ended && ended.error().code == ErrorCode::SourceMissing)
                proposeSources(same, session, request, axis);
            return ended;
        });
}

void addSourceOptions(CLI::App& command, WriteOptions& options)
{
    constexpr std::array meanings{
        AXISCOMP_HELP("Help",
            "Register that supplies the position of dimension 1: path, tam:// URI or address "
            "(0x1234)"),
        AXISCOMP_HELP("Help", "The same for dimension 2"),
        AXISCOMP_HELP("Help", "The same for dimension 3")};
    static_assert(meanings.size() == std::tuple_size_v<decltype(options.sources)>);
    for (std::size_t n = 0; n < meanings.size(); ++n)
        command.add_option("--source" + std::to_string(n + 1), options.sources[n], meanings[n])
            ->option_text("REG");
    command
        .add_flag("--own-position", options.usesOwnPosition,
            AXISCOMP_HELP("Help",
                "The source is the axis's own position, for tables of one dimension; with --map "
                "each "
                "axis's own"))
        ->excludes("--source1")
        ->excludes("--source2")
        ->excludes("--source3");
}

} // namespace

void addWriteCommand(CommandLine& line)
{
    auto options = std::make_shared<WriteOptions>();
    options->drive.command = commandName("write");
    options->input.command = options->drive.command;
    CLI::App* command = line.add("write", driveCommands,
        AXISCOMP_HELP(
            "Help", "Write a compensation table to an axis in the safe order, and verify it"),
        [options](Environment& environment) { return runWriteCommand(environment, *options); });
    addDriveOptions(*command, options->drive);
    CLI::Option* const axis = addAxisOption(*command, options->drive);
    command
        ->add_option("--data", options->input.file,
            AXISCOMP_HELP("Help",
                "Calibration file (.csv), table (.TAMtbl), or file of another controller; without "
                "it "
                "the "
                "axis keeps its table"))
        ->option_text("FILE");
    CLI::Option* const record = command->add_option("--record", options->record,
        AXISCOMP_HELP("Help",
            "Record of a compensation in place of --data: its table is written, and it notes "
            "drive, "
            "slot and CRC"));
    record->option_text("FILE.axcal")->excludes("--data");
    addDimensionsOption(*command, options->input);
    CLI::Option* const table = addTableOption(*command, options->input);
    addFromOption(*command, options->input);
    addIncompleteGridOptions(*command, options->input);
    options->conversion.command = options->drive.command;
    addConversionOptions(*command, options->conversion);
    addResamplingOptions(*command, options->conversion);
    addSourceOptions(*command, *options);
    CLI::Option* persistent = command->add_flag("--persistent", options->persistent,
        AXISCOMP_HELP(
            "Help", "Store the table in the drive's flash, so that it survives a reboot"));
    command
        ->add_flag("--volatile", options->isVolatile,
            AXISCOMP_HELP("Help",
                "Keep the table in memory until the next reboot (the default for a new table)"))
        ->excludes(persistent);
    command
        ->add_option("--value-unit", options->conversion.units.values,
            AXISCOMP_HELP("Help",
                "Unit of the values in place of what the file says, such as um; drive for the "
                "drive's "
                "own"))
        ->option_text("UNIT")
        ->group("Conversion");
    command
        ->add_option("--position-unit", options->conversion.units.positions,
            AXISCOMP_HELP("Help", "The same for the positions"))
        ->option_text("UNIT")
        ->group("Conversion");
    CLI::Option* const slot = command->add_option("--slot", options->slot,
        AXISCOMP_HELP(
            "Help", "Slot to use, small1 to small8, large1 or large2; chosen unless given"));
    slot->option_text("SLOT");
    command
        ->add_option("--map", options->map,
            AXISCOMP_HELP("Help",
                "Write this column of the file (name or number) to this axis; AXIS alone is the "
                "column "
                "that is named as the axis. May be given several times. Nothing is written unless "
                "all "
                "of the writes are possible"))
        ->option_text("COLUMN=AXIS")
        ->excludes(axis)
        ->excludes(table)
        ->excludes(record)
        ->excludes(slot);
    command->add_flag("--accept-large", options->acceptsLarge,
        AXISCOMP_HELP("Help",
            "Write corrections above 1 % of the range, or with a slope above 0.1, which without "
            "this "
            "are taken for a wrong unit"));
    command->add_flag("--dry-run", options->isDryRun,
        AXISCOMP_HELP("Help", "Show what would be written without writing it"));
    command->footer(AXISCOMP_HELP("Help",
        "Without --source1 the axis keeps its sources. The compensation stays off: `axiscomp "
        "activate` switches it on.") "\n\n" AXISCOMP_HELP("Help",
        "Example:") "\n  axiscomp write --drive http://192.168.1.20 --axis X --data x.csv --dims 1 "
                    "\\"
                    "\n      --source1 'Axes[0]/Signals/PathPlanner/Position' --persistent"
                    "\n  axiscomp write --data plane.csv --dims 2 --map 'X error=X' --map 'Y "
                    "error=Y' \\"
                    "\n      --source1 'Axes[0]/Signals/PathPlanner/Position' \\"
                    "\n      --source2 'Axes[1]/Signals/PathPlanner/Position'");
}

void addPersistencyCommands(CommandLine& line)
{
    struct Row {
        const char* name;
        const char* description;
        Persistency persistency;
    };
    for (const Row& row :
        {Row{"persist",
             AXISCOMP_HELP("Help",
                 "Store the axis's table in the drive's flash, so that it survives a reboot"),
             Persistency::Persistent},
            Row{"unpersist",
                AXISCOMP_HELP("Help",
                    "Make the axis's table volatile, so that it is lost at the next reboot"),
                Persistency::Volatile}}) {
        auto options = std::make_shared<DriveOptions>();
        options->command = commandName(row.name);
        const Persistency persistency = row.persistency;
        CLI::App* command = line.add(row.name, driveCommands, row.description,
            [options, persistency](Environment& environment) {
                return withAxis(environment, *options,
                    [persistency](Environment& sameEnvironment, CommandSession& session,
                        int axis) -> Result<ExitCode> {
                        AXISCOMP_TRY(const auto now,
                            session.compensator().status(axis, session.operation()));
                        if (!now.table)
                            return fail(ErrorCode::NoTable, {{"axis", std::to_string(axis)}});
                        WriteRequest request;
                        request.dimensionality = now.setup.dimensionality;
                        request.persistency = persistency;
                        return runWrite(sameEnvironment, session, axis, request, false);
                    });
            });
        addDriveOptions(*command, *options);
        addAxisOption(*command, *options);
    }
}

} // namespace axiscomp::app
