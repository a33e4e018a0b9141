// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/judgement.h"
#include "core/metrology/record/calibration_record.h"

#include <span>
#include <string_view>
#include <vector>

namespace axiscomp {

// Before and after a compensation: whether the machine became as good as was promised, and if not,
// what to look at. Positions and values in mm or deg.

/// What was promised, and what decides.
struct ComparisonRequest {
    std::optional<FigureValues> predicted = {};
    std::optional<HeldOut> heldOut = {};
    std::optional<std::uint32_t> tableCrc = {}; ///< of the table that is compared
    std::optional<std::int32_t> driveSerial = {}; ///< of the drive that the table is for
    /// A person says that this table was active, where the second measurement does not say it.
    bool isTableStated = false;
    std::vector<Tolerance> tolerances = {};
    std::optional<double> uncertainty = {}; ///< U with k = 2
    /// Whether prediction, tolerances and uncertainty are in deg; nothing: they are in the unit of
    /// the measurements, whichever that is.
    std::optional<bool> isAngular = {};
    /// The table is one over temperature, and the figures are those of a fit by temperature.
    bool isByTemperature = false;
    /// Of the last measurement with the table that is known already; empty: none, or without one.
    std::string lastDate = {};
};
/// What a record says: its prediction, its table, and the tolerances that hold (judgingOf), in the
/// unit of its measurement.
[[nodiscard]] ComparisonRequest comparisonRequest(const CalibrationRecord& record);

/// The figures of a measurement by the rule that those of the fit are made by.
[[nodiscard]] Iso230Figures figuresBy(
    const CalibrationRecord& record, const Measurement& measurement);

/// Whether a person has to say that the table was active, since the measurement leaves it open.
[[nodiscard]] bool needsStatement(const Measurement& after, const ComparisonRequest& request);

/// Measurements are compared as they were corrected: each for its own temperature and air, but both
/// or neither.
struct CorrectedSide {
    const Measurement& measurement; ///< as it is judged
    bool isForDeadPath = false;
};
enum class CorrectedAlike {
    Yes,
    AfterIsNot, ///< the second measurement lacks a correction that the first one has
    BeforeIsNot,
};
[[nodiscard]] CorrectedAlike areCorrectedAlike(
    const CorrectedSide& before, const CorrectedSide& after);

/// "OtherMachine" and "OtherSerial": of the joined files of each measurement (otherMachines), and
/// where the two state none in common. Null: it is not there.
[[nodiscard]] std::vector<JudgeWarning> machineWarnings(
    const Measurement* before, const Measurement* after);

/// Where the second measurement covers less of the axis than the first one: what both cover. The
/// figures are ranges over targets, so that over a shorter travel they are smaller by themselves.
/// As much as the first one: what lacks at both ends together is no longer than the mean distance
/// of its targets, nor than a quarter of it; or the targets lie all round a rotary axis. Targets
/// without a value in use do not count. measurements: with targets.
[[nodiscard]] std::optional<TwoRanges> lesserRange(
    const Measurement& before, const Measurement& after);
/// "first measurement from 0 to 500 mm, second one from 0 to 100 mm"
[[nodiscard]] Text rangesText(const TwoRanges& ranges, bool isAngular);
/// The same, with what it means.
[[nodiscard]] Text lesserRangeText(const TwoRanges& ranges, bool isAngular);

/// Where the second measurement has targets more than twice as far apart as the first one: what
/// lies between them is not measured again. Nothing otherwise. measurements: with targets.
[[nodiscard]] std::optional<Text> widerTargetsText(
    const Measurement& before, const Measurement& after);

/// What is left of the error at a target.
struct RemainingError {
    double position = 0.0;
    double value = 0.0; ///< mean of the directions that there are
    std::optional<double> standardError = {}; ///< of the mean; nothing with a single value
};

/// After minus before; nothing where one of them is not defined.
[[nodiscard]] std::optional<double> changeOf(
    const std::optional<double>& before, const std::optional<double>& after);

/// What to look at when the machine is not as promised.
struct ComparisonHint {
    std::string_view name; ///< "Sign", "Scale", "Shifted", "NotActive", "OtherState"
    Text text;
};

struct Comparison {
    Iso230Figures before;
    std::optional<FigureValues> predicted = {};
    std::optional<HeldOut> heldOut = {};
    Iso230Figures after;
    std::vector<RemainingError> errorBefore; ///< by target of the first measurement
    std::vector<RemainingError> residual; ///< by target of the second measurement
    /// Of what the promise is: M, or with runs of one direction what stands for it
    /// (figureStandingFor), which is meant by M below; 2 n is n then.
    Iso230Figure promised = Iso230Figure::M;
    /// The largest M that counts as predicted: 1.2 M held out + max(U, 2 s / sqrt(2 n)), s the
    /// pooled standard deviation of the second measurement, n its runs in each direction. Nothing
    /// without a held-out figure or M after.
    std::optional<double> largestAsPredicted = {};
    /// Never true of a machine that is no better than before (isNoBetter). Nothing without a
    /// held-out figure, without M, where M is that small over less of the axis or at targets that
    /// are wider apart, or where it cannot be told whether the machine is better.
    std::optional<bool> isAsPredicted = {};
    /// M is within that limit, but so was M before, or above it by no more than cannot be told,
    /// max(U, 2 s / sqrt(2 n)); and M has not become smaller or what is left is the same error (not
    /// as predicted), or M is smaller by no more than cannot be told (open). Not where M before was
    /// no larger than that, and M has become larger by no more: then nothing can become better.
    bool isNoBetter = false;
    std::vector<ComparisonHint> hints = {};
    std::vector<Verdict> verdicts = {}; ///< of the second measurement
    /// Only of a measurement of which values are left out; the figures above are then no evaluation
    /// by ISO 230-2.
    std::optional<Iso230Figures> beforeOfAllValues = {};
    std::optional<Iso230Figures> afterOfAllValues = {};
    std::vector<Verdict> verdictsOfAllValues = {}; ///< with afterOfAllValues; they decide nothing
    /// "ValuesExcluded"; "OtherVerdict" where all values say otherwise than those in use;
    /// "OtherMachine", "OtherSerial" (machineWarnings); "LesserRange";
    /// "WiderTargets" (widerTargetsText);
    /// "EarlierMeasurement" where the table was measured again after the second one (isEarlier).
    std::vector<JudgeWarning> warnings = {};
    std::optional<TwoRanges> lesserRange = {}; ///< of the two measurements
    bool isWider = false; ///< the targets of the second one: widerTargetsText
    std::optional<double> uncertainty = {}; ///< as in the request
    bool isByTemperature = false; ///< as in the request

    [[nodiscard]] bool isWithinTolerances() const;
    /// Whether values of one of the two measurements are left out.
    [[nodiscard]] bool hasExcluded() const;
    /// As if nothing were left out; of a measurement of which nothing is, its figures.
    [[nodiscard]] const Iso230Figures& ofAllValues(bool isAfter) const;
};

/// Hints are looked for when the error is not as predicted, or the machine no better than before;
/// without a prediction, when M is not smaller than before, or E of a direction where that is all
/// that both measurements have. With b the mean error before at the
/// targets after, b' its slope (natural spline) and r what is left, all about their means: r = k b
/// with |correlation| above 0.9 is a table that adds 1 - k times what it should (k = 2: the sign; k
/// = 1: not active); r = d b' one that is shifted by d. Errors: InvalidArgument for measurements
/// without targets, of lengths and angles, of two axes, of two drives, those of the request
/// included, and of two ranges that have nothing in common; MeasurementState when tableCrc is given
/// and the second measurement was not made with that table active.
[[nodiscard]] Result<Comparison> compareMeasurements(
    const Measurement& before, const Measurement& after, const ComparisonRequest& request);

/// The second measurement, what it says of the prediction, the verdict, and the uncertainty by
/// which both are go into the record. One that was made before the last one with the same table
/// goes before that, whose verdict stays.
void keepAfter(CalibrationRecord& record, RecordedMeasurement after, const Comparison& comparison);

} // namespace axiscomp
