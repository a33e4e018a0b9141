// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/commands/record_figures.h"
#include "app/cli/input/judging_options.h"
#include "app/cli/input/measurement_input.h"
#include "app/cli/output/comparison_output.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/judgement_output.h"
#include "app/common/arguments.h"
#include "core/io/local_file.h"
#include "core/metrology/run_selection.h"

namespace axiscomp::app {

namespace {

struct CompareOptions {
    MeasurementInputOptions input; ///< with both files
    std::string record;
    std::string measuredWith; ///< "on": with the table of the record
    bool keeps = false; ///< the second measurement goes into the record
    ToleranceOptions tolerance;
};

Result<MeasurementInput> readSide(
    Environment& environment, const CompareOptions& options, std::size_t side)
{
    MeasurementInputOptions input = options.input;
    input.files = {options.input.files[side]};
    input.swapsDirections = false; // a record holds what was read
    AXISCOMP_TRY(auto read, readMeasurements(environment, input));
    if (!read.measurement.hasTargets())
        return fail(ErrorCode::NoTargets, {{"file", input.files.front()}});
    return read;
}

Measurement usedSide(const MeasurementInput& input, const CompareOptions& options)
{
    Measurement measurement = input.measurement;
    if (options.input.swapsDirections)
        swapDirections(measurement);
    return measurement;
}

/// The second measurement, what it says of the prediction, and the verdict.
Result<void> keepInRecord(Environment& environment, CalibrationRecord record,
    const CompareOptions& options, const MeasurementInput& after, const Comparison& comparison)
{
    const MeasurementSource& source = after.sources.front();
    RecordedMeasurement recorded;
    recorded.files = {{source.file, source.format, source.sha256, after.measurement}};
    recorded.swapsDirections = options.input.swapsDirections;
    keepAfter(record, std::move(recorded), comparison);
    AXISCOMP_CHECK(saveRecord(pathFromText(options.record), record));
    keepFiguresOrWarn(environment, record);
    return {};
}

Json bothSources(const MeasurementInput& before, const MeasurementInput& after)
{
    return {{"before", sourcesJson(before.sources)}, {"after", sourcesJson(after.sources)}};
}

Result<ExitCode> runCompare(Environment& environment, const CompareOptions& options)
{
    if (options.record.empty() && (options.keeps || !options.measuredWith.empty()))
        return wrongUsage(
            "--keep and --measured-with belong to a record: give --record", options.input.command);
    CalibrationRecord record;
    if (!options.record.empty()) {
        AXISCOMP_TRY(record, loadRecord(pathFromText(options.record)));
    }
    AXISCOMP_TRY(const auto before, readSide(environment, options, 0));
    AXISCOMP_TRY(const auto after, readSide(environment, options, 1));
    const Measurement second = usedSide(after, options);
    AXISCOMP_TRY(auto limits, readTolerances(second, options.tolerance, options.input.command));
    ComparisonRequest request = comparisonRequest(record);
    request.isTableStated = !options.measuredWith.empty();
    if (!limits.tolerances.empty())
        request.tolerances = limits.tolerances;
    if (limits.uncertainty)
        request.uncertainty = limits.uncertainty;
    AXISCOMP_TRY(
        const auto comparison, compareMeasurements(usedSide(before, options), second, request));
    if (options.keeps)
        AXISCOMP_CHECK(keepInRecord(environment, std::move(record), options, after, comparison));

    environment.print("Before: " + sourcesText(before.sources)
        + "\nAfter:  " + sourcesText(after.sources) + "\n\n" + comparisonText(second, comparison));
    Json document = comparisonJson(second, comparison);
    document["source"] = bothSources(before, after);
    document["uncertainty"] = std::move(limits.terms);
    document["warnings"] = Json::array();
    for (const MeasurementInput* side : {&before, &after})
        for (const Diagnostic& diagnostic : side->warnings)
            document["warnings"].push_back(toJson(diagnostic));
    environment.document(document);
    return comparison.isWithinTolerances() ? ExitCode::Done : ExitCode::ToleranceNotMet;
}

} // namespace

void addCompareCommand(CommandLine& line)
{
    auto options = std::make_shared<CompareOptions>();
    options->input.command = commandName("compare");
    CLI::App* command = line.add("compare", fileCommands,
        AXISCOMP_HELP("Help",
            "Compare measurements before and after a compensation, and with what was promised"),
        [options](Environment& environment) { return runCompare(environment, *options); });
    addMeasurementOptions(*command, options->input);
    command->get_option("FILE")
        ->description(AXISCOMP_HELP("Help", "Measurement before and measurement after"))
        ->option_text("BEFORE AFTER")
        ->expected(2);
    command->remove_option(command->get_option("--exclude"));
    command
        ->add_option("--record", options->record,
            AXISCOMP_HELP(
                "Help", "Record of the compensation: its prediction, table and tolerances"))
        ->option_text("FILE.axcal");
    command
        ->add_option("--measured-with", options->measuredWith,
            AXISCOMP_HELP("Help",
                "on: the second measurement was made with the table of the record active, where "
                "its "
                "file does not say it"))
        ->option_text("on")
        ->check(CLI::IsMember(std::vector<std::string>{"on"}));
    command->add_flag("--keep", options->keeps,
        AXISCOMP_HELP("Help", "Add the second measurement and the verdict to the record"));
    addToleranceOptions(*command, options->tolerance);
    command->footer(AXISCOMP_HELP(
        "Help", "Examples:") "\n  axiscomp compare before.rtl after.rtl --tolerance A=10um"
                             "\n  axiscomp compare before.rtl after.rtl --record x.axcal --keep");
}

} // namespace axiscomp::app
