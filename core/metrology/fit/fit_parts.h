// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/fit_errors.h"
#include "core/metrology/fit/measurement_fit.h"

namespace axiscomp {

// The parts of fitMeasurement.

struct FitInput {
    const Measurement& measurement;
    const FitSettings& settings;
    const FoundState& state;
    LookupAt lookupAt;
    std::stop_token stop;

    /// The axis that the table is made for; empty: nobody says it.
    [[nodiscard]] const std::string& axis() const
    {
        return state.axis.empty() ? measurement.header.axis : state.axis;
    }
    /// On a modulo axis positions repeat.
    [[nodiscard]] Outside outside() const { return settings.turn ? Outside::Wrap : Outside::Hold; }
};

/// Runs and averages: along one axis.
[[nodiscard]] Result<FitReport> fitRuns(const FitInput& input);
/// Runs with temperatures: over position and temperature.
[[nodiscard]] Result<FitReport> fitRunsByTemperature(const FitInput& input);

/// The values of runs that are in use, and the index of each in the measurement. With raw positions
/// reference - encoder at the place where the axis stood, as if no compensation had been active. Of
/// another axis the deviations, and raw positions tell the places only.
struct FitValues {
    std::vector<MeasuredValue> values;
    std::vector<std::size_t> indices;
};
[[nodiscard]] FitValues fitValues(const Measurement& measurement, const FitInput& input);
/// The targets with a value in use, ascending; all where fewer than two have one, of which no table
/// is made.
[[nodiscard]] std::vector<double> usedTargets(const Measurement& measurement);
/// That a table is not certainly one over other axes than these, or over these in another order.
/// Errors: InvalidArgument.
[[nodiscard]] Result<void> checkTableOver(
    const Text& name, const CompensationTable& table, std::span<const std::string> axes);
/// That a table is one of the axis along which runs or a track were measured: what a table of
/// another axis adds says nothing of it. Errors: InvalidArgument, also for more dimensions.
[[nodiscard]] Result<void> checkTableOfAxis(
    const Text& name, const CompensationTable& table, const FitInput& input);
/// Of runs and tracks, what was active and is merged onto: null where nothing is. Errors: those of
/// checkTableOfAxis and tableOfAxis.
[[nodiscard]] Result<const CompensationTable*> findActiveTable(const FitInput& input);
/// What the table of runs or a track is called by. What the measurement does not say is as in the
/// table that it is merged onto; null: onto none.
struct AxisNames {
    std::string positions;
    std::string values;
    std::string target; ///< may be empty
};
[[nodiscard]] AxisNames axisNames(const FitInput& input, const CompensationTable* old);
/// Whether the values of runs are certainly those of another axis than the one that moved, as of a
/// straightness.
[[nodiscard]] bool correctsAnother(const FitInput& input);
/// What is asked of a table of runs. Errors: InvalidArgument for what the settings leave open.
[[nodiscard]] Result<TableFitRequest> requestOfRuns(const FitInput& input);
/// What the drive will add where, at the knot where the table has its largest value. The reference
/// is said as it was read: input has what was fitted, with its corrections and without its drift.
[[nodiscard]] Text signOfRuns(
    const FitInput& input, const TableFit& fit, const CompensationTable& table);
/// Tracks, and points of two or three axes.
[[nodiscard]] Result<FitReport> fitScattered(const FitInput& input);

/// What is between what was measured and what the drive will add, so that the sentence adds up.
struct TakenOut {
    double removed = 0.0; ///< for what the next three say
    bool hasZero = true; ///< part of it is for the zero of the table
    bool hasSlope = false;
    bool hasBody = false; ///< part of it is how the artefact lay
    double evened = 0.0; ///< beside it: by a gain, averages, smoothing, the points of a grid
};
/// removed: with what is part of it.
[[nodiscard]] TakenOut takenOut(double measured, double added, TakenOut removed);
/// Nothing: both are the same.
[[nodiscard]] std::optional<Text> takenOutText(const TakenOut& taken, bool isAngular);

/// The same of the values of an axis beside its own encoder, at a position of others.
struct SignBeside {
    std::vector<Text> position; ///< of each axis
    double measured = 0.0;
    double correction = 0.0; ///< what corrections have put to it
    std::string table;
    TakenOut removed = {}; ///< without what was evened
    double added = 0.0;
};
[[nodiscard]] Text positionAlong(const std::string& axis, double position, bool isAngular);
[[nodiscard]] Text signBeside(SignBeside sign, bool isAngular);
/// What was read, and beside it what corrections have made of that where it shows.
[[nodiscard]] Argument readAndCorrected(Quantity read, Quantity corrected);

/// The values as a drive has them. rounding: the largest change by that.
[[nodiscard]] FittedTable fittedTable(std::vector<double> values, Grid grid, std::string name,
    std::string target, const std::string& unit);

/// The largest change of the table that it is merged onto.
[[nodiscard]] FitMerge mergeOnto(
    const FitInput& input, const CompensationTable& old, const CompensationTable& made);

void addRemark(FitReport& report, std::string_view name, Text text, bool isWarning = false);
/// What is to be said of any table, whatever it was made of.
void addTableRemarks(const FitInput& input, FitReport& report);
/// What is to be said of a table of runs. outliers: values that do not fit the others; fit: that
/// with the largest reversal.
void addRunsRemarks(
    const FitInput& input, std::size_t outliers, const TableFit& fit, FitReport& report);
/// What judging the runs warns of, all or those of one thermal state, and what is to be said of the
/// table along the axis that serves them.
void addStateRemarks(const FitInput& input, const Judgement& judgement,
    std::span<const CompensationTable> tables, FitReport& report);
[[nodiscard]] std::size_t outlierCount(const Judgement& judgement);
/// What is foretold of the targets, or that nothing can be. Errors: Cancelled.
[[nodiscard]] Result<void> addHeldOut(Result<HeldOut> heldOut, FitReport& report);
/// Verdicts of the figures that are foretold. A figure that was held out, too, is passed when both
/// are, and undecided when it is passed at the targets alone.
void judgeForetold(const FitSettings& settings, FitReport& report);

} // namespace axiscomp
