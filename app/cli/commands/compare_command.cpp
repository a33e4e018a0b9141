// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/commands/fit_record.h"
#include "app/cli/commands/record_figures.h"
#include "app/cli/input/judging_options.h"
#include "app/cli/input/measurement_input.h"
#include "app/cli/input/table_input.h"
#include "app/cli/output/comparison_output.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/judgement_output.h"
#include "app/common/arguments.h"
#include "core/io/local_file.h"
#include "core/metrology/record/comparison.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

struct CompareOptions {
    MeasurementInputOptions input; ///< with both files, or the second alone
    CorrectionOptions correction; ///< of the second measurement
    std::string record;
    std::string measuredWith; ///< "on": with the table of the record
    bool keeps = false; ///< the second measurement goes into the record
    ToleranceOptions tolerance;
};

/// One of the two, as its figures are made.
struct Side {
    MeasurementInput input; ///< with the measurement that is judged
    MadeCorrections corrections;
};

Result<MeasurementInput> readSide(
    Environment& environment, const MeasurementInputOptions& options, const std::string& file)
{
    MeasurementInputOptions input = options;
    input.files = {file};
    input.keepsFiles = true;
    AXISCOMP_TRY(auto read, readMeasurements(environment, input));
    if (!read.measurement.hasTargets())
        return fail(ErrorCode::NoTargets, {{"file", file}});
    return read;
}

/// The first measurement is the one that the table was made of: no other belongs beside what was
/// promised of it.
Result<void> checkIsOfRecord(Environment& environment, const CompareOptions& options,
    const RecordedMeasurement& before, const std::string& file)
{
    AXISCOMP_TRY(const auto sha256, measurementSha256(environment, file));
    if (std::ranges::find(before.files, sha256, &RecordedFile::sha256) != before.files.end())
        return {};
    std::string names;
    for (const RecordedFile& recorded : before.files)
        names += (names.empty() ? "" : ", ") + recorded.file;
    return wrongUsage(displayName(file) + " is not the measurement that the record was made of ("
            + names
            + ") or has changed since; name the second measurement alone, since the record has the "
              "first: "
            + options.input.command + " " + displayName(options.input.files.back()) + " --record "
            + options.record,
        options.input.command);
}

/// As the table was made of it: with its exclusions and corrections.
Result<Side> sideOfRecord(const RecordedMeasurement& before)
{
    Side side;
    AXISCOMP_TRY(auto made, correctedMeasurement(before));
    side.corrections =
        madeCorrections(made, {before.corrections.temperature, before.corrections.deadPath});
    side.input.measurement = std::move(made.measurement);
    for (const RecordedFile& recorded : before.files)
        side.input.sources.push_back({recorded.file, recorded.format, recorded.sha256});
    // The second measurement may begin elsewhere, and is to be corrected from the same position.
    if (auto& temperature = side.corrections.corrections.temperature)
        temperature->datum = datumOf(*temperature, side.input.measurement);
    return side;
}

Result<Side> firstSide(
    Environment& environment, const CompareOptions& options, const CalibrationRecord& record)
{
    const std::vector<std::string>& files = options.input.files;
    if (record.before && !record.before->files.empty()) {
        if (files.size() == 2)
            AXISCOMP_CHECK(checkIsOfRecord(environment, options, *record.before, files.front()));
        return sideOfRecord(*record.before);
    }
    if (files.size() == 1)
        return wrongUsage(
            "give the measurement before and the one after; the second alone is enough with a "
            "--record that has the first",
            options.input.command);
    MeasurementInputOptions reading = options.input;
    reading.excluded.clear(); // of the second measurement
    Side side;
    AXISCOMP_TRY(side.input, readSide(environment, reading, files.front()));
    AXISCOMP_TRY(side.corrections, correct(side.input.measurement, {}, options.input.command));
    return side;
}

/// Corrected like the first one.
Result<Side> secondSide(Environment& environment, const CompareOptions& options, const Side& first)
{
    Side side;
    AXISCOMP_TRY(side.input, readSide(environment, options.input, options.input.files.back()));
    Measurement& measurement = side.input.measurement;
    CorrectionOptions correction = options.correction;
    if (!measurement.isAngular) {
        AXISCOMP_TRY(correction,
            correctedLike(first.corrections.corrections, measurement, options.correction,
                options.input.command));
    }
    AXISCOMP_TRY(side.corrections, correct(measurement, correction, options.input.command));
    return side;
}

/// They differ by the temperature, not by what the compensation has done.
Result<void> checkCorrections(
    Environment& environment, const CompareOptions& options, const Side& before, const Side& after)
{
    const auto sideOf = [](const Side& side) {
        return CorrectedSide{
            side.input.measurement, side.corrections.corrections.deadPath.has_value()};
    };
    switch (areCorrectedAlike(sideOf(before), sideOf(after))) {
    case CorrectedAlike::Yes:
        break;
    case CorrectedAlike::AfterIsNot:
        return wrongUsage("the first measurement is corrected and the second is not, so that they "
                          "cannot be compared: give what the correction needs (--temperature and "
                          "--expansion, --dead-path), or state in the file of the second that its "
                          "values are at 20 C (// corrected: 20C)",
            options.input.command);
    case CorrectedAlike::BeforeIsNot:
        environment.warn("the second measurement is corrected for temperature or dead path and the "
                         "first is not, so that they cannot be compared");
        break;
    }
    return {};
}

/// The second measurement, what it says of the prediction, and the verdict.
Result<void> keepInRecord(Environment& environment, CalibrationRecord record,
    const CompareOptions& options, const Side& after, const Comparison& comparison)
{
    AXISCOMP_TRY(auto recorded, recordedMeasurement(after.input, options.input, after.corrections));
    keepAfter(record, std::move(recorded), comparison);
    AXISCOMP_CHECK(saveRecord(pathFromText(options.record), record));
    keepFiguresOrWarn(environment, record);
    return {};
}

Json bothSources(const MeasurementInput& before, const MeasurementInput& after)
{
    return {{"before", sourcesJson(before.sources)}, {"after", sourcesJson(after.sources)}};
}

/// What is promised and what decides, by the record and by the options.
ComparisonRequest requestOf(
    const CompareOptions& options, const CalibrationRecord& record, const ToleranceLimits& limits)
{
    ComparisonRequest request = comparisonRequest(record);
    request.isTableStated = !options.measuredWith.empty();
    if (!limits.tolerances.empty())
        request.tolerances = limits.tolerances;
    if (limits.uncertainty)
        request.uncertainty = limits.uncertainty;
    return request;
}

/// From which what is left is shown.
std::optional<PlacedDeviation> datumAfter(
    const Side& before, const Side& after, const Comparison& comparison)
{
    const auto stated = [](const Side& side) {
        return statedDatum(side.corrections.corrections.temperature);
    };
    return deviationDatums({comparison.before, stated(before)}, {comparison.after, stated(after)})
        .after;
}

/// What a person reads, and what a program does.
void tellComparison(Environment& environment, const Side& before, const Side& after,
    const Comparison& comparison, Json uncertainty)
{
    const Measurement& second = after.input.measurement;
    for (const JudgeWarning& warning : comparison.warnings)
        environment.warn(warning.text.english());
    environment.print("Before: " + sourcesText(before.input.sources) + "\n"
        + before.corrections.text + "After:  " + sourcesText(after.input.sources) + "\n"
        + after.corrections.text + "\n"
        + comparisonText(second, comparison, datumAfter(before, after, comparison)));
    Json document = comparisonJson(second, comparison);
    document["source"] = bothSources(before.input, after.input);
    document["corrections"] = after.corrections.document;
    document["correctionsBefore"] = before.corrections.document;
    document["uncertainty"] = std::move(uncertainty);
    document["excluded"] = {
        {"before", excludedJson(before.input.measurement)}, {"after", excludedJson(second)}};
    for (const Side* side : {&before, &after})
        for (const Diagnostic& diagnostic : side->input.warnings)
            document["warnings"].push_back(toJson(diagnostic));
    environment.document(document);
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
    AXISCOMP_TRY(const auto before, firstSide(environment, options, record));
    AXISCOMP_TRY(const auto after, secondSide(environment, options, before));
    AXISCOMP_CHECK(checkCorrections(environment, options, before, after));
    const Measurement& second = after.input.measurement;
    AXISCOMP_TRY(
        auto limits, readTolerances(environment, second, options.tolerance, options.input.command));
    AXISCOMP_TRY(const auto comparison,
        compareMeasurements(before.input.measurement, second, requestOf(options, record, limits)));
    if (options.keeps)
        AXISCOMP_CHECK(keepInRecord(environment, std::move(record), options, after, comparison));
    tellComparison(environment, before, after, comparison, std::move(limits.terms));
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
        ->description(AXISCOMP_HELP("Help",
            "Measurement before and measurement after; with a record, which has the first, the "
            "second alone is enough"))
        ->option_text("[BEFORE] AFTER")
        ->expected(1, 2);
    command->get_option("--exclude")
        ->description(AXISCOMP_HELP("Help",
            "Leave values of the second measurement out: down:1:1 (direction, target, run), "
            "run:up:3 or target:7, with commas between them"));
    command
        ->add_option("--record", options->record,
            AXISCOMP_HELP("Help",
                "Record of the compensation: the first measurement with its exclusions and "
                "corrections, prediction, table and tolerances"))
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
    addCorrectionOptions(*command, options->correction);
    command->footer(AXISCOMP_HELP(
        "Help", "Examples:") "\n  axiscomp compare before.rtl after.rtl --tolerance A=10um"
                             "\n  axiscomp compare before.rtl after.rtl --record x.axcal --keep"
                             "\n  axiscomp compare after.rtl --record x.axcal --temperature 22.5");
}

} // namespace axiscomp::app
