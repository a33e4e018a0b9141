// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/judging_options.h"
#include "app/cli/input/measurement_input.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/judgement_output.h"
#include "app/cli/output/output_file.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/metrology/header_texts.h"

namespace axiscomp::app {

namespace {

struct RunsOptions {
    MeasurementInputOptions input;
    std::string output; ///< empty: nothing is written
};

std::string stateText(const MeasuredState& state)
{
    if (state.kind == MeasuredState::Kind::NotSaid)
        return {};
    if (state.kind == MeasuredState::Kind::Off)
        return "off";
    return state.tableCrc ? "on, table " + hexText(*state.tableCrc) : "on";
}

std::string numberText(const std::optional<double>& value, const std::string& unit)
{
    return value ? withUnit(shortText(*value), unit) : std::string();
}

std::string correctedText(MeasurementHeader::Corrected corrected)
{
    if (corrected == MeasurementHeader::Corrected::NotSaid)
        return {};
    return corrected == MeasurementHeader::Corrected::None ? "none" : "to 20 C";
}

/// What the file says of the measurement, without what it does not say.
std::vector<std::pair<std::string, std::string>> statements(const MeasurementHeader& header)
{
    std::vector<std::pair<std::string, std::string>> lines;
    const auto add = [&lines](const char* name, std::string value) {
        if (!value.empty())
            lines.emplace_back(name, std::move(value));
    };
    add("Machine", header.machine);
    add("Axis", header.axis);
    add("Instrument", header.instrument);
    add("Serial number", header.serial);
    add("Operator", header.operatorName);
    add("Date", header.date);
    add("Feed", header.feed);
    add("Dwell", header.dwell);
    add("Drive", header.drive);
    add("Compensation", stateText(header.compensation));
    add("Air temperature", numberText(header.airTemperature, "C"));
    add("Material temperature", numberText(header.materialTemperature, "C"));
    add("Expansion", numberText(header.expansion, "1/K"));
    add("Corrected", correctedText(header.corrected));
    return lines;
}

std::string runsText(const MeasurementInput& input)
{
    const Measurement& measurement = input.measurement;
    std::string text;
    for (const MeasurementSource& source : input.sources)
        text += source.file + ": " + source.format + "\n";
    text += std::string(measurementKindText(measurement.kind).words) + ": "
        + measurementSummary(measurement) + "\n";
    text += correctionLines(againstFileTexts(measurement.againstFile));
    if (measurement.excludedCount() > 0)
        text += plural(measurement.excludedCount(), "value is", "values are") + " left out\n";
    if (const auto lines = statements(measurement.header); !lines.empty())
        text += "\n" + labelled(lines, "  ");
    if (!measurement.notes.empty())
        text += "\nNotes\n";
    for (const std::string& note : measurement.notes)
        text += "  " + singleLine(note) + "\n";
    return text;
}

Json numberOrNothing(const std::optional<double>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

Json headerJson(const MeasurementHeader& header)
{
    Json json = Json::object();
    for (const HeaderText& text : headerTexts)
        json[text.key] = textOrNull(header.*text.member);
    Json compensation = nullptr;
    if (header.compensation.kind != MeasuredState::Kind::NotSaid)
        compensation = {{"active", header.compensation.kind == MeasuredState::Kind::On},
            {"crc",
                header.compensation.tableCrc ? Json(*header.compensation.tableCrc)
                                             : Json(nullptr)}};
    json["compensation"] = std::move(compensation);
    json["airTemperature"] = numberOrNothing(header.airTemperature);
    json["materialTemperature"] = numberOrNothing(header.materialTemperature);
    json["expansion"] = numberOrNothing(header.expansion);
    json["corrected"] = textOrNull(correctedText(header.corrected));
    return json;
}

Json runsJson(const MeasurementInput& input)
{
    const Measurement& measurement = input.measurement;
    Json warnings = Json::array();
    for (const Diagnostic& diagnostic : input.warnings)
        warnings.push_back(toJson(diagnostic));
    for (Json& warning : warningsJson(otherMachines(measurement)))
        warnings.push_back(std::move(warning));
    return {{"source", sourcesJson(input.sources)}, {"kind", measurementKindName(measurement.kind)},
        {"unit", positionUnit(measurement)}, {"targets", measurement.targets},
        {"runs",
            {{"up", measurement.runCount(Approach::Up)},
                {"down", measurement.runCount(Approach::Down)}}},
        {"values", measurement.values.size()}, {"excluded", measurement.excludedCount()},
        {"samples", measurement.track.size()}, {"points", measurement.points.size()},
        {"statements", headerJson(measurement.header)}, {"notes", measurement.notes},
        {"corrections", againstFileJson(measurement.againstFile)},
        {"warnings", std::move(warnings)}};
}

/// One file says one state of all its runs.
Result<void> checkOneState(const MeasurementHeader& header, const std::string& command)
{
    const std::string said = measuredStateText(header.compensationOfSome);
    if (said.empty())
        return {};
    return wrongUsage("some of the files say \"// compensation: " + said
            + "\" and others do not say what was active; say it in each of them",
        command);
}

Result<ExitCode> runRuns(Environment& environment, const RunsOptions& options)
{
    const Output output{options.output, options.input.command};
    if (!options.output.empty())
        AXISCOMP_CHECK(checkOutput(environment, output, true));
    AXISCOMP_CHECK(checkNoInput(output, options.input.files));
    AXISCOMP_TRY(const auto input, readMeasurements(environment, options.input));
    for (const JudgeWarning& warning : otherMachines(input.measurement))
        environment.warn(warning.text.english());
    if (options.output.empty()) {
        environment.print(runsText(input));
    } else {
        if (!input.measurement.hasTargets())
            return fail(ErrorCode::NoTargets, {{"file", options.input.files.front()}});
        AXISCOMP_CHECK(checkOneState(input.measurement.header, options.input.command));
        AXISCOMP_CHECK(writeOutput(environment, output, asBytes(writeRunsCsv(input.measurement))));
        if (!output.isStandardOutput())
            environment.print("Wrote " + options.output + ".\n");
    }
    environment.document(runsJson(input));
    return ExitCode::Done;
}

} // namespace

void addRunsCommand(CommandLine& line)
{
    auto options = std::make_shared<RunsOptions>();
    options->input.command = commandName("runs");
    CLI::App* command = line.add("runs", fileCommands,
        AXISCOMP_HELP(
            "Help", "Show what is in measurement files, join them, and write them as one CSV"),
        [options](Environment& environment) { return runRuns(environment, *options); });
    addMeasurementOptions(*command, options->input);
    command
        ->add_option("-o,--output", options->output,
            AXISCOMP_HELP(
                "Help", "CSV file to write, replaced if it exists; - for standard output"))
        ->option_text("FILE");
    command->footer(AXISCOMP_HELP(
        "Help", "Examples:") "\n  axiscomp runs x.rtl"
                             "\n  axiscomp runs monday.csv tuesday.csv -o both.csv"
                             "\n  axiscomp runs list.csv --columns "
                             "target=1,direction=3,deviation=5 --unit mm --value-unit um");
}

} // namespace axiscomp::app
