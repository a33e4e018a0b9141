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
/// reference - encoder at the place where the axis stood, as if no compensation had been active.
struct FitValues {
    std::vector<MeasuredValue> values;
    std::vector<std::size_t> indices;
};
[[nodiscard]] FitValues fitValues(const Measurement& measurement, const FitInput& input);
/// The targets with a value in use, ascending; all where fewer than two have one, of which no table
/// is made.
[[nodiscard]] std::vector<double> usedTargets(const Measurement& measurement);
/// Of runs and tracks, whatever was active: null where nothing is merged. Errors: InvalidArgument
/// for a table of another axis or of more dimensions; those of tableOfAxis.
[[nodiscard]] Result<const CompensationTable*> tableToMergeOnto(const FitInput& input);
/// What is asked of a table of runs. Errors: InvalidArgument for what the settings leave open.
[[nodiscard]] Result<TableFitRequest> requestOfRuns(const FitInput& input);
/// What the drive will add where, at the knot where the table has its largest value.
[[nodiscard]] Text signOfRuns(
    const FitInput& input, const TableFit& fit, const CompensationTable& table);
/// Tracks, and points of two or three axes.
[[nodiscard]] Result<FitReport> fitScattered(const FitInput& input);

/// The values as a drive has them. rounding: the largest change by that.
[[nodiscard]] FittedTable fittedTable(std::vector<double> values, Grid grid, std::string name,
    std::string target, const std::string& unit);

/// The largest change of the table that it is merged onto.
[[nodiscard]] FitMerge mergeOnto(
    const FitInput& input, const CompensationTable& old, const CompensationTable& made);

void addRemark(FitReport& report, std::string_view name, Text text, bool isWarning = false);
/// What is to be said of any table, whatever it was made of.
void addTableRemarks(const FitInput& input, FitReport& report);
/// What is to be said of a table of runs; judgement: of the measurement.
void addRunsRemarks(
    const FitInput& input, const Judgement& judgement, const TableFit& fit, FitReport& report);

} // namespace axiscomp
