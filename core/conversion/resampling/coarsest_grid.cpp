// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/resampling/axis_interpolant.h"
#include "core/conversion/resampling/resampling.h"
#include "core/conversion/resampling/resampling_errors.h"
#include "core/curve/curve_grid.h"
#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace axiscomp {

namespace {

/// Deviations of sums of rounded numbers may be above what they are by this.
constexpr double roundedUp = 1.0 + 1e-12;

/// From the units of all columns to that of the first one.
std::vector<double> columnFactors(const NeutralTable& table)
{
    std::vector<double> factors;
    for (const CompensationColumn& column : table.columns)
        factors.push_back(unitFactor(column.unit, table.columns.front().unit).value_or(1.0));
    return factors;
}

/// The last position of the grid over the data of an axis.
double endOf(const SourceAxis& axis)
{
    return axis.wrap ? axis.knots.front() + *axis.wrap : axis.knots.back();
}

/// Tries grids along one axis, while the others keep their knots. A deviation is looked at where
/// the last grids failed before all knots are: most grids are refused by their first look.
class AxisSearch {
public:
    AxisSearch(const NeutralTable& table, std::size_t axis, ResamplingMethod method, double wanted);

    /// The fewest points from 2 to `most` that keep the deviation.
    [[nodiscard]] std::optional<std::size_t> fewest(std::size_t most);
    /// The largest deviation, in the unit of the first column.
    [[nodiscard]] double deviationWith(std::size_t points) const;

private:
    /// A knot in one line of one column.
    struct Spot {
        std::size_t knot = 0;
        std::size_t line = 0;
    };
    /// Where the grid's points on both sides of a knot lie in the source.
    struct Neighbours {
        AxisInterpolant::Place below;
        AxisInterpolant::Place above;
        double fraction = 0.0;
    };
    [[nodiscard]] Neighbours neighboursOf(
        std::size_t knot, double distance, std::size_t points) const;
    [[nodiscard]] double deviationAt(const Neighbours& neighbours, const Spot& spot) const;
    [[nodiscard]] bool holds(std::size_t points);
    [[nodiscard]] bool failsWhereOthersDid(double distance, std::size_t points) const;
    void remember(const Spot& spot);

    const std::vector<double>& m_knots;
    AxisInterpolant m_interpolant;
    std::vector<AxisInterpolant::Line> m_lines;
    std::vector<double> m_factors; ///< of each line, to the unit of the first column
    double m_start;
    double m_end;
    double m_wanted;
    double m_rounding;
    std::vector<Spot> m_failures; ///< the latest first
};

AxisSearch::AxisSearch(
    const NeutralTable& table, std::size_t axis, ResamplingMethod method, double wanted)
    : m_knots(table.axes[axis].knots)
    , m_interpolant(table.axes[axis], method)
    , m_start(m_knots.front())
    , m_end(endOf(table.axes[axis]))
    , m_wanted(wanted * roundedUp)
    , m_rounding(8.0 * std::numeric_limits<double>::epsilon()
          * std::max(std::abs(m_start), std::abs(m_end)))
{
    const std::size_t stride = strideOf(table, axis);
    const std::vector<double> factors = columnFactors(table);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::vector<double>& values = table.columns[i].values;
        for (std::size_t first = 0; first < values.size(); ++first) {
            if (first / stride % m_knots.size() != 0)
                continue;
            m_interpolant.load(&values[first], stride, m_lines.emplace_back());
            m_factors.push_back(factors[i]);
        }
    }
}

AxisSearch::Neighbours AxisSearch::neighboursOf(
    std::size_t knot, double distance, std::size_t points) const
{
    const auto position = [&](std::size_t i) {
        return i + 1 == points ? m_end : m_start + static_cast<double>(i) * distance;
    };
    const double x = m_knots[knot];
    const double index = std::floor((x - m_start) / distance);
    const auto below = std::min(static_cast<std::size_t>(std::max(index, 0.0)), points - 2);
    const double from = position(below);
    const double to = position(below + 1);
    double fraction = std::clamp((x - from) / (to - from), 0.0, 1.0);
    if (x - from <= m_rounding)
        fraction = 0.0;
    if (to - x <= m_rounding)
        fraction = 1.0;
    return {m_interpolant.placeOf(from), m_interpolant.placeOf(to), fraction};
}

double AxisSearch::deviationAt(const Neighbours& neighbours, const Spot& spot) const
{
    const AxisInterpolant::Line& line = m_lines[spot.line];
    const double from = m_interpolant.at(line, neighbours.below);
    const double to = m_interpolant.at(line, neighbours.above);
    const double found = neighbours.fraction == 1.0 ? to : from + neighbours.fraction * (to - from);
    return std::abs(found - line.values[spot.knot]) * m_factors[spot.line];
}

bool AxisSearch::failsWhereOthersDid(double distance, std::size_t points) const
{
    return std::ranges::any_of(m_failures, [&](const Spot& spot) {
        return !(deviationAt(neighboursOf(spot.knot, distance, points), spot) <= m_wanted);
    });
}

void AxisSearch::remember(const Spot& spot)
{
    constexpr std::size_t most = 16;
    m_failures.insert(m_failures.begin(), spot);
    if (m_failures.size() > most)
        m_failures.pop_back();
}

bool AxisSearch::holds(std::size_t points)
{
    const double distance = evenDistance(m_start, m_end, points);
    if (failsWhereOthersDid(distance, points))
        return false;
    const std::size_t begin = m_failures.empty() ? 0 : m_failures.front().knot;
    for (std::size_t i = 0; i < m_knots.size(); ++i) {
        const std::size_t knot = (begin + i) % m_knots.size();
        const Neighbours neighbours = neighboursOf(knot, distance, points);
        for (std::size_t line = 0; line < m_lines.size(); ++line) {
            if (deviationAt(neighbours, {knot, line}) <= m_wanted)
                continue;
            remember({knot, line});
            return false;
        }
    }
    return true;
}

std::optional<std::size_t> AxisSearch::fewest(std::size_t most)
{
    for (std::size_t points = 2; points <= most; ++points)
        if (holds(points))
            return points;
    return std::nullopt;
}

double AxisSearch::deviationWith(std::size_t points) const
{
    const double distance = evenDistance(m_start, m_end, points);
    double largest = 0.0;
    for (std::size_t knot = 0; knot < m_knots.size(); ++knot) {
        const Neighbours neighbours = neighboursOf(knot, distance, points);
        for (std::size_t line = 0; line < m_lines.size(); ++line)
            largest = std::max(largest, deviationAt(neighbours, {knot, line}));
    }
    return largest;
}

/// Grids along all axes.
class GridSearch {
public:
    GridSearch(
        const NeutralTable& table, double wanted, ResamplingMethod method, const GridLimits& limits)
        : m_table(table)
        , m_wanted(wanted)
        , m_method(method)
        , m_limits(limits)
        , m_factors(columnFactors(table))
    {
    }

    [[nodiscard]] Result<CoarsestGrid> run();
    /// For methods that follow a curve.
    [[nodiscard]] Result<CoarsestGrid> runAlongCurves() const;

private:
    using Sizes = std::vector<std::size_t>;
    [[nodiscard]] std::size_t mostAlong(std::size_t axis) const;
    [[nodiscard]] static double countOf(const Sizes& sizes);
    [[nodiscard]] std::vector<PlannedAxis> planOf(const Sizes& sizes) const;
    [[nodiscard]] Result<double> deviationOf(const Sizes& sizes) const;
    [[nodiscard]] Result<std::size_t> fewestAlongCurves(std::size_t axis, double wanted) const;
    /// The distance from the curves along each axis, in the unit of the first column.
    [[nodiscard]] Result<std::vector<double>> distancesFromCurves(const Sizes& sizes) const;
    [[nodiscard]] Result<Sizes> fewestAlone() const;
    [[nodiscard]] Result<CoarsestGrid> refined(const Sizes& fewest) const;
    [[nodiscard]] Result<CoarsestGrid> reduced(CoarsestGrid grid) const;
    [[nodiscard]] Quantity quantity(double deviation) const
    {
        return quantityOf(deviation, m_table.columns.front().unit);
    }

    const NeutralTable& m_table;
    double m_wanted;
    ResamplingMethod m_method;
    const GridLimits& m_limits;
    std::vector<double> m_factors;
};

std::size_t GridSearch::mostAlong(std::size_t axis) const
{
    // each other axis has two points at least
    const std::size_t others = std::size_t{1} << (m_table.axes.size() - 1);
    const std::size_t most = std::min(m_limits.mostPoints, mostGridPoints) / others;
    return m_limits.mostPerAxis.empty() ? most : std::min(most, m_limits.mostPerAxis[axis]);
}

double GridSearch::countOf(const Sizes& sizes)
{
    double count = 1.0;
    for (const std::size_t size : sizes)
        count *= static_cast<double>(size);
    return count;
}

std::vector<PlannedAxis> GridSearch::planOf(const Sizes& sizes) const
{
    std::vector<PlannedAxis> plan;
    for (std::size_t n = 0; n < sizes.size(); ++n) {
        const SourceAxis& axis = m_table.axes[n];
        plan.push_back(planPoints(axis, axis.knots.front(), endOf(axis), sizes[n]));
        if (m_method == ResamplingMethod::SmoothingSpline)
            plan.back().isKept = false;
    }
    return plan;
}

Result<double> GridSearch::deviationOf(const Sizes& sizes) const
{
    AXISCOMP_TRY(const auto resampled, resampleOnto(m_table, planOf(sizes), m_method));
    double largest = 0.0;
    for (std::size_t i = 0; i < m_factors.size(); ++i)
        largest = std::max(largest, m_factors[i] * resampled.report.columns[i].largest);
    return largest;
}

Result<GridSearch::Sizes> GridSearch::fewestAlone() const
{
    Sizes sizes;
    for (std::size_t n = 0; n < m_table.axes.size(); ++n) {
        AxisSearch search(m_table, n, m_method, m_wanted);
        const std::size_t most = mostAlong(n);
        const auto fewest = search.fewest(most);
        if (!fewest)
            return resamplingImpossible(AXISCOMP_TEXT("Error",
                "a deviation of {deviation} takes more than {count} points along {axis}; with "
                "{most} it is {found}; allow more points or a larger deviation")
                                            .with("deviation", quantity(m_wanted))
                                            .with("count", most)
                                            .with("axis", axisText(m_table, n))
                                            .with("most", most)
                                            .with("found", quantity(search.deviationWith(most))));
        sizes.push_back(*fewest);
    }
    return sizes;
}

Result<CoarsestGrid> GridSearch::refined(const Sizes& fewest) const
{
    constexpr double step = 1.01;
    CoarsestGrid grid{fewest, std::numeric_limits<double>::infinity()};
    for (double scale = 1.0;;) {
        Sizes next;
        bool isLast = true;
        double nextScale = std::numeric_limits<double>::infinity();
        for (std::size_t n = 0; n < fewest.size(); ++n) {
            const auto cells = static_cast<double>(fewest[n] - 1);
            const double size = std::ceil(cells * scale * (1.0 - 1e-12)) + 1.0;
            const bool isMost = size >= static_cast<double>(mostAlong(n));
            next.push_back(isMost ? mostAlong(n) : static_cast<std::size_t>(size));
            isLast = isLast && isMost;
            nextScale = std::min(nextScale, size / cells);
        }
        if (countOf(next) > static_cast<double>(m_limits.mostPoints))
            break;
        AXISCOMP_TRY(const auto deviation, deviationOf(next));
        grid = {next, deviation};
        if (deviation <= m_wanted * roundedUp)
            return grid;
        if (isLast)
            break;
        scale = std::max(scale * step, nextScale);
    }
    const bool wasTried = std::isfinite(grid.deviation);
    const TextPattern reason = wasTried
        ? AXISCOMP_TEXT("Error",
            "a deviation of {deviation} takes more points than allowed; with {sizes} points it "
            "is {found}; allow more points or a larger deviation")
        : AXISCOMP_TEXT("Error",
            "a deviation of {deviation} takes more points than allowed; it takes at least "
            "{sizes} points; allow more points or a larger deviation");
    return resamplingImpossible(reason.with("deviation", quantity(m_wanted))
                                    .with("sizes", sizeText(wasTried ? grid.points : fewest))
                                    .with("found", quantity(grid.deviation)));
}

Result<CoarsestGrid> GridSearch::reduced(CoarsestGrid grid) const
{
    for (bool isReduced = true; isReduced;) {
        isReduced = false;
        std::vector<std::size_t> order(grid.points.size());
        for (std::size_t n = 0; n < order.size(); ++n)
            order[n] = n;
        std::ranges::stable_sort(order, {}, [&](std::size_t n) { return grid.points[n]; });
        for (const std::size_t axis : order) {
            while (grid.points[axis] > 2) {
                Sizes fewer = grid.points;
                --fewer[axis];
                AXISCOMP_TRY(const auto deviation, deviationOf(fewer));
                if (deviation > m_wanted * roundedUp)
                    break;
                grid = {fewer, deviation};
                isReduced = true;
            }
        }
    }
    return grid;
}

Result<std::size_t> GridSearch::fewestAlongCurves(std::size_t axis, double wanted) const
{
    const std::size_t stride = strideOf(m_table, axis);
    const SourceAxis& source = m_table.axes[axis];
    const AxisInterpolant interpolant(source, m_method);
    AxisInterpolant::Line line;
    std::size_t fewest = 2;
    for (std::size_t i = 0; i < m_factors.size(); ++i) {
        const CompensationColumn& column = m_table.columns[i];
        for (std::size_t first = 0; first < column.values.size(); ++first) {
            if (first / stride % source.knots.size() != 0)
                continue;
            interpolant.load(&column.values[first], stride, line);
            const FittedCurve curve = interpolant.curve(line);
            const double within = wanted / m_factors[i];
            const double from = source.knots.front();
            if (curveGrid(curve, from, endOf(source), fewest).largestDistance <= within)
                continue;
            AXISCOMP_TRY(const auto grid,
                fewestCurvePoints(
                    curve, from, endOf(source), within, mostAlong(axis), column.unit));
            fewest = std::max(fewest, grid.points);
        }
    }
    return fewest;
}

Result<std::vector<double>> GridSearch::distancesFromCurves(const Sizes& sizes) const
{
    AXISCOMP_TRY(const auto resampled, resampleOnto(m_table, planOf(sizes), m_method));
    std::vector<double> distances(sizes.size(), 0.0);
    for (std::size_t i = 0; i < m_factors.size(); ++i)
        for (const ColumnDeviation::Density& density : resampled.report.columns[i].density)
            distances[density.axis] =
                std::max(distances[density.axis], m_factors[i] * density.largestDistance);
    return distances;
}

Result<CoarsestGrid> GridSearch::runAlongCurves() const
{
    CoarsestGrid grid;
    const double share = m_wanted / static_cast<double>(m_table.axes.size());
    for (std::size_t n = 0; n < m_table.axes.size(); ++n) {
        AXISCOMP_TRY(const auto fewest, fewestAlongCurves(n, share));
        grid.points.push_back(fewest);
    }
    for (;;) {
        if (countOf(grid.points) > static_cast<double>(m_limits.mostPoints))
            return resamplingImpossible(AXISCOMP_TEXT("Error",
                "a distance of {distance} from the curve takes at least {sizes} points, more than "
                "allowed; allow more points or a larger distance")
                                            .with("distance", quantity(m_wanted))
                                            .with("sizes", sizeText(grid.points)));
        AXISCOMP_TRY(const auto distances, distancesFromCurves(grid.points));
        grid.deviation = std::accumulate(distances.begin(), distances.end(), 0.0);
        if (grid.deviation <= m_wanted * roundedUp)
            return grid;
        ++grid.points[static_cast<std::size_t>(
            std::ranges::max_element(distances) - distances.begin())];
    }
}

Result<CoarsestGrid> GridSearch::run()
{
    AXISCOMP_TRY(const auto fewest, fewestAlone());
    if (fewest.size() == 1) {
        AXISCOMP_TRY(const auto deviation, deviationOf(fewest));
        return CoarsestGrid{fewest, deviation};
    }
    AXISCOMP_TRY(auto grid, refined(fewest));
    return reduced(std::move(grid));
}

} // namespace

Result<CoarsestGrid> coarsestGrid(
    const NeutralTable& table, double deviation, ResamplingMethod method, const GridLimits& limits)
{
    AXISCOMP_CHECK(checkResamplable(table));
    if (!std::isfinite(deviation) || deviation < 0.0)
        return invalidArgument(
            AXISCOMP_TEXT("Error", "the wanted deviation must be a number of 0 or more"));
    if (!limits.mostPerAxis.empty() && limits.mostPerAxis.size() != table.axes.size())
        return invalidArgument(
            AXISCOMP_TEXT("Error", "limits for {count} axes are given, the table has {axes}")
                .with("count", limits.mostPerAxis.size())
                .with("axes", table.axes.size()));
    const bool isTooFew =
        std::ranges::any_of(limits.mostPerAxis, [](std::size_t most) { return most < 2; });
    if (isTooFew || limits.mostPoints < (std::size_t{1} << table.axes.size()))
        return invalidArgument(AXISCOMP_TEXT(
            "Error", "a grid has at least two points along each axis; allow as many"));
    GridSearch search(table, deviation, method, limits);
    if (!followsCurve(method))
        return search.run();
    std::vector<PlannedAxis> plan(table.axes.size());
    AXISCOMP_CHECK(checkMethod(table, plan, method));
    return search.runAlongCurves();
}

} // namespace axiscomp
