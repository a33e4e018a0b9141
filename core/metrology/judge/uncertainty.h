// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/iso230.h"

#include <initializer_list>

namespace axiscomp {

/// What the uncertainty of a measured length is made of; ours, in the manner of ISO/TR 230-9, for a
/// coverage factor of 2. A range r of a rectangular distribution counts 0.6 r.
struct UncertaintyBudget {
    double lengthMm = 0.0; ///< L, the measured length
    double deviceMm = 0.0; ///< constant part of the device, for k = 2
    double devicePpm = 0.0; ///< part of the device that grows with the length
    double misalignmentMrad = 0.0; ///< g, between the beam and the axis
    double expansionPerKelvin = 0.0; ///< a
    double temperatureRangeKelvin = 0.0; ///< r(T), by which the temperature is not known
    double materialCelsius = 20.0; ///< T; without r(a) it counts nothing
    double expansionRangePerKelvin = 0.0; ///< r(a), by which the coefficient is not known
    double environmentMm = 0.0; ///< EVE, the range of a drift test
};

struct Uncertainty {
    double device = 0.0; ///< constant + ppm L; all in mm
    double misalignment = 0.0; ///< L (1 - cos g)
    double temperature = 0.0; ///< 0.6 a L r(T)
    double coefficient = 0.0; ///< 0.6 |T - 20| L r(a)
    double environment = 0.0; ///< 0.6 EVE
    double total = 0.0; ///< U: root of the sum of squares, k = 2
};
[[nodiscard]] Uncertainty uncertaintyOf(const UncertaintyBudget& budget);

/// A JSON file with the budget: members length, device, environment in mm; devicePpm; misalignment
/// in mrad; expansion, expansionRange in 1/K; temperature in deg C, temperatureRange in K. length
/// may be missing: then it is that of the measurement. Terms may be missing and count nothing, but
/// not all of them. Errors: InvalidArgument with the place, also for expansion without
/// temperatureRange and temperature without expansionRange, and the other way round.
[[nodiscard]] Result<UncertaintyBudget> uncertaintyBudgetFromJson(
    std::string_view text, double defaultLengthMm);

struct Tolerance {
    Iso230Figure figure = Iso230Figure::A;
    double value = 0.0; ///< in mm or deg

    friend bool operator==(const Tolerance&, const Tolerance&) = default;
};
/// "A=10um,R=4um"; without a unit mm, or deg for angles. Errors: InvalidArgument.
[[nodiscard]] Result<std::vector<Tolerance>> tolerancesFromText(
    std::string_view text, bool isAngular);
/// A sentence for each limit of these, or for "U=2.1", that has no unit: what it is taken as.
[[nodiscard]] std::vector<Text> assumedUnits(std::string_view limits, bool isAngular);
/// "2.1um" in mm, or in deg for angles. defaultUnit: of a number without one; empty: mm or deg.
/// Errors: InvalidArgument.
[[nodiscard]] Result<double> amountFromText(
    std::string_view text, bool isAngular, std::string_view defaultUnit = {});

enum class VerdictResult { Passed, Failed, Undecided, NotDefined };
[[nodiscard]] std::string_view verdictName(VerdictResult result); ///< "passed", "notDefined"
[[nodiscard]] TextPattern verdictText(VerdictResult result);

struct Verdict {
    Tolerance tolerance;
    std::optional<double> value; ///< nothing: not defined
    std::optional<double> uncertainty; ///< nothing: not stated
    VerdictResult result = VerdictResult::NotDefined;
    /// Of a verdict on what is foretold: the same figure held out, where that keeps it from being
    /// passed.
    std::optional<double> heldOut = {};
};
/// With U: passed when value + U <= tolerance, failed when value - U > tolerance, otherwise
/// undecided (the rule of ISO 14253-1, as we understand it). Without: plain comparison. Both but
/// for what computing leaves (isAbove). The mean reversal value counts with its size.
[[nodiscard]] std::vector<Verdict> verdicts(const Iso230Figures& figures,
    std::span<const Tolerance> tolerances, std::optional<double> uncertainty);
/// By the same rule, of one value.
[[nodiscard]] VerdictResult verdictResult(
    double value, double tolerance, std::optional<double> uncertainty);
/// How value, tolerance and U of a verdict are shown, so that they read as they were decided.
[[nodiscard]] ComparedDigits verdictDigits(const Verdict& verdict, bool isAngular, int decimals);
/// How its figure held out, which there is, is shown beside these: value and limit.
[[nodiscard]] ComparedDigits heldOutDigits(const Verdict& verdict, bool isAngular, int decimals);
/// In a table that has a unit for all: at least these, and as many more as the verdicts of a figure
/// need. Null: there is none.
[[nodiscard]] int verdictDecimals(
    std::initializer_list<const Verdict*> verdicts, const FineUnit& unit, int decimals);
/// Null: there is no tolerance of it.
[[nodiscard]] const Verdict* verdictOf(std::span<const Verdict> verdicts, Iso230Figure figure);

} // namespace axiscomp
