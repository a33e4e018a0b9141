// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/metrology/fine_quantity.h"
#include "core/metrology/measurement.h"

#include <map>

namespace axiscomp {

// Corrections before judging. None is made without being asked for.

/// 1 um/(m K), as which people write a coefficient, in 1/K.
inline constexpr double expansionUnit = 1e-6;
/// Proposed for steel where nobody knows better; it has to be accepted.
inline constexpr double steelExpansionPerKelvin = 11.5e-6;

struct TemperatureCorrection {
    double materialCelsius = 20.0; ///< of the axis's scale
    double expansionPerKelvin = 0.0; ///< of the axis's scale
    double referenceCelsius = 20.0;
    double referenceExpansionPerKelvin = 0.0; ///< 0: a laser compensated for its wavelength
    std::optional<double> datum =
        {}; ///< position that does not move, in mm; nothing: the first target
    bool isConfirmed = false; ///< the user says that the values are not corrected yet

    friend bool operator==(const TemperatureCorrection&, const TemperatureCorrection&) = default;
};

/// The position in mm that does not move, of a measurement that is corrected like this: the datum,
/// else the first target; 0 without targets.
[[nodiscard]] double datumOf(
    const TemperatureCorrection& correction, const Measurement& measurement);

/// The datum that a person has stated; nothing: none.
[[nodiscard]] std::optional<double> statedDatum(
    const std::optional<TemperatureCorrection>& correction);

/// As it would be at 20 deg C: positions from the datum are multiplied by
/// (1 + a_r (T_r - 20)) / (1 + a (T - 20)). Errors: InvalidArgument when the file says that the
/// values are corrected already, when it does not say it and nobody confirms it, for angles, and
/// for temperatures and coefficients that cannot be.
[[nodiscard]] Result<Measurement> correctedForTemperature(
    Measurement measurement, const TemperatureCorrection& correction);

/// Air on the path of a laser.
struct AirState {
    double pressureKilopascal = 101.325;
    double celsius = 20.0;
    double humidityPercent = 50.0;

    friend bool operator==(const AirState&, const AirState&) = default;
};
/// n = 1 + 7.86e-4 p / (273 + t) - 1.5e-11 h (t^2 + 160): the shop-floor formula of NIST's
/// Engineering Metrology Toolbox, appendix B.
[[nodiscard]] double refractiveIndex(const AirState& air);

struct DeadPathCorrection {
    double lengthMm = 0.0; ///< between the interferometer and the reflector at the zero setting
    AirState atZero = {}; ///< when the instrument was set to zero
    std::map<std::pair<Approach, int>, AirState> duringRun = {}; ///< of each direction and run

    friend bool operator==(const DeadPathCorrection&, const DeadPathCorrection&) = default;
};
/// Adds -D (n_j / n_0 - 1) to each deviation of run j, for an axis that moves away from the
/// interferometer; D is negative for one that moves towards it. Errors: InvalidArgument for angles,
/// for a run whose air is not known, and for a length or air that cannot be.
[[nodiscard]] Result<Measurement> correctedForDeadPath(
    Measurement measurement, const DeadPathCorrection& correction);

/// Those that were asked for.
struct CorrectionsBefore {
    std::optional<TemperatureCorrection> temperature = {};
    std::optional<DeadPathCorrection> deadPath = {};

    friend bool operator==(const CorrectionsBefore&, const CorrectionsBefore&) = default;
};
struct CorrectedMeasurement {
    Measurement measurement;
    /// By how much a value in use has changed at most, in mm. Nothing: not asked for.
    std::optional<double> largestByTemperature = {};
    std::optional<double> largestByDeadPath = {};
};
/// For the dead path, then to 20 deg C. Errors: those of both.
[[nodiscard]] Result<CorrectedMeasurement> corrected(
    Measurement measurement, const CorrectionsBefore& corrections);

/// What was made of the values, a phrase for each: "up and down exchanged", "to 20 °C, scale at
/// 22.5 °C with 11.5 µm/(m·K), datum at 100 mm: values changed by up to 3.1 µm". asked: of the
/// measurement. largest: of CorrectedMeasurement.
[[nodiscard]] std::vector<Text> correctionTexts(const AgainstFile& asked,
    const CorrectionsBefore& corrections, const std::optional<double>& largestByTemperature,
    const std::optional<double>& largestByDeadPath, UnitLetters letters = UnitLetters::Page);

} // namespace axiscomp
