// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/judging_options.h"
#include "app/cli/input/measurement_input.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/judgement_output.h"
#include "app/common/arguments.h"
#include "app/common/number_checks.h"
#include "core/metrology/judge/judgement.h"

namespace axiscomp::app {

namespace {

struct JudgeCommandOptions {
    MeasurementInputOptions input;
    CorrectionOptions correction;
    ToleranceOptions tolerance;
    std::string outliers = "mad";
    double period = 0.0; ///< in mm or deg; 0: not known
    bool wantsVdi = false;
};

Result<ExitCode> runJudge(Environment& environment, const JudgeCommandOptions& options)
{
    AXISCOMP_TRY(auto input, readMeasurements(environment, options.input));
    Measurement& measurement = input.measurement;
    if (!measurement.hasTargets())
        return fail(ErrorCode::NoTargets, {{"file", options.input.files.front()}});
    AXISCOMP_TRY(auto corrections, correct(measurement, options.correction, options.input.command));
    JudgeOptions judging;
    judging.outlierRule = outlierRuleNamed(options.outliers).value_or(OutlierRule::PooledMad);
    judging.wantsVdi = options.wantsVdi;
    if (options.period > 0.0)
        judging.period = options.period;
    AXISCOMP_TRY(auto limits,
        readTolerances(environment, measurement, options.tolerance, options.input.command));
    judging.tolerances = std::move(limits.tolerances);
    judging.uncertainty = limits.uncertainty;

    const Judgement judgement = judge(measurement, judging);
    for (const JudgeWarning& warning : judgement.warnings)
        environment.warn(warning.text.english());
    environment.print(sourcesText(input.sources) + ": " + measurementSummary(measurement) + "\n"
        + corrections.text + "\n"
        + judgementText(measurement, judgement, statedDatum(corrections.corrections.temperature)));
    Json document = judgementJson(measurement, judgement);
    document["source"] = sourcesJson(input.sources);
    document["corrections"] = std::move(corrections.document);
    document["uncertainty"] = std::move(limits.terms);
    for (const Diagnostic& diagnostic : input.warnings)
        document["warnings"].push_back(toJson(diagnostic));
    environment.document(document);
    return judgement.isWithinTolerances() ? ExitCode::Done : ExitCode::ToleranceNotMet;
}

} // namespace

void addJudgeCommand(CommandLine& line)
{
    auto options = std::make_shared<JudgeCommandOptions>();
    options->input.command = commandName("judge");
    CLI::App* command = line.add("judge", fileCommands,
        AXISCOMP_HELP(
            "Help", "Judge a measurement: figures of ISO 230-2, drift, outliers, tolerances"),
        [options](Environment& environment) { return runJudge(environment, *options); });
    addMeasurementOptions(*command, options->input);
    addToleranceOptions(*command, options->tolerance);
    command
        ->add_option("--outliers", options->outliers,
            AXISCOMP_HELP("Help", "Rule that proposes outliers: mad (the default), grubbs or none"))
        ->option_text("RULE")
        ->check(CLI::IsMember(std::vector<std::string>{"mad", "grubbs", "none"}));
    command
        ->add_option("--period", options->period,
            AXISCOMP_HELP(
                "Help", "Known period of the axis, such as the lead of its screw, in mm or deg"))
        ->option_text("P")
        ->check(numberFromZero());
    command->add_flag("--vdi", options->wantsVdi,
        AXISCOMP_HELP("Help", "Show the figures of VDI/DGQ 3441 as well"));
    addCorrectionOptions(*command, options->correction);
    command->footer(
        AXISCOMP_HELP("Help", "Examples:") "\n  axiscomp judge x.rtl --tolerance A=10um,R=4um"
                                           "\n  axiscomp judge x.csv --exclude down:1:1 --json");
}

} // namespace axiscomp::app
