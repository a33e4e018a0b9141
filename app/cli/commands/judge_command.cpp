// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/measurement_input.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/judgement_output.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "core/io/local_file.h"
#include "core/metrology/judge/corrections.h"
#include "core/metrology/judge/judgement.h"

namespace axiscomp::app {

namespace {

struct JudgeCommandOptions {
    MeasurementInputOptions input;
    std::string tolerances;
    std::string uncertainty; ///< "U=2.1um", or a file with the budget
    std::string outliers = "mad";
    double period = 0.0; ///< in mm or deg; 0: not known
    bool wantsVdi = false;
    std::optional<double> temperature;
    std::optional<double> expansion;
    double referenceTemperature = 20.0;
    double referenceExpansion = 0.0;
    std::optional<double> datum;
    bool isNotCorrected = false;
};

Json sourcesJson(const std::vector<MeasurementSource>& sources)
{
    Json list = Json::array();
    for (const MeasurementSource& source : sources)
        list.push_back(
            {{"file", source.file}, {"format", source.format}, {"sha256", source.sha256}});
    return list;
}

/// The measurement as it would be at 20 deg C, when the user asked for it.
Result<Json> correct(Measurement& measurement, const JudgeCommandOptions& options)
{
    if (!options.temperature && !options.expansion)
        return Json::object();
    TemperatureCorrection correction;
    const auto temperature =
        options.temperature ? options.temperature : measurement.header.materialTemperature;
    const auto expansion = options.expansion ? options.expansion : measurement.header.expansion;
    if (!temperature)
        return wrongUsage(
            "the temperature of the scale is not known: give --temperature", options.input.command);
    if (!expansion)
        return wrongUsage("the coefficient of expansion of the scale is not known: give "
                          "--expansion; for steel it is about 11.5e-6",
            options.input.command);
    correction.materialCelsius = *temperature;
    correction.expansionPerKelvin = *expansion;
    correction.referenceCelsius = options.referenceTemperature;
    correction.referenceExpansionPerKelvin = options.referenceExpansion;
    correction.datum = options.datum;
    correction.isConfirmed = options.isNotCorrected;
    AXISCOMP_TRY(measurement, correctedForTemperature(std::move(measurement), correction));
    return Json{{"temperature",
        {{"material", *temperature}, {"expansion", *expansion},
            {"reference", correction.referenceCelsius},
            {"referenceExpansion", correction.referenceExpansionPerKelvin},
            {"datum", correction.datum.value_or(measurement.targets.front())}}}};
}

Json uncertaintyJson(const Uncertainty& terms)
{
    return {{"U", terms.total}, {"device", terms.device}, {"misalignment", terms.misalignment},
        {"temperature", terms.temperature}, {"coefficient", terms.coefficient},
        {"environment", terms.environment}};
}

/// "U=2.1um", or the terms of a budget in a file.
Result<Json> takeUncertainty(
    const Measurement& measurement, const JudgeCommandOptions& options, JudgeOptions& judging)
{
    if (options.uncertainty.empty())
        return Json(nullptr);
    if (options.uncertainty.starts_with("U=")) {
        AXISCOMP_TRY(judging.uncertainty,
            amountFromText(options.uncertainty.substr(2), measurement.isAngular));
        return Json{{"U", *judging.uncertainty}};
    }
    if (measurement.isAngular)
        return wrongUsage(
            "a budget is for lengths; for angles give the uncertainty itself, such as "
            "--uncertainty U=2arcsec",
            options.input.command);
    constexpr std::uint64_t mostBytes = 64 * 1024;
    AXISCOMP_TRY(const auto bytes, loadFile(options.uncertainty, mostBytes));
    AXISCOMP_TRY(const auto budget, uncertaintyBudgetFromJson(asText(bytes), measurement.range()));
    const Uncertainty terms = uncertaintyOf(budget);
    judging.uncertainty = terms.total;
    return uncertaintyJson(terms);
}

std::string headline(const MeasurementInput& input)
{
    std::string names;
    for (const MeasurementSource& source : input.sources)
        names += (names.empty() ? "" : ", ") + source.file + " (" + source.format + ")";
    return names + ": " + measurementSummary(input.measurement) + "\n";
}

Result<ExitCode> runJudge(Environment& environment, const JudgeCommandOptions& options)
{
    AXISCOMP_TRY(auto input, readMeasurements(environment, options.input));
    Measurement& measurement = input.measurement;
    if (!measurement.hasTargets())
        return fail(ErrorCode::NoTargets, {{"file", options.input.files.front()}});
    AXISCOMP_TRY(auto corrections, correct(measurement, options));
    JudgeOptions judging;
    judging.outlierRule = outlierRuleNamed(options.outliers).value_or(OutlierRule::PooledMad);
    judging.wantsVdi = options.wantsVdi;
    if (options.period > 0.0)
        judging.period = options.period;
    if (!options.tolerances.empty()) {
        AXISCOMP_TRY(
            judging.tolerances, tolerancesFromText(options.tolerances, measurement.isAngular));
    }
    AXISCOMP_TRY(auto uncertainty, takeUncertainty(measurement, options, judging));

    const Judgement judgement = judge(measurement, judging);
    for (const JudgeWarning& warning : judgement.warnings)
        environment.warn(warning.text.english());
    environment.print(headline(input) + "\n" + judgementText(measurement, judgement));
    Json document = judgementJson(measurement, judgement);
    document["source"] = sourcesJson(input.sources);
    document["corrections"] = std::move(corrections);
    document["uncertainty"] = std::move(uncertainty);
    for (const Diagnostic& diagnostic : input.warnings)
        document["warnings"].push_back(toJson(diagnostic));
    environment.document(document);
    return judgement.isWithinTolerances() ? ExitCode::Done : ExitCode::ToleranceNotMet;
}

void addCorrectionOptions(CLI::App& command, JudgeCommandOptions& options)
{
    const std::string group = "Correction to 20 C, made only when asked for";
    command
        .add_option("--temperature", options.temperature, "Temperature of the axis's scale in C")
        ->option_text("C")
        ->group(group);
    command
        .add_option("--expansion", options.expansion,
            "Coefficient of expansion of the axis's scale in 1/K, such as 11.5e-6")
        ->option_text("PER_K")
        ->group(group);
    command
        .add_option("--reference-temperature", options.referenceTemperature,
            "Temperature of the reference in C")
        ->option_text("C")
        ->group(group);
    command
        .add_option("--reference-expansion", options.referenceExpansion,
            "Coefficient of the reference in 1/K; 0 for a laser with wavelength compensation")
        ->option_text("PER_K")
        ->group(group);
    command
        .add_option("--datum", options.datum,
            "Position in mm that does not move with temperature; the first target unless given")
        ->option_text("POSITION")
        ->group(group);
    command
        .add_flag("--not-corrected", options.isNotCorrected,
            "The values are not corrected to 20 C, where the file does not say it")
        ->group(group);
}

} // namespace

void addJudgeCommand(CommandLine& line)
{
    auto options = std::make_shared<JudgeCommandOptions>();
    options->input.command = commandName("judge");
    CLI::App* command = line.add("judge", fileCommands,
        "Judge a measurement: figures of ISO 230-2, drift, outliers, tolerances",
        [options](Environment& environment) { return runJudge(environment, *options); });
    addMeasurementOptions(*command, options->input);
    command
        ->add_option("--tolerance", options->tolerances,
            "Limits, such as A=10um,R=4um; exit code 8 when one is not met")
        ->option_text("FIGURE=LIMIT,...");
    command
        ->add_option("--uncertainty", options->uncertainty,
            "Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its terms")
        ->option_text("U");
    command
        ->add_option("--outliers", options->outliers,
            "Rule that proposes outliers: mad (the default), grubbs or none")
        ->option_text("RULE")
        ->check(CLI::IsMember(std::vector<std::string>{"mad", "grubbs", "none"}));
    command
        ->add_option("--period", options->period,
            "Known period of the axis, such as the lead of its screw, in mm or deg")
        ->option_text("P")
        ->check(CLI::NonNegativeNumber.description(""));
    command->add_flag("--vdi", options->wantsVdi, "Show the figures of VDI/DGQ 3441 as well");
    addCorrectionOptions(*command, *options);
    command->footer("Examples:\n"
                    "  axiscomp judge x.rtl --tolerance A=10um,R=4um\n"
                    "  axiscomp judge x.csv --exclude down:1:1 --json");
}

} // namespace axiscomp::app
