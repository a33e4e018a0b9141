// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/conversion_options.h"
#include "app/cli/input/table_input.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/output_file.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/io/local_file.h"
#include "core/neutral/lookup_note.h"
#include "core/table/large_correction.h"
#include "core/table/position_unit.h"
#include "core/table/table_units.h"
#include "core/table/tam_table.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <filesystem>

namespace axiscomp::app {

namespace {

struct ConvertOptions {
    TableInputOptions input;
    std::string output;
    std::string to;
    std::string name;
    bool persistent = false;
    bool isVolatile = false;
    bool acceptsLarge = false;
    std::string lookupAt;
    std::string valueUnit; ///< in a .TAMtbl, which does not say it; empty: that of the positions
    ConversionOptions conversion;
};

/// A .TAMtbl goes to a drive as it is: what write() would refuse is not put into one.
Result<void> checkForDrive(
    Environment& environment, const ConvertOptions& options, const CompensationTable& table)
{
    for (const Text& large : largeCorrections(table)) {
        if (!options.acceptsLarge)
            return fail(ErrorCode::LargeCorrection, {{"reason", large}});
        environment.warn(large.english());
    }
    return {};
}

/// The file has no units: the values are brought into that of the axis.
Result<CompensationTable> inUnitsOfFile(
    Environment& environment, const ConvertOptions& options, const CompensationTable& table)
{
    if (options.valueUnit.empty() && !isUnitOfAxisCertain(table))
        return wrongUsage(
            "a .TAMtbl has no units, and a drive takes its values in the unit of the axis that "
            "they correct. The positions of the file have different units, and it does not say "
            "which one that is: give --value-unit, such as --value-unit mm, or, if the values "
            "correct the axis of one of the positions, --target, such as --target #1 for the first",
            options.input.command);
    const std::vector<std::string> units = unitsForValues(table);
    std::string unit = options.valueUnit;
    if (unit.empty() && !units.empty())
        unit = units.front();
    if (unit.empty() && table.unit.empty())
        return table;
    if (unit.empty())
        return wrongUsage(
            "a .TAMtbl has no units, and a drive takes its values and positions in the "
            "unit of the axis. The values are in "
                + table.unit
                + ", the unit of the positions is not stated: give that of the axis with "
                  "--value-unit, such as --value-unit mm",
            options.input.command);
    // The axis that is corrected has one unit, for its values and for its own positions.
    std::vector<std::string> positions(table.grid.axes.size());
    const auto target = targetOf(table);
    if (target && target->source)
        positions[*target->source] = unit;
    else if (!target && positions.size() == 1 && unitFactor(table.grid.axes.front().unit, unit))
        positions.front() = unit;
    AXISCOMP_TRY(auto converted, inDriveUnits(table, {unit, std::move(positions)}));
    for (const Text& remark : converted.remarks)
        environment.console().note("note: " + remark.english());
    return std::move(converted.table);
}

/// What goes into the output file: all tables where it can hold several and none was named.
Result<CalibrationData> chosenTables(
    CalibrationData data, const ConvertOptions& options, const FormatFacts& to)
{
    const bool wantsAll =
        to.mostColumns != 1 && options.input.table.empty() && options.name.empty();
    if (!wantsAll) {
        AXISCOMP_TRY(const auto index, chooseTable(data, options.input));
        CompensationTable chosen = std::move(data.tables[index]);
        data.tables.clear();
        data.tables.push_back(std::move(chosen));
    }
    if (!options.name.empty())
        data.tables.front().name = options.name;
    return data;
}

Result<Bytes> encodeTable(Environment& environment, const ConvertOptions& options,
    const CompensationTable& table, bool persistent)
{
    AXISCOMP_TRY(auto profile, profileOf(options.input.profile));
    const auto& place = profile.layout.place(TableField::Name);
    if (!options.name.empty() && !place)
        environment.warn("the table layout of profile " + profile.name
            + " has no room for a name: it is left out");
    else if (place && table.name.size() > place->byteCount())
        environment.warn("the name of the table is cut to " + std::to_string(place->byteCount())
            + " bytes: " + table.name);
    AXISCOMP_TRY(const auto inUnits, inUnitsOfFile(environment, options, table));
    AXISCOMP_CHECK(checkForDrive(environment, options, inUnits));
    return encodeTamTable(inUnits, persistent, profile.layout);
}

/// A .TAMtbl has room for the numbers alone: what would be checked of a calibration file is not.
Result<void> noteWhatIsNotHeld(Environment& environment, const CalibrationData& data)
{
    AXISCOMP_CHECK(noteUnheld(environment, "note", data.notes));
    const std::string& target = data.tables.front().target;
    if (!target.empty())
        environment.console().note(
            "note: the .TAMtbl does not say what it corrects (" + target + "), as the file does");
    return {};
}

/// Returns the number of bytes written.
Result<std::size_t> writeAs(Environment& environment, const ConvertOptions& options,
    const TableFormat& format, const CalibrationData& data, bool persistent)
{
    const Output output{options.output, options.input.command};
    if (&format == &tam_table::format()) {
        AXISCOMP_CHECK(noteWhatIsNotHeld(environment, data));
        AXISCOMP_TRY(
            const auto bytes, encodeTable(environment, options, data.tables.front(), persistent));
        AXISCOMP_CHECK(writeOutput(environment, output, bytes));
        return bytes.size();
    }
    const std::string text = writeCalibrationCsv(data);
    AXISCOMP_CHECK(writeOutput(environment, output, asBytes(text)));
    return text.size();
}

/// A file of the product's own formats into the other one: the same numbers.
Result<ExitCode> convertOwn(Environment& environment, const ConvertOptions& options,
    const TableFormat& to, TableInput input)
{
    const Output output{options.output, options.input.command};
    AXISCOMP_TRY(auto data, chosenTables(std::move(*input.data), options, to.facts));
    const bool persistent = options.persistent || (input.persistent && !options.isVolatile);
    AXISCOMP_TRY(const auto bytes, writeAs(environment, options, to, data, persistent));

    Json tables = Json::array();
    for (const CompensationTable& table : data.tables)
        tables.push_back(toJson(table));
    environment.document({{"input", options.input.file}, {"output", options.output},
        {"from", input.format->facts.name}, {"to", to.facts.name},
        {"dimensions", data.grid.dimensions()}, {"axes", toJson(data.grid)},
        {"tables", std::move(tables)}, {"persistent", persistent && to.facts.holdsPersistency},
        {"bytes", bytes}});
    if (!output.isStandardOutput())
        environment.print("Wrote " + options.output + ": " + std::string(to.facts.name) + ", "
            + plural(data.tables.size(), "table", "tables") + ", "
            + plural(data.grid.pointCount(), "point", "points") + ", "
            + plural(bytes, "byte", "bytes") + ".\n");
    return ExitCode::Done;
}

/// What goes into the file of another controller: everything, unless it can hold less or one was
/// named.
struct ChosenTables {
    std::vector<NeutralTable> tables;
    std::shared_ptr<const NeutralTable> beside; ///< of the one that was chosen
};

Result<ChosenTables> chosenColumns(
    const TableInput& input, const ConvertOptions& options, const FormatFacts& to)
{
    ChosenTables chosen{neutralTables(input), {}};
    std::vector<NeutralTable>& whole = chosen.tables;
    const bool holdsAll = (to.mostColumns != 1 || separateColumns(whole).size() == whole.size())
        && (to.mostTables != 1 || whole.size() == 1);
    if (!holdsAll || !options.input.table.empty()) {
        AXISCOMP_TRY(auto column, chosenColumn(whole, options.input));
        whole = {std::move(column.table)};
        chosen.beside = std::move(column.beside);
    }
    if (!options.name.empty()) {
        whole.front().name = options.name;
        whole.front().columns.front().name = options.name;
    }
    return chosen;
}

/// Along each axis of a table that follows a curve.
Json densityJson(const ColumnDeviation& column, std::optional<double> speed)
{
    Json list = Json::array();
    for (const ColumnDeviation::Density& density : column.density)
        list.push_back({{"axis", density.axis + 1}, {"points", density.points},
            {"largestDistance", density.largestDistance},
            {"largestSlopeChange", density.largestSlopeChange},
            {"velocityStep", speed ? Json(density.largestSlopeChange * *speed) : Json(nullptr)}});
    return list;
}

Json conversionJson(const TableConversion& table, std::optional<double> speed)
{
    Json columns = Json::array();
    for (const ColumnDifference& difference : table.difference.columns)
        columns.push_back({{"largestDifference", difference.largest}, {"where", difference.where},
            {"largestInside", difference.largestInside},
            {"filled",
                filledJson(
                    table.result.columns[difference.columnB].filled, knotCounts(table.result))}});
    Json densities = Json::array();
    if (table.resampling)
        for (const ColumnDeviation& column : table.resampling->columns)
            densities.push_back(densityJson(column, speed));
    return {{"points", table.result.pointCount()}, {"columns", std::move(columns)},
        {"density", std::move(densities)}, {"valueRounding", table.valueRounding},
        {"positionRounding", table.positionRounding}, {"example", table.example.english()}};
}

/// Where it would be ignored. Errors: InvalidArgument with the way out, if it was given.
Result<void> refuseValueUnit(const ConvertOptions& options, const std::string& wayOut)
{
    if (options.valueUnit.empty())
        return {};
    return wrongUsage(
        "--value-unit is for a calibration file that becomes a .TAMtbl as it is; " + wayOut,
        options.input.command);
}

/// In two steps the first one has the options that are in the way, and the second one none of them.
std::string wayOutOfConversion(const ConvertOptions& options, const TableFormat& to)
{
    if (&to != &tam_table::format())
        return "--set-in value-unit=UNIT says in which unit the values of the input are";
    std::string others;
    for (const std::string& name : options.conversion.given())
        others += (others.empty() ? "" : ", ") + name;
    const std::string first = "convert to a .csv file first";
    return others.empty() ? first + ", and that one with --value-unit"
                          : first + ", with " + others + ", and that one with --value-unit alone";
}

/// In a file of the product's own formats each column is a table.
std::size_t tablesIn(const TableFormat& to, const Conversion& conversion)
{
    if (!isTriamec(to))
        return conversion.tables.size();
    std::size_t columns = 0;
    for (const TableConversion& table : conversion.tables)
        columns += table.result.columns.size();
    return columns;
}

/// Below the result, or noted where that takes standard output; a loss is a warning.
void tellReport(Environment& environment, const Output& output,
    const std::vector<std::string>& report, const std::vector<std::string>& losses)
{
    for (const std::string& line : report) {
        if (std::ranges::find(losses, line) != losses.end())
            environment.warn(line);
        else if (output.isStandardOutput())
            environment.console().note(line);
        else
            environment.print("  " + line + "\n");
    }
}

/// Between the formats of two controllers, or with a change of the numbers.
Result<ExitCode> convertOther(Environment& environment, const ConvertOptions& options,
    const TableFormat& to, const TableInput& input)
{
    const Output output{options.output, options.input.command};
    AXISCOMP_CHECK(refuseValueUnit(options, wayOutOfConversion(options, to)));
    AXISCOMP_TRY(auto chosen, chosenColumns(input, options, to.facts));
    const std::vector<NeutralTable>& tables = chosen.tables;
    AXISCOMP_TRY(auto request,
        conversionRequest(options.conversion, *input.format, to, tables.front().axes.size()));
    request.beside = std::move(chosen.beside);
    AXISCOMP_TRY(auto profile, profileOf(options.input.profile));
    request.writing.layout = &profile.layout;
    request.writing.fileName = pathFromText(options.output).filename().string();
    if (to.facts.holdsPersistency
        && (options.persistent || (input.persistent && !options.isVolatile)))
        request.writing.settings["persistent"] = "yes";
    AXISCOMP_TRY(const auto conversion, convertTables(tables, request));
    if (&to == &tam_table::format()) {
        AXISCOMP_TRY(const auto data, calibrationData(conversion.written.held.front()));
        AXISCOMP_CHECK(checkForDrive(environment, options, data.tables.front()));
    }
    const ByteView bytes = asBytes(conversion.written.bytes);
    AXISCOMP_CHECK(writeOutput(environment, output, bytes));

    const std::vector<std::string> report = englishOf(conversionReport(conversion, request));
    Json results = Json::array();
    for (const TableConversion& table : conversion.tables)
        results.push_back(conversionJson(table, request.speed));
    environment.document({{"input", options.input.file}, {"output", options.output},
        {"from", input.format->facts.name}, {"to", to.facts.name},
        {"dimensions", conversion.written.held.front().axes.size()}, {"tables", std::move(results)},
        {"report", report}, {"bytes", bytes.size()}});
    if (!output.isStandardOutput())
        environment.print("Wrote " + options.output + ": " + std::string(to.facts.name) + ", "
            + plural(tablesIn(to, conversion), "table", "tables") + ", "
            + plural(bytes.size(), "byte", "bytes") + ".\n");
    tellReport(environment, output, report, englishOf(conversionLosses(conversion)));
    return ExitCode::Done;
}

/// A calibration file has a place for the units that the input does not say, and a .TAMtbl has
/// none.
void warnOfOpenUnits(Environment& environment, const ConvertOptions& options, const TableFormat& to,
    const TableInput& input)
{
    if (input.data && &to == &calibration_csv::format())
        environment.diagnose(displayName(options.input.file), openUnits(*input.data));
}

/// The layout of a profile decides what a .TAMtbl says.
Result<void> checkHoldsPersistency(const ConvertOptions& options)
{
    AXISCOMP_TRY(const auto profile, profileOf(options.input.profile));
    if (profile.layout.place(TableField::Persistent))
        return {};
    return wrongUsage("the table layout of profile " + profile.name
            + " has no room to say whether a table is persistent: leave --persistent out",
        options.input.command);
}

Result<ExitCode> runConvert(Environment& environment, const ConvertOptions& options)
{
    const Output output{options.output, options.input.command};
    AXISCOMP_TRY(const auto to, outputFormat(options.output, options.to));
    const FormatFacts& format = to->facts;
    AXISCOMP_CHECK(checkOutput(environment, output, format.isText));
    if (to == &calibration_csv::format())
        AXISCOMP_CHECK(refuseValueUnit(
            options, "--set-in value-unit=UNIT says in which unit the values of the input are"));
    if ((options.persistent || options.isVolatile) && !format.holdsPersistency)
        return wrongUsage(std::string(format.name) + " cannot say whether a table is persistent",
            options.input.command);
    if (options.persistent && to == &tam_table::format())
        AXISCOMP_CHECK(checkHoldsPersistency(options));
    TableInputOptions inputOptions = options.input;
    inputOptions.acceptsUneven = options.conversion.resamples() || format.knots == KnotRule::Any;
    AXISCOMP_TRY(auto input, readInput(environment, inputOptions));
    warnOfOpenUnits(environment, options, *to, input);
    ConvertOptions known = options;
    AXISCOMP_TRY(known.conversion, withSignOfFile(input, options.conversion));
    if (!input.data || !isTriamec(*to) || known.conversion.isAnything())
        return convertOther(environment, known, *to, input);
    return convertOwn(environment, options, *to, std::move(input));
}

} // namespace

void addConvertCommand(CommandLine& line)
{
    auto options = std::make_shared<ConvertOptions>();
    options->input.command = commandName("convert");
    CLI::App* command = line.add("convert", fileCommands,
        AXISCOMP_HELP("Help", "Convert a table file to another format"),
        [options](Environment& environment) {
            options->conversion.lookupAt = lookupAtNamed(options->lookupAt);
            return runConvert(environment, *options);
        });
    command
        ->add_option(
            "IN", options->input.file, AXISCOMP_HELP("Help", "File to read; - for standard input"))
        ->required();
    command
        ->add_option("OUT", options->output,
            AXISCOMP_HELP("Help", "File to write, replaced if it exists; - for standard output"))
        ->required();
    addDimensionsOption(*command, options->input);
    addTableOption(*command, options->input);
    addFromOption(*command, options->input);
    addIncompleteGridOptions(*command, options->input);
    command
        ->add_option("--to", options->to,
            AXISCOMP_HELP("Help", "Format of the output, if its name leaves it open"))
        ->option_text("FORMAT");
    command
        ->add_option("--value-unit", options->valueUnit,
            AXISCOMP_HELP("Help",
                "Unit of the values in a .TAMtbl, which does not say it; by default that of the "
                "positions"))
        ->option_text("UNIT")
        ->group("Conversion");
    command->add_flag("--accept-large", options->acceptsLarge,
        AXISCOMP_HELP("Help",
            "Put corrections above 1 % of the range, or with a slope above 0.1, into a .TAMtbl"));
    CLI::Option* persistent = command->add_flag("--persistent", options->persistent,
        AXISCOMP_HELP("Help", "Mark the table persistent: the drive stores it"));
    command
        ->add_flag("--volatile", options->isVolatile,
            AXISCOMP_HELP("Help", "Mark the table volatile (without either: as the input is)"))
        ->excludes(persistent);
    command->add_option("--name", options->name, AXISCOMP_HELP("Help", "Name of the table"))
        ->option_text("TEXT");
    options->conversion.command = options->input.command;
    addConversionOptions(*command, options->conversion);
    addLookupOption(*command, options->lookupAt);
    addResamplingOptions(*command, options->conversion);
    addOutputOptions(*command, options->conversion);
    addProfileOption(*command, options->input.profile);
    command->footer(AXISCOMP_HELP(
        "Help", "Examples:") "\n  axiscomp convert x.csv x.TAMtbl --dims 1 --table 2 --persistent"
                             "\n  axiscomp convert x.csv x.txt --dims 1 --to softmc"
                             "\n  axiscomp convert measured.csv even.csv --dims 1 --within 0.1 "
                             "--method cubic"
                             "\n  axiscomp convert x.csv dense.csv --dims 1 --within 0.01 --method "
                             "spline --speed 100");
}

} // namespace axiscomp::app
