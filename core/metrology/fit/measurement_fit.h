// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/grid_fit.h"
#include "core/metrology/fit/measured_state.h"
#include "core/metrology/fit/rigid_body.h"
#include "core/metrology/fit/table_fit.h"
#include "core/metrology/judge/drift.h"
#include "core/metrology/judge/judgement.h"
#include "core/metrology/judge/uncertainty.h"
#include "core/neutral/neutral_table.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

// From a measurement to the tables for a drive, and what is to be known of them before they are
// used. Lengths are in mm and angles in degrees, as in the measurement.

/// Where the value of a table is 0.
enum class FitZero {
    Automatic, ///< at the home position where it is known and measured, else at the first target
    Home,
    First, ///< at the first target, of points at the lowest corner of the grid
    Mean, ///< the mean of the values at the knots
    Position,
    Keep, ///< as the instrument has it
};

/// What is taken out of the deviations of an artefact in a plane or in space.
enum class BodyRemoval {
    None,
    Rigid, ///< translation and rotation, by least squares
    RigidAlong, ///< the same with the rotation that leaves no slope along one axis
    Scale, ///< translation, rotation and scale
};

struct FitSettings {
    FitDirection direction = FitDirection::Mean;
    /// Of runs and averages. A track takes Smooth too; Linear is a fit on the grid itself there, as
    /// of points.
    FitMethod method = FitMethod::Linear;
    /// L / r of the method smooth, S of points and tracks; none: by cross-validation.
    std::optional<double> smoothness = {};
    KnownPeriods periods = {}; ///< of the method smooth; its harmonics also of harmonic
    std::optional<double> turn = {}; ///< the length of a turn of a modulo axis
    SlopeRemoval slope = SlopeRemoval::Keep; ///< of runs and averages
    FitZero zero = FitZero::Automatic;
    std::vector<double> zeroPosition = {}; ///< of FitZero::Position, a number for each dimension
    std::optional<double> home = {}; ///< the home position of the axis, where it is known
    std::optional<DriftRemoval> drift = {}; ///< taken out of the runs before they are averaged
    std::optional<LookupAt> lookupAt = {}; ///< none: that is asked for
    double gain = 1.0; ///< of the residuals, where they are merged
    /// One for each dimension, points or distance; empty: the targets where they are even.
    std::vector<AxisRequest> grid = {};
    /// Of runs in several thermal states: a table of two dimensions, the second of which is the
    /// temperature of the values. By default its grid has two points for up to 4 states, which a
    /// line joins, else one for each state.
    bool isByTemperature = false;
    std::optional<double> within = {}; ///< the fewest points that leave no more to the curve
    bool holdsEnds = false; ///< a grid beyond the targets is filled with the end values
    std::size_t mostPoints = 524'212; ///< of a table, as the largest slot holds it
    BodyRemoval remove = BodyRemoval::None; ///< of points
    std::size_t removeAlong = 0; ///< the axis of BodyRemoval::RigidAlong
    FarPoints farPoints = FarPoints::Refuse; ///< of points and tracks
    bool isRobust = false; ///< of points and tracks
    std::optional<double> speed = {}; ///< of the axis in mm/s or deg/s, for steps of the velocity
    /// Of the figures that the prediction foretells.
    std::vector<Tolerance> tolerances = {};
    std::optional<double> uncertainty = {}; ///< U with k = 2, in mm or deg
    OutlierRule outlierRule = OutlierRule::PooledMad; ///< of the outliers that are told of

    friend bool operator==(const FitSettings&, const FitSettings&) = default;
};
[[nodiscard]] std::string_view fitMethodName(FitMethod method); ///< "linear"
[[nodiscard]] std::optional<FitMethod> fitMethodNamed(std::string_view name);
[[nodiscard]] std::string_view fitDirectionName(FitDirection direction); ///< "mean"
[[nodiscard]] std::optional<FitDirection> fitDirectionNamed(std::string_view name);

/// One table of the result: that of the axis that was measured, or of one of its directions, or of
/// one column of points.
struct FittedTable {
    CompensationTable table; ///< in mm or deg; its name, sources and target after the measurement
    Direction direction = Direction::Both; ///< of motion: that of FitDirection::Both has two tables
    double removedConstant = 0.0; ///< by the zero
    double removedSlope = 0.0; ///< values per position
    std::size_t knots = 0; ///< of the curve; of points and tracks the points of the grid
    std::vector<FitKnot> means; ///< what was fitted, by target; of points and tracks none
    std::vector<PeriodicTerm> periods; ///< of the method smooth
    std::optional<double> smoothness = {}; ///< that was taken
    double residualRms = 0.0; ///< of the fit at what was measured
    double residualLargest = 0.0;
    std::optional<double> crossValidation = {}; ///< rms at values left out: points and tracks
    std::size_t measuredNodes = 0; ///< points of the table beside which something was measured
    std::size_t filledNodes = 0;
    std::optional<CurveGrid> density = {}; ///< the table beside the curve; runs and averages
    double rounding = 0.0; ///< the largest change of a value by float32
};

/// Residuals that were merged.
struct FitMerge {
    Text onto;
    double gain = 1.0;
    double largestChange = 0.0; ///< of what the drive adds, at a point of either table
    std::vector<double> largestAt = {}; ///< the position of it
    /// The most that the old table had between the points of the new one, which is lost.
    double lostDetail = 0.0;
    /// The most that the old table changes beyond the ends of the new one, which is lost.
    double lostRange = 0.0;
};

/// Something that is to be known before the table is used.
struct FitRemark {
    std::string_view name; ///< "LargestStep", for programs
    Text text;
    bool isWarning = false; ///< the table may not do what is wanted
};

struct FitReport {
    std::vector<FittedTable> tables; ///< at least one, all over the same grid
    LookupAt lookupAt = LookupAt::Encoder;
    FoundState state; ///< what it points to must live as long as that is used
    std::optional<FitMerge> merge = {};
    std::optional<RigidBody> removedBody = {}; ///< of points
    /// Figures of the measurement as judged, and of the same runs with the table active; nothing
    /// for points and tracks, which have no targets. Over temperature each is the largest of a
    /// thermal state and of all runs together.
    std::optional<Iso230Figures> before = {};
    std::optional<Iso230Figures> predicted = {};
    std::optional<HeldOut> heldOut = {}; ///< nothing for fewer than 4 targets, points and tracks
    /// Of the figures that are foretold; M is passed only where it is held out as well.
    std::vector<Verdict> verdicts = {};
    Text sign; ///< what the drive will add where, at the largest value
    std::vector<FitRemark> remarks = {}; ///< warnings first

    [[nodiscard]] bool isWithinTolerances() const;
};

/// measurement: corrected, and what is left out marked as not used. The state must have been found
/// for it (findState). Takes long for many points; to be called off the window's thread. Errors:
/// InvalidArgument for what cannot be asked of this kind of measurement, and for what is left open
/// (lookupAt, a grid where targets are uneven, the home position); PeriodNotResolved, NoDataThere,
/// ResamplingImpossible, SignNotConvertible, NotConverged, Cancelled.
[[nodiscard]] Result<FitReport> fitMeasurement(const Measurement& measurement,
    const FitSettings& settings, const FoundState& state, std::stop_token stop = {});

/// The figures of runs by the rule of the fit of their table. By temperature each is the largest of
/// a thermal state and of all runs together, since the axis is at one temperature at a time; those
/// of the runs where not every value has a temperature, or all are of one state.
[[nodiscard]] Iso230Figures figuresOfFit(const Measurement& measurement, bool isByTemperature);
[[nodiscard]] Text figuresByTemperatureText();

/// The same runs with a table active as the drive applies it, in place of what was active: only the
/// deviations of the values in use are of it, and raw positions and outputs are left out. table: of
/// one dimension, in the unit of the measurement. The state must have been found for the
/// measurement (findState); what was measured with a table is foretold with that one taken away.
/// turn: of a modulo axis. Errors: InvalidArgument for a measurement without targets, a table of
/// more dimensions, not of one turn or of another axis, and what cannot be looked up.
[[nodiscard]] Result<Measurement> predictMeasurement(const Measurement& measurement,
    const CompensationTable& table, LookupAt lookupAt, const FoundState& state,
    std::optional<double> turn = {});

/// Whether the values are fitted on the grid itself, without a curve through them: points, and
/// tracks unless a curve is asked for.
[[nodiscard]] bool isFittedOnGrid(const Measurement& measurement, const FitSettings& settings);

/// What the tables are made by: the name of the method, or "grid".
[[nodiscard]] std::string_view madeBy(const Measurement& measurement, const FitSettings& settings);

/// What the values in use are of: the direction that was asked for, or the only one that was
/// measured in place of a mean.
[[nodiscard]] FitDirection fittedDirection(
    const Measurement& measurement, const FitSettings& settings);

/// Whether the raw position of every value in use is known, as it always is of a track.
[[nodiscard]] bool hasRawReadings(const Measurement& measurement);
/// Whether the values are reference - encoder whatever was active (StateRequest): the raw position
/// of every value is known, and it is one of the axis that is corrected. axis: the stated one, as
/// of the request.
[[nodiscard]] bool hasRawValues(const Measurement& measurement, std::string_view axis);

} // namespace axiscomp
