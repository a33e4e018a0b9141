// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input/conversion_options.h"

#include "app/common/arguments.h"
#include "app/common/number_checks.h"
#include "core/conversion/lookup_sides.h"
#include "core/conversion/unheld_notes.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/neutral/drive_note.h"
#include "core/neutral/sign_note.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <utility>

namespace axiscomp::app {

namespace {

std::optional<SignConvention> signOf(const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    return text == "feedback" ? SignConvention::Feedback : SignConvention::Command;
}

std::optional<DirectionChoice> directionOf(const std::string& text)
{
    if (text.empty())
        return std::nullopt;
    if (text == "mean")
        return DirectionChoice::Mean;
    return text == "positive" ? DirectionChoice::Positive : DirectionChoice::Negative;
}

/// Refuses by name what would be taken for an option that is not given.
CLI::Validator numberAbove(double least, const std::string& reason)
{
    return {[least, reason](const std::string& text) {
                const auto number = numberOf(text);
                return number && *number > least ? std::string() : text + ": " + reason;
            },
        "", ""};
}

/// One number for each source axis: as given, or the only one for all.
template <typename Number>
Result<std::vector<Number>> perAxis(const std::vector<Number>& given, std::size_t dimensions,
    std::string_view option, const std::string& command)
{
    if (given.size() == dimensions)
        return given;
    if (given.size() == 1)
        return std::vector<Number>(dimensions, given.front());
    return wrongUsage(std::string(option) + " needs one number, or one for each of the "
            + std::to_string(dimensions) + " source axes",
        command);
}

ResamplingMethod methodOf(const ConversionOptions& options)
{
    return resamplingMethodNamed(options.method).value_or(ResamplingMethod::Linear);
}

Result<ResamplingRequest> gridRequest(const ConversionOptions& options, std::size_t dimensions)
{
    ResamplingRequest request;
    request.method = methodOf(options);
    request.holdsEnds = options.holdsEnds;
    request.axes.resize(dimensions);
    if (!options.points.empty()) {
        AXISCOMP_TRY(
            const auto points, perAxis(options.points, dimensions, "--points", options.command));
        for (std::size_t n = 0; n < dimensions; ++n)
            request.axes[n].points = points[n];
        return request;
    }
    AXISCOMP_TRY(const auto distances,
        perAxis(options.distances, dimensions, "--distance", options.command));
    for (std::size_t n = 0; n < dimensions; ++n)
        request.axes[n].distance = distances[n];
    return request;
}

} // namespace

void addTargetOption(CLI::App& command, ConversionOptions& options)
{
    command
        .add_option("--target", options.targets,
            AXISCOMP_HELP("Help",
                "Axis that the values correct, for each column or for all: its name, #1 for the "
                "first "
                "source, or other for an axis that is no source; by default as the file says"))
        ->option_text("AXIS[,AXIS]")
        ->delimiter(',')
        ->group("Conversion");
}

void addConversionOptions(CLI::App& command, ConversionOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "Conversion");
    addTargetOption(command, options);
    command
        .add_option("--sign", options.sign,
            AXISCOMP_HELP("Help",
                "Convention of the input: feedback (added to the encoder position) or command "
                "(added "
                "to the commanded position); by default that of its format, needed where that is "
                "assumed"))
        ->option_text("SIDE")
        ->check(CLI::IsMember(std::vector<std::string>{"feedback", "command"}))
        ->group(group);
    command
        .add_option("--direction", options.direction,
            AXISCOMP_HELP("Help",
                "Which values to use if the file has both directions of motion: mean, positive or "
                "negative"))
        ->option_text("CHOICE")
        ->check(CLI::IsMember(std::vector<std::string>{"mean", "positive", "negative"}))
        ->group(group);
    command
        .add_option("--scale", options.adjustment.scale,
            AXISCOMP_HELP("Help", "Multiply the values by this number, before anything else"))
        ->option_text("FACTOR")
        ->group(group);
    command
        .add_option("--offset", options.adjustment.offset,
            AXISCOMP_HELP("Help", "Add this to the values, in their unit"))
        ->option_text("VALUE")
        ->group(group);
    command
        .add_option("--zero", options.adjustment.zero,
            AXISCOMP_HELP("Help", "Shift the values so that they are 0 at this position"))
        ->option_text("P[,P[,P]]")
        ->delimiter(',')
        ->group(group);
    command
        .add_flag("--no-wrap", options.dropsWrap,
            AXISCOMP_HELP("Help", "Treat a modulo axis as a linear one"))
        ->group(group);
}

void addResamplingOptions(CLI::App& command, ConversionOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "Conversion");
    CLI::Option* const points =
        command
            .add_option("--points", options.points,
                AXISCOMP_HELP(
                    "Help", "Resample onto an even grid with N points, for each source or for all"))
            ->option_text("N[,N[,N]]")
            ->delimiter(',')
            ->check(numberAbove(1.0, "a grid has at least 2 points"))
            ->group(group);
    CLI::Option* const distance =
        command
            .add_option("--distance", options.distances,
                AXISCOMP_HELP("Help",
                    "Resample onto an even grid with spacing D, for each source or for all"))
            ->option_text("D[,D[,D]]")
            ->delimiter(',')
            ->check(numberAbove(0.0, "a distance is above 0"))
            ->excludes(points)
            ->group(group);
    command
        .add_option("--within", options.within,
            AXISCOMP_HELP("Help",
                "Resample onto the coarsest even grid within this deviation, in the unit of the "
                "values"))
        ->option_text("DEVIATION")
        ->excludes(points)
        ->excludes(distance)
        ->group(group);
    command
        .add_option("--method", options.method,
            AXISCOMP_HELP("Help",
                "Between the points of the source: linear (the default), cubic (monotone), spline "
                "(natural cubic) or smooth (smoothing spline)"))
        ->option_text("METHOD")
        ->check(CLI::IsMember(std::vector<std::string>{"linear", "cubic", "spline", "smooth"}))
        ->group(group);
    command
        .add_option("--speed", options.speed,
            AXISCOMP_HELP("Help",
                "Speed of the axis in positions per second: says the steps of the velocity that "
                "are "
                "left with spline and smooth"))
        ->option_text("SPEED")
        ->check(numberAboveZero())
        ->group(group);
    command
        .add_flag("--hold", options.holdsEnds,
            AXISCOMP_HELP(
                "Help", "Let the even grid extend beyond the data, where the end values are held"))
        ->group(group);
}

void addOutputOptions(CLI::App& command, ConversionOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "Conversion");
    command
        .add_option("--to-sign", options.toSign,
            AXISCOMP_HELP("Help",
                "Convention of the output: feedback or command; by default that of its format, "
                "needed "
                "where that is assumed"))
        ->option_text("SIDE")
        ->check(CLI::IsMember(std::vector<std::string>{"feedback", "command"}))
        ->group(group);
    command
        .add_option("--set-out", options.settings,
            AXISCOMP_HELP(
                "Help", "Setting that the output format needs; `axiscomp formats NAME` lists them"))
        ->option_text("KEY=VALUE")
        ->group(group);
}

Result<ConversionRequest> conversionRequest(const ConversionOptions& options,
    const TableFormat& from, const TableFormat& to, std::size_t dimensions)
{
    ConversionRequest request;
    request.from = &from;
    request.to = &to;
    request.sourceSign = signOf(options.sign);
    request.targetSign = signOf(options.toSign);
    request.targets = options.targets;
    request.units = options.units;
    request.lookupAt = options.lookupAt;
    request.adjustment = options.adjustment;
    request.direction = directionOf(options.direction);
    request.dropsWrap = options.dropsWrap;
    request.speed = options.speed;
    if (!options.resamples() && (options.method != "linear" || options.speed))
        return wrongUsage("--method and --speed belong to an even grid: give --points, --distance "
                          "or --within",
            options.command);
    if (options.within) {
        request.resampling = WantedDeviation{*options.within, methodOf(options)};
    } else if (options.resamples()) {
        AXISCOMP_TRY(auto grid, gridRequest(options, dimensions));
        request.resampling = std::move(grid);
    }
    AXISCOMP_TRY(auto settings, settingsOf(options.settings, options.command));
    request.writing.settings = std::move(settings);
    return request;
}

CLI::Option* addLookupOption(CLI::App& command, std::string& lookupAt, std::string help)
{
    return command.add_option("--lookup-at", lookupAt, std::move(help))
        ->option_text("WHERE")
        ->check(CLI::IsMember(std::vector<std::string>{"encoder", "set"}));
}

void addLookupOption(CLI::App& command, std::string& lookupAt)
{
    addLookupOption(command, lookupAt,
        AXISCOMP_HELP("Help",
            "Where the drive looks its table up (the input or the output, whichever is the "
            "drive's): encoder (before the compensation) or set (after it); by default as the "
            "file says, or encoder"))
        ->group(AXISCOMP_HELP("Help", "Conversion"));
}

std::vector<std::string> ConversionOptions::given() const
{
    const std::array<std::pair<bool, const char*>, 14> all{
        {{!targets.empty(), "--target"}, {!sign.empty(), "--sign"}, {!toSign.empty(), "--to-sign"},
            {lookupAt.has_value(), "--lookup-at"}, {!direction.empty(), "--direction"},
            {adjustment.scale != 1.0, "--scale"}, {adjustment.offset != 0.0, "--offset"},
            {!adjustment.zero.empty(), "--zero"}, {dropsWrap, "--no-wrap"},
            {!points.empty(), "--points"}, {!distances.empty(), "--distance"},
            {within.has_value(), "--within"}, {method != "linear" || speed, "--method or --speed"},
            {!settings.empty(), "--set-out"}}};
    std::vector<std::string> names;
    for (const auto& [isGiven, name] : all)
        if (isGiven)
            names.emplace_back(name);
    return names;
}

Result<ConversionOptions> withSignOfFile(const TableInput& input, ConversionOptions options)
{
    if (!input.data)
        return options;
    AXISCOMP_TRY(const auto sign, signOfTable(input.data->notes, signOf(options.sign)));
    if (sign)
        options.sign = signName(*sign);
    return options;
}

bool isOfDrive(const TableInput& input, const ConversionOptions& options)
{
    const auto known = withSignOfFile(input, options);
    return axiscomp::isOfDrive(*input.format, signOf(known ? known->sign : options.sign));
}

Result<DriveTable> driveTable(
    const TableInput& input, const TableInputOptions& inputOptions, const ConversionOptions& stated)
{
    AXISCOMP_TRY(const auto options, withSignOfFile(input, stated));
    DriveTable result;
    if (input.data && isOfDrive(input, options)) {
        AXISCOMP_TRY(result.lookupAt, lookupInNotes(input.data->notes));
    }
    if (input.data && !options.isAnything()) {
        AXISCOMP_TRY(result.measuredDrive, measuredDriveInNotes(input.data->notes));
        AXISCOMP_TRY(const auto index, chooseTable(*input.data, inputOptions));
        result.table = input.data->tables[index];
        takeStatedUnits(result.table, options.units);
        return result;
    }
    AXISCOMP_TRY(const auto chosen, chosenColumn(neutralTables(input), inputOptions));
    AXISCOMP_TRY(result.measuredDrive, measuredDriveInNotes(chosen.table.notes));
    AXISCOMP_TRY(auto request,
        conversionRequest(
            options, *input.format, calibration_csv::format(), chosen.table.axes.size()));
    request.beside = chosen.beside;
    AXISCOMP_TRY(const auto conversion, convertTables(std::span(&chosen.table, 1), request));
    const std::vector<Text> losses = conversionLosses(conversion);
    for (const Text& line : conversionReport(conversion, request))
        result.report.push_back(displayName(inputOptions.file)
            + (std::ranges::find(losses, line) == losses.end() ? ": " : ": warning: ")
            + line.english());
    AXISCOMP_TRY(auto data, calibrationData(conversion.written.held.front()));
    result.table = std::move(data.tables.front());
    if (const auto lookupAt = conversion.tables.front().lookupAt)
        result.lookupAt = lookupAt;
    return result;
}

void noteReport(Environment& environment, const std::vector<std::string>& report)
{
    for (const std::string& line : report)
        environment.console().note(line);
}

Result<void> noteUnheld(
    Environment& environment, std::string_view before, std::span<const std::string> notes)
{
    AXISCOMP_TRY(const auto unheld, unheldNotes(tam_table::format().facts, notes));
    for (const Text& remark : unheld)
        environment.console().note(std::string(before) + ": " + remark.english());
    return {};
}

} // namespace axiscomp::app
