// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input/judging_options.h"

#include "app/cli/output/environment.h"
#include "app/common/arguments.h"
#include "app/common/number_checks.h"
#include "app/common/number_text.h"
#include "core/io/local_file.h"
#include "core/metrology/joined_files.h"
#include "core/metrology/record/calibration_record.h"

namespace axiscomp::app {

namespace {

Json uncertaintyJson(const Uncertainty& terms)
{
    return {{"U", terms.total}, {"device", terms.device}, {"misalignment", terms.misalignment},
        {"temperature", terms.temperature}, {"coefficient", terms.coefficient},
        {"environment", terms.environment}};
}

/// "U=2.1um", or the terms of a budget in a file.
Result<Json> readUncertainty(const Measurement& measurement, const ToleranceOptions& options,
    const std::string& command, std::optional<double>& uncertainty)
{
    if (options.uncertainty.empty())
        return Json(nullptr);
    if (options.uncertainty.starts_with("U=")) {
        AXISCOMP_TRY(
            uncertainty, amountFromText(options.uncertainty.substr(2), measurement.isAngular));
        return Json{{"U", *uncertainty}};
    }
    if (measurement.isAngular)
        return wrongUsage(
            "a budget is for lengths; for angles give the uncertainty itself, such as "
            "--uncertainty U=2arcsec",
            command);
    constexpr std::uint64_t mostBytes = 64 * 1024;
    AXISCOMP_TRY(const auto bytes, loadFile(pathFromText(options.uncertainty), mostBytes));
    AXISCOMP_TRY(const auto budget, uncertaintyBudgetFromJson(asText(bytes), measurement.range()));
    const Uncertainty terms = uncertaintyOf(budget);
    uncertainty = terms.total;
    return uncertaintyJson(terms);
}

/// Why there is no such number of the scale: no file says it, or not all of them the same.
std::string whyNotKnown(const Measurement& measurement,
    std::optional<double> MeasurementHeader::*number, const std::string& name, const char* unit)
{
    const auto said = saidByFiles(measurement, number);
    if (!areDifferent(said))
        return "the " + name + " of the scale is not known";
    std::string list;
    for (const auto& each : said)
        list += (list.empty() ? "" : ", ")
            + (each.said ? withUnit(shortText(*each.said), unit) : std::string("not stated"))
            + " in file " + std::to_string(each.files.front() + 1);
    return "the files do not agree on the " + name + " of the scale (" + list + ")";
}

/// Nothing: not asked for.
Result<std::optional<TemperatureCorrection>> temperatureOf(
    const Measurement& measurement, const CorrectionOptions& options, const std::string& command)
{
    if (!options.asksForTemperature())
        return std::nullopt;
    const auto temperature =
        options.temperature ? options.temperature : measurement.header.materialTemperature;
    const auto expansion = options.expansion ? options.expansion : measurement.header.expansion;
    if (!temperature)
        return wrongUsage(
            whyNotKnown(measurement, &MeasurementHeader::materialTemperature, "temperature", "C")
                + ": give --temperature",
            command);
    if (!expansion)
        return wrongUsage(whyNotKnown(measurement, &MeasurementHeader::expansion,
                              "coefficient of expansion", "1/K")
                + ": give --expansion; for steel it is about 11.5e-6",
            command);
    return TemperatureCorrection{*temperature, *expansion,
        options.referenceTemperature.value_or(20.0), options.referenceExpansion.value_or(0.0),
        options.datum, options.isNotCorrected};
}

} // namespace

void addCorrectionOptions(CLI::App& command, CorrectionOptions& options)
{
    const std::string group = AXISCOMP_HELP("Help", "Corrections, made only when asked for");
    command
        .add_option("--temperature", options.temperature,
            AXISCOMP_HELP("Help", "Temperature of the axis's scale in C"))
        ->option_text("C")
        ->group(group);
    command
        .add_option("--expansion", options.expansion,
            AXISCOMP_HELP(
                "Help", "Coefficient of expansion of the axis's scale in 1/K, such as 11.5e-6"))
        ->option_text("PER_K")
        ->group(group);
    command
        .add_option("--reference-temperature", options.referenceTemperature,
            AXISCOMP_HELP("Help", "Temperature of the reference in C"))
        ->option_text("C")
        ->group(group);
    command
        .add_option("--reference-expansion", options.referenceExpansion,
            AXISCOMP_HELP("Help",
                "Coefficient of the reference in 1/K; 0 for a laser with wavelength compensation"))
        ->option_text("PER_K")
        ->group(group);
    command
        .add_option("--datum", options.datum,
            AXISCOMP_HELP("Help",
                "Position in mm that does not move with temperature; the first target unless "
                "given"))
        ->option_text("POSITION")
        ->check(anyNumber())
        ->group(group);
    command
        .add_flag("--not-corrected", options.isNotCorrected,
            AXISCOMP_HELP(
                "Help", "The values are not corrected to 20 C, where the file does not say it"))
        ->group(group);
    command
        .add_option("--dead-path", options.deadPath,
            AXISCOMP_HELP("Help",
                "Dead path of the interferometer: a JSON file with its length and the air of each "
                "run"))
        ->option_text("FILE")
        ->group(group);
}

Result<CorrectionOptions> correctedLike(const CorrectionsBefore& first,
    const Measurement& measurement, CorrectionOptions options, const std::string& command)
{
    if (first.deadPath && options.deadPath.empty())
        return wrongUsage("the first measurement is corrected for a dead path: give that of the "
                          "second one, with its own air (--dead-path)",
            command);
    const bool isDone = measurement.header.corrected == MeasurementHeader::Corrected::To20Celsius;
    if (!first.temperature || isDone)
        return options;
    if (!options.temperature)
        options.temperature = measurement.header.materialTemperature;
    if (!options.temperature)
        return wrongUsage("the first measurement is corrected to 20 C: give the temperature of the "
                          "scale during the second one (--temperature)",
            command);
    if (!options.expansion)
        options.expansion =
            measurement.header.expansion.value_or(first.temperature->expansionPerKelvin);
    if (!options.referenceExpansion)
        options.referenceExpansion = first.temperature->referenceExpansionPerKelvin;
    if (*options.referenceExpansion != 0.0 && !options.referenceTemperature)
        return wrongUsage("the first measurement is corrected for a reference that expands: give "
                          "the temperature of the reference during the second one "
                          "(--reference-temperature)",
            command);
    if (!options.datum)
        options.datum = first.temperature->datum;
    return options;
}

std::string correctionLines(const std::vector<Text>& corrections)
{
    std::string lines;
    for (const Text& correction : corrections)
        lines += "Correction: " + singleLine(correction.english()) + "\n";
    return lines;
}

Json againstFileJson(const AgainstFile& asked)
{
    Json json = Json::object();
    if (asked.swapsDirections)
        json["swapDirections"] = true;
    if (asked.invertsReference)
        json["invertReference"] = true;
    if (asked.takesAsReference)
        json["asReference"] = true;
    if (asked.takesAsDeviations)
        json["asDeviations"] = true;
    for (const StatedUnit& unit : asked.units)
        json["units"].push_back(
            {{"what", unit.what}, {"stated", unit.stated}, {"file", unit.ofFile}});
    return json;
}

MadeCorrections madeCorrections(
    const CorrectedMeasurement& made, const CorrectionsBefore& corrections)
{
    MadeCorrections result;
    result.corrections = corrections;
    const Measurement& measurement = made.measurement;
    result.text = correctionLines(correctionTexts(measurement.againstFile, corrections,
        made.largestByTemperature, made.largestByDeadPath, UnitLetters::Ascii));
    result.document = againstFileJson(measurement.againstFile);
    if (const auto& deadPath = corrections.deadPath)
        result.document["deadPath"] = {
            {"length", deadPath->lengthMm}, {"largest", *made.largestByDeadPath}};
    if (const auto& temperature = corrections.temperature)
        result.document["temperature"] = {{"material", temperature->materialCelsius},
            {"expansion", temperature->expansionPerKelvin},
            {"reference", temperature->referenceCelsius},
            {"referenceExpansion", temperature->referenceExpansionPerKelvin},
            {"datum", datumOf(*temperature, measurement)}, {"largest", *made.largestByTemperature}};
    return result;
}

Result<MadeCorrections> correct(
    Measurement& measurement, const CorrectionOptions& options, const std::string& command)
{
    CorrectionsBefore corrections;
    AXISCOMP_TRY(corrections.temperature, temperatureOf(measurement, options, command));
    if (!options.deadPath.empty()) {
        AXISCOMP_TRY(
            const auto bytes, loadFile(pathFromText(options.deadPath), maximumDeadPathSize));
        AXISCOMP_TRY(corrections.deadPath, deadPathFromText(asText(bytes), options.deadPath));
    }
    auto outcome = corrected(std::move(measurement), corrections);
    if (!outcome && outcome.error().code == ErrorCode::InvalidArgument)
        return wrongUsage(textOf(outcome.error()).english(), command); // which has the options
    AXISCOMP_TRY(auto result, std::move(outcome));
    MadeCorrections made = madeCorrections(result, corrections);
    measurement = std::move(result.measurement);
    return made;
}

void addToleranceOptions(CLI::App& command, ToleranceOptions& options)
{
    command
        .add_option("--tolerance", options.tolerances,
            AXISCOMP_HELP("Help", "Limits, such as A=10um,R=4um; exit code 8 when one is not met"))
        ->option_text("FIGURE=LIMIT,...");
    command
        .add_option("--uncertainty", options.uncertainty,
            AXISCOMP_HELP("Help",
                "Uncertainty of the measurement with k = 2: U=2.1um, or a JSON file with its "
                "terms"))
        ->option_text("U");
}

Result<ToleranceLimits> readTolerances(Environment& environment, const Measurement& measurement,
    const ToleranceOptions& options, const std::string& command)
{
    ToleranceLimits limits;
    for (const std::string& given : {options.tolerances, options.uncertainty})
        for (const Text& assumption : assumedUnits(given, measurement.isAngular))
            environment.warn(assumption.english());
    if (!options.tolerances.empty()) {
        AXISCOMP_TRY(
            limits.tolerances, tolerancesFromText(options.tolerances, measurement.isAngular));
    }
    AXISCOMP_TRY(limits.terms, readUncertainty(measurement, options, command, limits.uncertainty));
    return limits;
}

} // namespace axiscomp::app
