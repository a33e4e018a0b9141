// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/corrections.h"

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
            "are not, say so with --not-corrected"));
    return {};
}

} // namespace

Result<Measurement> correctedForTemperature(
    Measurement measurement, const TemperatureCorrection& correction)
{
    AXISCOMP_CHECK(checkCorrectable(measurement, correction.isConfirmed));
    constexpr double coldest = -273.15;
    constexpr double largestExpansion = 1e-3; // 20 times that of any metal
    const auto isPossible = [](double celsius, double expansion) {
        return celsius > coldest && celsius < -4.0 * coldest
            && std::abs(expansion) <= largestExpansion;
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
    const double datum =
        correction.datum.value_or(measurement.targets.empty() ? 0.0 : measurement.targets.front());
    for (RunValue& value : measurement.values) {
        // (P_ij - P_0) f - (P_i - P_0), written so that nothing is lost beside a large position.
        const double distance = measurement.targets[value.target] - datum;
        value.deviation = value.deviation * factor + distance * (factor - 1.0);
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
    const double atZero = refractiveIndex(correction.atZero);
    for (RunValue& value : measurement.values) {
        const auto air = correction.duringRun.find({value.direction, value.run});
        if (air == correction.duringRun.end())
            return notCorrectable(AXISCOMP_TEXT("Error",
                "the air of run {run} {direction} is not known; the dead path needs pressure, "
                "temperature and humidity of every run")
                                      .with("run", value.run)
                                      .with("direction", approachText(value.direction)));
        value.deviation -= correction.lengthMm * (refractiveIndex(air->second) / atZero - 1.0);
    }
    return measurement;
}

} // namespace axiscomp
