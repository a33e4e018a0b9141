// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/conversion_options.h"
#include "app/cli/input/point_file.h"
#include "app/cli/input/table_input.h"
#include "app/cli/output/json_output.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "app/common/standard_streams.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/table/lookup.h"
#include "core/table/position_unit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace axiscomp::app {

namespace {

const std::map<std::string, Outside> outsideNames{{"hold", Outside::Hold}, {"zero", Outside::Zero},
    {"wrap", Outside::Wrap}, {"extrapolate", Outside::Extrapolate}, {"error", Outside::Error}};

struct LookupOptions {
    TableInputOptions input;
    std::vector<std::string> position;
    std::string points;
    std::string outside; ///< empty: hold
    std::string as; ///< the format whose controller applies the table; empty: that of the file
    std::string lookupAt;
    ConversionOptions conversion;
};

std::string rangeText(const GridAxis& axis)
{
    return shortText(axis.start) + " to " + shortText(axis.last());
}

/// A table of the drive, as the drive looks it up.
TableEvaluation driveEvaluation(const CompensationTable& table, Outside outside)
{
    return {table.grid.axes.size(),
        [&table, lookup = Lookup(table, outside)](
            const std::vector<double>& position) -> Result<double> {
            const double value = lookup.at(position);
            if (!std::isnan(value))
                return value;
            std::string reason = "the position is outside of the table:";
            for (std::size_t n = 0; n < position.size(); ++n)
                reason += (n == 0 ? " " : ", ") + shortText(position[n]) + " of "
                    + rangeText(table.grid.axes[n]);
            return fail(ErrorCode::InvalidArgument, {{"reason", reason}});
        }};
}

/// A table as the controller of another format applies it. positionUnits: of the positions that
/// are asked for, which are those of the file.
TableEvaluation controllerEvaluation(const NeutralTable& table, const TableBehaviour& behaviour,
    const std::vector<std::string>& positionUnits)
{
    std::vector<double> factors;
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        factors.push_back(unitFactor(positionUnits[n], table.axes[n].unit).value_or(1.0));
    return {table.axes.size(),
        [factors = std::move(factors), applied = ControllerLookup(table, 0, behaviour)](
            std::vector<double> position) -> Result<double> {
            std::ranges::transform(position, factors, position.begin(), std::multiplies<>());
            return applied.at(position);
        }};
}

Result<std::vector<double>> positionOf(const LookupOptions& options, std::size_t dimensions)
{
    std::vector<double> position;
    for (const std::string& text : options.position) {
        const auto number = numberFromText(text);
        if (!number)
            return wrongUsage(
                "a position must be a number such as -12.5, not " + text, options.input.command);
        position.push_back(*number);
    }
    if (position.size() != dimensions)
        return wrongUsage("the table has " + plural(dimensions, "dimension", "dimensions")
                + ", but " + plural(position.size(), "position is", "positions are") + " given",
            options.input.command);
    return position;
}

/// Answers the position or the file of positions; described: what the JSON document says beside.
Result<ExitCode> answer(Environment& environment, const LookupOptions& options,
    const TableEvaluation& evaluation, Json described)
{
    Json results = Json::array();
    if (!options.points.empty()) {
        auto answered = answerPointFile(environment, evaluation, options.points, results);
        if (!answered)
            return fail(answered.error());
    } else {
        AXISCOMP_TRY(const auto position, positionOf(options, evaluation.dimensions));
        AXISCOMP_TRY(const auto value, evaluation.at(position));
        environment.print(floatText(value) + "\n");
        results.push_back({{"position", position}, {"value", value}});
    }
    described["results"] = std::move(results);
    environment.document(described);
    return ExitCode::Done;
}

Result<ExitCode> lookUpForDrive(
    Environment& environment, const LookupOptions& options, const TableInput& input)
{
    AXISCOMP_TRY(const auto made, driveTable(input, options.input, options.conversion));
    noteReport(environment, made.report);
    const CompensationTable& table = made.table;
    const std::string outside = options.outside.empty() ? "hold" : options.outside;
    return answer(environment, options, driveEvaluation(table, outsideNames.at(outside)),
        {{"file", options.input.file}, {"table", toJson(table)}, {"outside", outside}});
}

void noteOfTable(
    Environment& environment, const LookupOptions& options, std::span<const Text> remarks)
{
    for (const Text& remark : remarks)
        environment.console().note(displayName(options.input.file) + ": " + remark.english());
}

/// As the file's own controller applies it, with what was said of it.
Result<NeutralTable> asStated(Environment& environment, const LookupOptions& options,
    const TableInput& input, ChosenColumn chosen)
{
    if (!options.conversion.isAnything())
        return std::move(chosen.table);
    AXISCOMP_TRY(auto request,
        conversionRequest(
            options.conversion, *input.format, *input.format, chosen.table.axes.size()));
    request.beside = std::move(chosen.beside);
    AXISCOMP_TRY(auto stated, tableAsStated(chosen.table, request));
    noteOfTable(environment, options, stated.remarks);
    return std::move(stated.table);
}

/// As another controller applies what its file would say.
Result<NeutralTable> asConverted(Environment& environment, const LookupOptions& options,
    const TableInput& input, const TableFormat& as, ChosenColumn chosen)
{
    if (&as == input.format && !options.conversion.isAnything())
        return std::move(chosen.table);
    AXISCOMP_TRY(auto request,
        conversionRequest(options.conversion, *input.format, as, chosen.table.axes.size()));
    request.beside = std::move(chosen.beside);
    AXISCOMP_TRY(const auto profile, profileOf(options.input.profile));
    request.writing.layout = &profile.layout;
    const NeutralTable tables[] = {std::move(chosen.table)};
    AXISCOMP_TRY(auto conversion, convertTables(tables, request));
    // What the format says of its file, such as where to name it, is of no use here.
    const auto& ofFile = conversion.written.remarks;
    std::erase_if(conversion.remarks,
        [&](const Text& remark) { return std::ranges::find(ofFile, remark) != ofFile.end(); });
    noteOfTable(environment, options, conversion.remarks);
    NeutralTable held = std::move(conversion.written.held.front());
    // The column that was asked for comes first; a format may add others that correct nothing.
    if (held.columns.front().direction == Direction::Both)
        held.columns.resize(1);
    return held;
}

/// Of the value that is printed, where it is not that of the file.
void noteUnit(Environment& environment, const LookupOptions& options, const std::string& unit,
    const std::string& unitOfFile)
{
    if (unit.empty() || isSameUnit(unit, unitOfFile))
        return;
    environment.console().note(displayName(options.input.file) + ": the unit of the value is "
        + unit + (unitOfFile.empty() ? std::string() : "; that of the file is " + unitOfFile));
}

/// The file's own controller, or another one, to whose format the table is converted first.
Result<ExitCode> lookUpForController(
    Environment& environment, const LookupOptions& options, const TableInput& input)
{
    AXISCOMP_TRY(const auto as,
        options.as.empty() ? Result<const TableFormat*>(input.format) : formatNamed(options.as));
    AXISCOMP_TRY(auto chosen, chosenColumn(neutralTables(input), options.input));
    std::vector<std::string> positionUnits;
    for (const SourceAxis& axis : chosen.table.axes)
        positionUnits.push_back(axis.unit);
    const std::string unitOfFile = chosen.table.columns.front().unit;
    AXISCOMP_TRY(const auto table,
        options.as.empty() ? asStated(environment, options, input, std::move(chosen))
                           : asConverted(environment, options, input, *as, std::move(chosen)));
    if (table.columns.size() > 1)
        return wrongUsage("the table has a value for each direction of motion: choose one with "
                          "--direction positive or negative, or mean",
            options.input.command);
    if (options.as.empty() && table.sign == SignConvention::Command)
        environment.console().note(displayName(options.input.file)
            + ": this is the command value of " + std::string(as->facts.name)
            + "; --as csv gives what the drive would compute");
    if (!options.as.empty())
        noteUnit(environment, options, table.columns.front().unit, unitOfFile);
    return answer(environment, options,
        controllerEvaluation(table, as->facts.behaviour, positionUnits),
        {{"file", options.input.file}, {"as", as->facts.name}, {"sign", signName(table.sign)},
            {"signEvidence", evidenceName(as->facts.signEvidence)},
            {"column", columnText(table, table.columns.front()).english()},
            {"unit", table.columns.front().unit}, {"positionUnits", positionUnits}});
}

Result<ExitCode> runLookup(Environment& environment, const LookupOptions& options)
{
    if (options.points.empty() == options.position.empty())
        return wrongUsage(options.points.empty() ? "give a position, or --points FILE"
                                                 : "give a position or --points, not both",
            options.input.command);
    if (options.points == standardStream && options.input.file == standardStream)
        return wrongUsage(
            "the table and the points cannot both come from standard input", options.input.command);
    if (options.as.empty() && !options.conversion.settings.empty())
        return wrongUsage("--set-out is for the format of --as", options.input.command);
    auto input = readInput(environment, options.input);
    if (!input)
        return fail(input.error());
    const bool isOwn = input->data.has_value();
    if (isOwn && options.as.empty())
        return lookUpForDrive(environment, options, *input);
    if (!options.outside.empty())
        return wrongUsage("--outside is for tables of the drive: other controllers have a rule",
            options.input.command);
    LookupOptions known = options;
    AXISCOMP_TRY(known.conversion, withSignOfFile(*input, options.conversion));
    return lookUpForController(environment, known, *input);
}

} // namespace

void addLookupCommand(CommandLine& line)
{
    auto options = std::make_shared<LookupOptions>();
    options->input.command = commandName("lookup");
    CLI::App* command = line.add("lookup", fileCommands,
        AXISCOMP_HELP("Help",
            "Print the interpolated value at a position, as the drive or the controller of the "
            "file computes it"),
        [options](Environment& environment) {
            options->conversion.lookupAt = lookupAtNamed(options->lookupAt);
            return runLookup(environment, *options);
        });
    command
        ->add_option(
            "FILE", options->input.file, AXISCOMP_HELP("Help", "Calibration file or table"))
        ->required();
    command
        ->add_option("POSITION", options->position,
            AXISCOMP_HELP("Help", "X [Y [Z]], one number per dimension; may be negative"))
        ->option_text("[X [Y [Z]]]")
        ->expected(1, 3);
    addDimensionsOption(*command, options->input);
    addTableOption(*command, options->input);
    command
        ->add_option("--points", options->points,
            AXISCOMP_HELP("Help",
                "File with one position per line, - for standard input; prints one result per "
                "line"))
        ->option_text("FILE");
    command
        ->add_option("--outside", options->outside,
            AXISCOMP_HELP("Help",
                "Value outside the table: hold (as the drive does; the default), zero, wrap, "
                "extrapolate or error"))
        ->option_text("RULE")
        ->check(CLI::IsMember(
            std::vector<std::string>{"hold", "zero", "wrap", "extrapolate", "error"}));
    command
        ->add_option("--as", options->as,
            AXISCOMP_HELP("Help",
                "Print the value that the controller of this format would apply, after conversion"))
        ->option_text("FORMAT");
    addFromOption(*command, options->input);
    addIncompleteGridOptions(*command, options->input);
    options->conversion.command = options->input.command;
    addConversionOptions(*command, options->conversion);
    addLookupOption(*command, options->lookupAt);
    addOutputOptions(*command, options->conversion);
    addProfileOption(*command, options->input.profile);
    command->footer(AXISCOMP_HELP("Help",
        "Examples:") "\n  axiscomp lookup x.csv -12.5 --dims 1"
                     "\n  axiscomp lookup plane.TAMtbl --points positions.txt --outside error"
                     "\n  axiscomp lookup x.csv 50 --dims 1 --as softmc");
}

} // namespace axiscomp::app
