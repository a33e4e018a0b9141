// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/conversion/resampling/resampling.h"
#include "core/curve/curve_grid.h"
#include "core/curve/fitted_curve.h"
#include "core/metrology/fit/lookup_frame.h"

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace axiscomp {

/// x_ij of ISO 230-2: reference - target at one target in one run. Positions and deviations in one
/// unit.
struct MeasuredValue {
    double target = 0.0;
    bool isUp = true; ///< approached in positive direction
    std::size_t run = 0; ///< counted per direction
    double deviation = 0.0;
};

/// Which values a table is made of; a drive has one value for both directions. Both: a table for
/// each, for controllers that keep two.
enum class FitDirection { Mean, Positive, Negative, Both };

enum class FitMethod {
    Linear, ///< straight lines through the means: what the drive does anyway
    Cubic, ///< monotone cubic through the means: few, trusted points
    Spline, ///< natural cubic spline through the means: smooth mechanics
    Smooth, ///< smoothing spline with known periods: many points, noise
    Harmonic, ///< harmonics of one turn: rotary axes
};

enum class SlopeRemoval {
    Keep, ///< scale error is real
    LeastSquares, ///< for straightness, where the reference line belongs to the instrument
    Ends,
};

/// Where the value of the table is 0, since the zero of the instrument is arbitrary.
enum class ZeroRule { Keep, First, Mean, Position };

/// What is taken out of a table: slope x + constant.
struct RemovedLine {
    double slope = 0.0; ///< value per position
    double constant = 0.0;
};

struct TableFitRequest {
    FitDirection direction = FitDirection::Mean; ///< of one table: not Both
    /// Whichever direction it is made of, a drive adds it in both; false: a controller keeps a
    /// table for each.
    bool servesBoth = true;
    FitMethod method = FitMethod::Linear;
    std::optional<double> smoothness = {}; ///< of Smooth
    KnownPeriods periods = {}; ///< of Smooth; harmonics also of Harmonic
    std::optional<double> turn = {}; ///< the period of a modulo axis
    SlopeRemoval slope = SlopeRemoval::Keep;
    ZeroRule zero = ZeroRule::First;
    double zeroPosition = 0.0; ///< of ZeroRule::Position
    /// In place of slope and zero: that of another table, so that what is between both stays.
    std::optional<RemovedLine> removed = {};
    /// What is taken out of this table and others later, by a zero that they have together.
    double laterConstant = 0.0;
    LookupAt lookupAt = LookupAt::Encoder;
    /// The values are of another axis than the one that moved along the targets: whatever is added
    /// to it, a target stays where it is.
    bool correctsAnother = false;
    /// During the measurement. The new table is this one, everywhere, and the curve through the
    /// residuals.
    ActiveTable active = {};
    /// The same for values that are whole errors, whatever was active: the new table is this one,
    /// everywhere, and the curve through what it lacks. Not together with active.
    ActiveTable onto = {};
    double gain = 1.0; ///< of the residuals, where they are merged onto a table
    /// By default the knots where they are even; with periods p / 20 apart.
    AxisRequest grid = {};
    std::optional<double> within = {}; ///< the fewest points that leave no more to the curve
    std::size_t mostPoints = 524'212; ///< of the table
    bool holdsEnds = false; ///< a grid beyond the targets is filled with the end values
    std::string unit = {};
};

/// A table of one dimension as a curve, in the unit of positions: straight lines between its
/// points. Nothing: there is no table.
[[nodiscard]] std::optional<CubicCurve> linesOf(const ActiveTable& table);

/// A target's mean, and where it belongs.
struct FitKnot {
    double target = 0.0;
    /// Of the knot (LookupFrame), gain 1. At the set position without what is removed from the
    /// table, since the axis stands without it.
    double position = 0.0;
    double value = 0.0; ///< what the table should say there, before slope and zero
    double weight = 1.0; ///< number of values
    /// Of both directions, and not as many in each: the mean of both means is not that of all
    /// values.
    bool hasUnequalRuns = false;
};

struct TableFit {
    AxisGrid grid;
    std::vector<double> values; ///< at the points of the grid
    FittedCurve curve; ///< before slope and zero are taken out
    std::vector<FitKnot> knots; ///< by target
    RemovedLine removed; ///< table(x) = curve(x) - slope x - constant
    CurveGrid density; ///< of the table beside the curve
    double residualRms = 0.0; ///< of the curve at the knots, weighted
    double residualLargest = 0.0;
    std::optional<double> smoothness = {}; ///< of Smooth: L / r
    /// Half of the largest reversal: what no table for both directions removes. Nothing for
    /// values of one direction.
    std::optional<double> remainingReversal = {};
    bool isMostlyReversal = false; ///< B > E / 2

    /// c of the table: linear between its points, the ends held.
    [[nodiscard]] CompensationTable table(const std::string& unit) const;
};

/// From runs to a table of one dimension (docs: from a measurement to a table). The order of the
/// values does not matter. Errors: InvalidArgument (also for a target that lacks one of two
/// directions, and knots that are not even where no grid is asked for); SignNotConvertible,
/// PeriodNotResolved, ResamplingImpossible, NotConverged.
[[nodiscard]] Result<TableFit> fitTable(
    std::span<const MeasuredValue> values, const TableFitRequest& request);

/// The same runs with the table active as the drive applies it: each run's error, linear between
/// its targets, less what the drive adds where the axis then stands; of another axis what the new
/// table adds more than the old one at the target. lookupAt: of the new table;
/// active: the one that was active during the measurement. Errors: as LookupFrame.
[[nodiscard]] Result<std::vector<MeasuredValue>> predictRuns(std::span<const MeasuredValue> values,
    const CompensationTable& table, const TableFitRequest& request);

/// What the whole chain leaves at each inner target when it is made without it: the figure to
/// believe, since it knows nothing of the target. A little pessimistic, as the gap is twice as
/// wide. As predictRuns, it is what the axis then shows: of the mean of both directions where the
/// table serves both, with the share that a gain leaves and the slope that was taken out. The
/// constant of the zero is not in it.
struct HeldOut {
    struct Residual {
        double target = 0.0;
        double value = 0.0; ///< measured mean - table
        double unknown = 0.0; ///< the part that the other targets do not tell: mean fitted - curve
    };
    std::vector<Residual> residuals;
    double rms = 0.0;
    double largest = 0.0;
    double range = 0.0; ///< M: largest - smallest
    double unknownRange = 0.0; ///< the same of what is unknown; not on record
    /// Of the first and the last target, which cannot be left out: what the whole table leaves
    /// there, where a gain, a slope that was taken out or the other direction leaves something.
    /// They count in the largest and in the range. Not on record.
    std::vector<Residual> ends = {};
};
/// Takes as long as a fit for each target. Errors: as fitTable, also for fewer than 4 targets;
/// Cancelled.
[[nodiscard]] Result<HeldOut> predictHeldOut(std::span<const MeasuredValue> values,
    const TableFitRequest& request, const std::stop_token& stop = {});

} // namespace axiscomp
