// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input/measurement_input.h"

#include "app/cli/input/table_input.h"
#include "app/common/arguments.h"
#include "app/common/number_checks.h"
#include "app/common/number_text.h"
#include "app/common/standard_streams.h"
#include "core/base/sha256.h"
#include "core/io/local_file.h"
#include "core/metrology/run_selection.h"

#include <algorithm>
#include <filesystem>

namespace axiscomp::app {

namespace {

Result<MeasurementReadOptions> readOptionsOf(
    Environment& environment, const MeasurementInputOptions& options)
{
    MeasurementReadOptions reading;
    if (!options.columns.empty()) {
        AXISCOMP_TRY(auto columns, columnMappingFromText(options.columns));
        reading.columns = std::move(columns);
    }
    reading.skippedLines = options.skippedLines;
    reading.unit = options.unit;
    reading.valueUnit = options.valueUnit;
    if (!options.values.empty())
        reading.values = options.values == "reference" ? MeasurementReadOptions::Values::Reference
                                                       : MeasurementReadOptions::Values::Deviation;
    reading.takesDirectionFromOrder = !options.directionFrom.empty();
    reading.invertsReference = options.invertsReference;
    reading.overrun = options.overrun;
    reading.stop = environment.stopToken();
    return reading;
}

Result<std::string> wholeFile(
    Environment& environment, const std::string& file, std::size_t maximumBytes)
{
    if (file == standardStream)
        return readStandardInput(environment.interrupt(), maximumBytes);
    AXISCOMP_TRY(const auto bytes, loadFile(pathFromText(file), maximumBytes));
    return std::string(asText(bytes));
}

Result<Measurement> readOne(Environment& environment, const MeasurementInputOptions& options,
    const MeasurementReadOptions& reading, const std::string& file, MeasurementInput& input)
{
    AXISCOMP_TRY(const auto text, wholeFile(environment, file, reading.maximumBytes));
    const std::string name = pathFromText(file).filename().string();
    AXISCOMP_TRY(const auto format,
        options.from.empty() ? chooseMeasurementFormat(text, name, reading)
                             : measurementFormatNamed(options.from));
    MeasurementReading result = format->read(text, reading);
    if (result.cancelled)
        return fail(ErrorCode::Cancelled);
    const std::string shown = displayName(file);
    environment.diagnose(shown, result.diagnostics);
    if (result.suppressed > 0)
        environment.console().note(shown + ": "
            + plural(result.suppressed, "further error is", "further errors are") + " not listed");
    if (!result.measurement)
        return fail(measurementError(shown, result));
    input.warnings.insert(
        input.warnings.end(), result.diagnostics.begin(), result.diagnostics.end());
    input.sources.push_back(
        {environment.nameOf(file), std::string(format->facts.name), sha256Of(asBytes(text))});
    return std::move(*result.measurement);
}

} // namespace

void addMeasurementOptions(CLI::App& command, MeasurementInputOptions& options)
{
    command
        .add_option("FILE", options.files,
            AXISCOMP_HELP(
                "Help", "Measurement files, joined when there are several; - for standard input"))
        ->required();
    command
        .add_option("--from", options.from,
            AXISCOMP_HELP("Help", "Format of the files, if their content leaves it open"))
        ->option_text("FORMAT");
    command
        .add_option("--exclude", options.excluded,
            AXISCOMP_HELP("Help",
                "Leave values out: down:1:1 (direction, target, run), run:up:3 or target:7, with "
                "commas "
                "between them"))
        ->option_text("WHAT");
    command.add_flag("--swap-directions", options.swapsDirections,
        AXISCOMP_HELP("Help", "Exchange up and down"));
    const std::string group = AXISCOMP_HELP("Help", "What a file leaves open");
    command
        .add_option("--columns", options.columns,
            AXISCOMP_HELP("Help",
                "Which column of a CSV file is what, by number or name: 'target=1,direction=3,"
                "deviation=5'"))
        ->option_text("MAPPING")
        ->group(group);
    command
        .add_option("--skip-lines", options.skippedLines,
            AXISCOMP_HELP("Help", "Lines before the header of a CSV file"))
        ->option_text("N")
        ->group(group);
    command
        .add_option("--unit", options.unit, AXISCOMP_HELP("Help", "Unit of targets and encoder"))
        ->option_text("UNIT")
        ->group(group);
    command
        .add_option("--value-unit", options.valueUnit,
            AXISCOMP_HELP("Help", "Unit of deviations and reference"))
        ->option_text("UNIT")
        ->group(group);
    command
        .add_option("--values", options.values,
            AXISCOMP_HELP("Help",
                "What the values are: deviation (reference minus target) or reference (positions)"))
        ->option_text("KIND")
        ->check(CLI::IsMember(std::vector<std::string>{"deviation", "reference"}))
        ->group(group);
    command
        .add_option("--direction-from", options.directionFrom,
            AXISCOMP_HELP(
                "Help", "order: the direction of a run follows from the order of its targets"))
        ->option_text("order")
        ->check(CLI::IsMember(std::vector<std::string>{"order"}))
        ->group(group);
    command
        .add_flag("--invert-reference", options.invertsReference,
            AXISCOMP_HELP("Help", "The instrument counts the other way"))
        ->group(group);
    command
        .add_option("--overrun", options.overrun,
            AXISCOMP_HELP("Help",
                "How far a track moves after a turn before its samples count, in mm or deg; 1 % of "
                "the "
                "range unless given"))
        ->option_text("DISTANCE")
        ->check(numberFromZero())
        ->group(group);
}

Result<MeasurementInput> readMeasurements(
    Environment& environment, const MeasurementInputOptions& options)
{
    AXISCOMP_TRY(const auto reading, readOptionsOf(environment, options));
    if (std::ranges::count(options.files, standardStream) > 1)
        return wrongUsage("standard input can be read once", options.command);
    MeasurementInput input;
    std::vector<Measurement> measurements;
    for (const std::string& file : options.files) {
        AXISCOMP_TRY(auto measurement, readOne(environment, options, reading, file, input));
        measurements.push_back(std::move(measurement));
    }
    std::vector<Exclusion> exclusions;
    if (!options.excluded.empty()) {
        AXISCOMP_TRY(exclusions, exclusionsFromText(options.excluded));
    }
    AXISCOMP_TRY(input.measurement, selected(measurements, options.swapsDirections, exclusions));
    if (options.keepsFiles)
        input.files = std::move(measurements);
    return input;
}

Result<std::string> measurementSha256(Environment& environment, const std::string& file)
{
    AXISCOMP_TRY(
        const auto text, wholeFile(environment, file, MeasurementReadOptions{}.maximumBytes));
    return sha256Of(asBytes(text));
}

Json sourcesJson(const std::vector<MeasurementSource>& sources)
{
    Json list = Json::array();
    for (const MeasurementSource& source : sources)
        list.push_back(
            {{"file", source.file}, {"format", source.format}, {"sha256", source.sha256}});
    return list;
}

std::string sourcesText(const std::vector<MeasurementSource>& sources)
{
    std::string names;
    for (const MeasurementSource& source : sources)
        names += (names.empty() ? "" : ", ") + source.file + " (" + source.format + ")";
    return names;
}

} // namespace axiscomp::app
