// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/neutral_table.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace axiscomp {

/// How values between knots are made; in 2D and 3D along one axis after the other, the first first.
enum class ResamplingMethod {
    Linear, ///< what controllers do
    MonotoneCubic, ///< PCHIP: smooth, through the knots, without overshoot (Fritsch and Carlson
                   ///< 1980, slopes of Fritsch and Butland 1984)
    NaturalSpline, ///< natural cubic spline through the knots (AN140 5.2): smooth mechanics
    SmoothingSpline, ///< near the knots, by generalised cross-validation: noise; 8 knots at least
};
[[nodiscard]] std::string_view resamplingMethodName(ResamplingMethod method); ///< "cubic"
[[nodiscard]] std::optional<ResamplingMethod> resamplingMethodNamed(std::string_view name);
/// Whether a curve is meant that a denser table follows more closely, rather than the knots.
[[nodiscard]] bool followsCurve(ResamplingMethod method);

/// One axis of an even grid: positions start + i * distance.
struct AxisGrid {
    double start = 0.0;
    double distance = 1.0; ///< > 0
    std::size_t size = 2; ///< >= 2

    friend bool operator==(const AxisGrid&, const AxisGrid&) = default;
};

/// What is wanted of one axis: a number of points or a distance. With neither the axis keeps its
/// knots, which must be even.
struct AxisRequest {
    std::size_t points = 0; ///< both ends counted
    double distance = 0.0;
    std::optional<double> start = {}; ///< otherwise the first knot
    std::optional<double> end =
        {}; ///< otherwise the last knot; one period after start on a modulo axis

    friend bool operator==(const AxisRequest&, const AxisRequest&) = default;
};

struct ResamplingRequest {
    std::vector<AxisRequest> axes = {}; ///< one for each axis of the table
    ResamplingMethod method = ResamplingMethod::Linear;
    bool holdsEnds = false; ///< beyond the data the end values are held; otherwise that is refused
};

/// How far the resampled table, linear between its points as controllers have it, is off the source
/// at the source's own knots within the wanted range. Where the grid ends before these, its end is
/// held.
struct ColumnDeviation {
    /// Along one axis, for methods that follow a curve: the largest of all its lines.
    struct Density {
        std::size_t axis = 0;
        std::size_t points = 0;
        double largestDistance = 0.0; ///< from the curve, in the unit of the column
        double largestSlopeChange = 0.0; ///< at a point, in the unit of the column per position
    };
    double largest = 0.0; ///< in the unit of the column
    std::vector<double> position; ///< of the largest; empty: there is none
    double rms = 0.0;
    std::vector<Density> density = {}; ///< of the axes that were resampled, in their order

    /// Nowhere is the table further from the surface of all curves.
    [[nodiscard]] double distanceFromCurve() const;
};

struct ResamplingReport {
    std::vector<ColumnDeviation> columns;
    std::vector<Text> remarks; ///< grids that end before or behind the data
    std::vector<Text> losses; ///< of the remarks, those of grids that end before it
};

struct ResampledTable {
    NeutralTable table;
    std::vector<AxisGrid> grid;
    ResamplingReport report;
};

/// Onto an even grid. A grid that is the source's own leaves every number as it is. By a distance
/// that does not divide the range, the grid ends inside the data, which is a loss, or behind it
/// when ends are held, and a remark says so. A modulo axis becomes closed: its last point is the
/// first one again, a period later; between its last knot and that place the values are
/// interpolated, too. Errors: InvalidArgument (requests that make no sense, tables that are not
/// consistent); ResamplingImpossible (beyond the data, a distance that does not divide a period, a
/// modulo axis whose two ends differ, too many points).
[[nodiscard]] Result<ResampledTable> resample(
    const NeutralTable& table, const ResamplingRequest& request);

/// What a grid may have, in memory and in any format.
inline constexpr std::size_t mostGridPoints = 4'000'000;

struct GridLimits {
    std::size_t mostPoints = mostGridPoints; ///< of the table
    std::vector<std::size_t> mostPerAxis = {}; ///< one for each axis; empty: no limit
};

struct CoarsestGrid {
    std::vector<std::size_t> points; ///< for AxisRequest::points of each axis
    double deviation = 0.0; ///< the largest with these, in the unit of the first column
};

/// The coarsest even grid over the range of the data whose deviation (ColumnDeviation::largest) is
/// nowhere above the wanted one. More points are not always better, since a grid may or may not
/// meet the knots; so this is what is searched:
/// - 1D: the fewest points of all. Every number from 2 on is tried.
/// - 2D and 3D: for each axis the fewest points while the others keep their knots. From these on
///   all axes are refined in proportion, by a hundredth or the next point, until the deviation is
///   kept. Then axes lose points again, one by one, the axis with the fewest first, until no axis
///   can do with one less.
/// For methods that follow a curve the deviation is the distance from it, everywhere between the
/// ends: in 1D every number of points from 2 on is tried; in 2D and 3D each axis gets an equal
/// share of the distance, and then points until the sum over all axes keeps it.
/// deviation: >= 0, in the unit of the first column; columns with another unit of the same kind are
/// converted, and those of unknown units taken as numbers. Errors: InvalidArgument;
/// ResamplingImpossible when the limits do not suffice, with the deviation that is possible.
[[nodiscard]] Result<CoarsestGrid> coarsestGrid(const NeutralTable& table, double deviation,
    ResamplingMethod method, const GridLimits& limits = {});

// The steps of resample, of which coarsestGrid tries many.

/// What becomes of one axis.
struct PlannedAxis {
    AxisGrid grid;
    std::vector<double> knots; ///< the grid's positions
    double from = 0.0; ///< the wanted range, in which deviations count
    double to = 0.0;
    bool isKept = false; ///< the knots are the source's own, and so are the values along them
    Text remark; ///< empty: the grid is as wanted
    bool isShort = false; ///< the grid ends before the range does
};

/// points positions over a range: the first and the last exactly at its ends.
[[nodiscard]] PlannedAxis planPoints(
    const SourceAxis& axis, double from, double to, std::size_t points);

/// Errors: InvalidArgument, ResamplingImpossible.
[[nodiscard]] Result<PlannedAxis> planAxis(
    const NeutralTable& table, std::size_t axis, const AxisRequest& request, bool holdsEnds);

/// The distance of such a grid: a short number where that leads to the same end.
[[nodiscard]] double evenDistance(double from, double to, std::size_t points);

/// That the table is consistent and the values of modulo axes the same at both ends. Errors:
/// InvalidArgument, ResamplingImpossible.
[[nodiscard]] Result<void> checkResamplable(const NeutralTable& table);

/// Errors: ResamplingImpossible for too few knots to be smoothed.
[[nodiscard]] Result<void> checkMethod(
    const NeutralTable& table, const std::vector<PlannedAxis>& plan, ResamplingMethod method);

/// table: resamplable; plan: one for each axis. Errors: ResamplingImpossible (numbers too large).
[[nodiscard]] Result<ResampledTable> resampleOnto(
    const NeutralTable& table, const std::vector<PlannedAxis>& plan, ResamplingMethod method);

} // namespace axiscomp
