// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/corrections.h"

#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

tl::unexpected<Error> notCorrectable(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

constexpr double standardCelsius = 20.0; // ISO 1

Result<void> checkCorrectable(const Measurement& measurement, bool isConfirmed)
{
    using Corrected = MeasurementHeader::Corrected;
    if (measurement.isAngular)
        return notCorrectable(AXISCOMP_TEXT("Error",
            "angles do not change with temperature or air: the correction is for lengths"));
    if (measurement.header.corrected == Corrected::To20Celsius)
        return notCorrectable(AXISCOMP_TEXT("Error",
            "the file says that its values are corrected to 20 deg C already; correcting them "
            "again would make them wrong"));
    if (measurement.header.corrected == Corrected::NotSaid && !isConfirmed)
        return notCorrectable(AXISCOMP_TEXT("Error",
            "the file does not say whether its values are corrected to 20 deg C already; if they "
            "are not, that has to be stated (--not-corrected)"));
    return {};
}

/// Air in another unit would move every value by far too much, and none would look wrong.
Result<void> checkDeadPath(const DeadPathCorrection& correction)
{
    constexpr double longestMm = 1e5;
    if (!(std::abs(correction.lengthMm) <= longestMm))
        return notCorrectable(AXISCOMP_TEXT("Error",
            "a dead path is a length in mm between the interferometer and the reflector, at most "
            "100 m"));
    const auto isPossible = [](const AirState& air) {
        return air.pressureKilopascal >= 50.0 && air.pressureKilopascal <= 120.0
            && air.celsius >= -40.0 && air.celsius <= 60.0 && air.humidityPercent >= 0.0
            && air.humidityPercent <= 100.0;
    };
    const auto isOfRunPossible = [&](const auto& run) { return isPossible(run.second); };
    if (!isPossible(correction.atZero)
        || !std::ranges::all_of(correction.duringRun, isOfRunPossible))
        return notCorrectable(AXISCOMP_TEXT("Error",
            "there is no such air on the dead path: pressure is in kPa (50 to 120), temperature in "
            "deg C (-40 to 60), humidity in percent (0 to 100)"));
    return {};
}

double largestChange(const Measurement& before, const Measurement& after)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < after.values.size(); ++i)
        if (after.values[i].isUsed)
            largest =
                std::max(largest, std::abs(after.values[i].deviation - before.values[i].deviation));
    return largest;
}

Quantity degrees(double celsius, UnitLetters letters)
{
    return {roundedText(celsius), letters == UnitLetters::Ascii ? "C" : "°C"};
}

/// Everything that the change follows from; the positions are those of the measurement.
std::vector<Text> conditionTexts(const TemperatureCorrection& correction, UnitLetters letters)
{
    const auto coefficient = [letters](double perKelvin) {
        return Quantity{roundedText(perKelvin / expansionUnit),
            letters == UnitLetters::Ascii ? "um/(m K)" : "µm/(m·K)"};
    };
    std::vector<Text> conditions{
        AXISCOMP_TEXT("Report", "scale at {temperature} with {expansion}")
            .with("temperature", degrees(correction.materialCelsius, letters))
            .with("expansion", coefficient(correction.expansionPerKelvin))};
    if (correction.referenceExpansionPerKelvin != 0.0
        || correction.referenceCelsius != standardCelsius)
        conditions.push_back(
            AXISCOMP_TEXT("Report", "reference at {temperature} with {expansion}")
                .with("temperature", degrees(correction.referenceCelsius, letters))
                .with("expansion", coefficient(correction.referenceExpansionPerKelvin)));
    if (correction.datum)
        conditions.push_back(AXISCOMP_TEXT("Report", "datum at {position}")
                                 .with("position", placeOf(*correction.datum, false)));
    return conditions;
}

} // namespace

double datumOf(const TemperatureCorrection& correction, const Measurement& measurement)
{
    return correction.datum.value_or(
        measurement.targets.empty() ? 0.0 : measurement.targets.front());
}

std::optional<double> statedDatum(const std::optional<TemperatureCorrection>& correction)
{
    return correction ? correction->datum : std::nullopt;
}

Result<Measurement> correctedForTemperature(
    Measurement measurement, const TemperatureCorrection& correction)
{
    AXISCOMP_CHECK(checkCorrectable(measurement, correction.isConfirmed));
    constexpr double largestExpansion = 1e-3; // 20 times that of any metal
    const auto isPossible = [](double celsius, double expansion) {
        return isPossibleTemperature(celsius) && std::abs(expansion) <= largestExpansion;
    };
    if (!isPossible(correction.materialCelsius, correction.expansionPerKelvin)
        || !isPossible(correction.referenceCelsius, correction.referenceExpansionPerKelvin))
        return notCorrectable(AXISCOMP_TEXT("Error",
            "a temperature is in deg C and a coefficient of expansion in 1/K, such as 22.5 and "
            "11.5e-6"));
    const double factor = (1.0
                              + correction.referenceExpansionPerKelvin
                                  * (correction.referenceCelsius - standardCelsius))
        / (1.0 + correction.expansionPerKelvin * (correction.materialCelsius - standardCelsius));
    const double datum = datumOf(correction, measurement);
    for (RunValue& value : measurement.values) {
        // (P_ij - P_0) f - (P_i - P_0), written so that nothing is lost beside a large position.
        const double distance = measurement.targets[value.target] - datum;
        const double before = value.deviation;
        value.deviation = before * factor + distance * (factor - 1.0);
        value.correction += value.deviation - before;
    }
    measurement.header.corrected = MeasurementHeader::Corrected::To20Celsius;
    return measurement;
}

double refractiveIndex(const AirState& air)
{
    return 1.0 + 7.86e-4 * air.pressureKilopascal / (273.0 + air.celsius)
        - 1.5e-11 * air.humidityPercent * (air.celsius * air.celsius + 160.0);
}

Result<Measurement> correctedForDeadPath(
    Measurement measurement, const DeadPathCorrection& correction)
{
    if (measurement.isAngular)
        return notCorrectable(AXISCOMP_TEXT("Error",
            "angles do not change with temperature or air: the correction is for lengths"));
    AXISCOMP_CHECK(checkDeadPath(correction));
    const double atZero = refractiveIndex(correction.atZero);
    for (RunValue& value : measurement.values) {
        const auto air = correction.duringRun.find({value.direction, value.run});
        if (air == correction.duringRun.end())
            return notCorrectable(AXISCOMP_TEXT("Error",
                "the air of run {run} {direction} is not known; the dead path needs pressure, "
                "temperature and humidity of every run")
                                      .with("run", value.run)
                                      .with("direction", approachText(value.direction)));
        const double change = -correction.lengthMm * (refractiveIndex(air->second) / atZero - 1.0);
        value.deviation += change;
        value.correction += change;
    }
    return measurement;
}

Result<CorrectedMeasurement> corrected(
    Measurement measurement, const CorrectionsBefore& corrections)
{
    CorrectedMeasurement result;
    if (corrections.deadPath) {
        AXISCOMP_TRY(auto after, correctedForDeadPath(measurement, *corrections.deadPath));
        result.largestByDeadPath = largestChange(measurement, after);
        measurement = std::move(after);
    }
    if (corrections.temperature) {
        AXISCOMP_TRY(auto after, correctedForTemperature(measurement, *corrections.temperature));
        result.largestByTemperature = largestChange(measurement, after);
        measurement = std::move(after);
    }
    result.measurement = std::move(measurement);
    return result;
}

std::vector<Text> correctionTexts(const AgainstFile& asked, const CorrectionsBefore& corrections,
    const std::optional<double>& largestByTemperature,
    const std::optional<double>& largestByDeadPath, UnitLetters letters)
{
    // Corrections are of lengths.
    const auto largest = [letters](const std::optional<double>& change) {
        constexpr int decimals = 2;
        const std::optional<double> shown[] = {change};
        const FineUnit unit = fineUnit(shown, false);
        return Quantity{unit.digits(change.value_or(0.0), decimals),
            letters == UnitLetters::Ascii ? unit.name : unit.symbol};
    };
    std::vector<Text> list = againstFileTexts(asked);
    if (const auto& temperature = corrections.temperature)
        list.push_back(AXISCOMP_TEXT(
            "Report", "to {standard}, {conditions}: values changed by up to {largest}")
                           .with("standard", degrees(standardCelsius, letters))
                           .with("conditions", conditionTexts(*temperature, letters))
                           .with("largest", largest(largestByTemperature)));
    if (const auto& deadPath = corrections.deadPath)
        list.push_back(
            AXISCOMP_TEXT("Report", "dead path of {length}: values changed by up to {largest}")
                .with("length", Quantity{roundedText(deadPath->lengthMm), "mm"})
                .with("largest", largest(largestByDeadPath)));
    return list;
}

} // namespace axiscomp
