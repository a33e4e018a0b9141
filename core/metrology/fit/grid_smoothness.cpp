// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/grid_smoothness.h"

#include "core/base/portable_math.h"
#include "core/metrology/fit/grid_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>

namespace axiscomp {

namespace {

constexpr std::size_t foldCount = 5;
constexpr std::size_t fewestPoints = 10;
constexpr std::size_t mostTrialPoints = 50'000;
/// More than these take the most time of a search, and tell no more.
constexpr std::array<std::size_t, 3> mostTrialNodes{20'000, 10'000, 8'000};
constexpr double trialTolerance = 1e-4;

double squareAt(const GridPoint& point, const GridShape& shape, std::span<const double> nodes)
{
    const double residual = point.value - interpolated(shape, nodes, point);
    return point.weight * residual * residual;
}

/// Rms at left-out points for any smoothness.
class CrossValidation {
public:
    CrossValidation(const Grid& grid, std::vector<GridPoint> points, std::stop_token stop);

    /// decade: log10(S)
    [[nodiscard]] Result<double> rmsAt(double decade);

private:
    struct Fold {
        std::unique_ptr<GridSystem> system;
        std::vector<double> nodes; ///< of the last solution, from which the next begins
    };

    GridShape m_shape;
    std::vector<GridPoint> m_points;
    std::stop_token m_stop;
    std::vector<Fold> m_folds;
};

CrossValidation::CrossValidation(
    const Grid& grid, std::vector<GridPoint> points, std::stop_token stop)
    : m_shape(grid)
    , m_points(std::move(points))
    , m_stop(std::move(stop))
{
    for (std::size_t fold = 0; fold < foldCount; ++fold) {
        std::vector<double> weights;
        weights.reserve(m_points.size());
        for (const GridPoint& point : m_points)
            weights.push_back(point.fold % foldCount == fold ? 0.0 : 1.0);
        Fold made{std::make_unique<GridSystem>(grid), std::vector<double>(m_shape.nodes(), 0.0)};
        made.system->setPoints(m_points, weights);
        m_folds.push_back(std::move(made));
    }
}

Result<double> CrossValidation::rmsAt(double decade)
{
    double square = 0.0;
    double weight = 0.0;
    for (std::size_t fold = 0; fold < foldCount; ++fold) {
        auto& [system, nodes] = m_folds[fold];
        if (system->weight() == 0.0)
            continue;
        AXISCOMP_CHECK(system->solve(portable::pow(10.0, decade), trialTolerance, m_stop, nodes));
        for (const GridPoint& point : m_points) {
            if (point.fold % foldCount != fold)
                continue;
            square += squareAt(point, m_shape, nodes);
            weight += point.weight;
        }
    }
    return std::sqrt(square / weight);
}

/// The lowest of a function of decades: by whole ones down from the middle of the range both ways
/// until it rose twice, then by halves, then by the parabola through the lowest three.
class DecadeSearch {
public:
    using Function = std::function<Result<double>(double)>;
    explicit DecadeSearch(Function function) : m_function(std::move(function)) { }

    [[nodiscard]] Result<double> lowest(double low, double begin, double high);

private:
    [[nodiscard]] Result<double> at(double decade);
    [[nodiscard]] Result<void> walk(double begin, double end, double step);
    [[nodiscard]] double best() const;

    Function m_function;
    std::map<double, double> m_found;
};

Result<double> DecadeSearch::at(double decade)
{
    if (const auto found = m_found.find(decade); found != m_found.end())
        return found->second;
    AXISCOMP_TRY(const double value, m_function(decade));
    m_found.emplace(decade, value);
    return value;
}

double DecadeSearch::best() const
{
    return std::ranges::min_element(m_found, {}, [](const auto& entry) {
        return entry.second;
    })->first;
}

Result<void> DecadeSearch::walk(double begin, double end, double step)
{
    AXISCOMP_TRY(double before, at(begin));
    int rises = 0;
    for (double decade = begin + step; step * (end - decade) >= 0.0 && rises < 2; decade += step) {
        AXISCOMP_TRY(const double value, at(decade));
        rises = value > before ? rises + 1 : 0;
        before = value;
    }
    return {};
}

Result<double> DecadeSearch::lowest(double low, double begin, double high)
{
    AXISCOMP_CHECK(walk(begin, high, 1.0));
    AXISCOMP_CHECK(walk(begin, low, -1.0));
    constexpr double half = 0.5;
    const double around = best();
    for (const double decade : {around - half, around + half})
        AXISCOMP_CHECK(at(decade));
    const double middle = best();
    AXISCOMP_TRY(const double left, at(middle - half));
    AXISCOMP_TRY(const double centre, at(middle));
    AXISCOMP_TRY(const double right, at(middle + half));
    const double bend = left - 2.0 * centre + right;
    return bend > 0.0 ? middle + half * std::clamp(0.5 * (left - right) / bend, -1.0, 1.0) : middle;
}

/// The same points in the cells of another grid over the same range.
std::vector<GridPoint> movedOnto(
    const GridShape& to, const GridShape& from, std::vector<GridPoint> points)
{
    for (GridPoint& point : points) {
        std::size_t node = 0;
        for (std::size_t axis = 0; axis < to.dimensions; ++axis) {
            const auto cells = static_cast<double>(to.size[axis] - 1);
            const double number =
                (static_cast<double>(from.place(point.node, axis)) + point.fraction[axis]) * cells
                / static_cast<double>(from.size[axis] - 1);
            const double cell = std::clamp(std::floor(number), 0.0, cells - 1.0);
            point.fraction[axis] = std::clamp(number - cell, 0.0, 1.0);
            node += static_cast<std::size_t>(cell) * to.stride[axis];
        }
        point.node = static_cast<std::uint32_t>(node);
    }
    return points;
}

Grid coarserGrid(const Grid& grid)
{
    const std::size_t most = mostTrialNodes[grid.axes.size() - 1];
    const auto nodes = static_cast<double>(grid.pointCount());
    const double factor = portable::pow(
        nodes / static_cast<double>(most), 1.0 / static_cast<double>(grid.axes.size()));
    Grid made = grid;
    if (factor <= 1.0)
        return made;
    for (GridAxis& axis : made.axes) {
        const double cells = std::ceil(static_cast<double>(axis.size - 1) / factor);
        axis.distance *= static_cast<double>(axis.size - 1) / cells;
        axis.size = static_cast<std::uint32_t>(cells) + 1;
    }
    return made;
}

/// h^4, h the geometric mean of the distances.
double fourthPower(const Grid& grid)
{
    double h = 1.0;
    for (const GridAxis& axis : grid.axes)
        h *= axis.distance;
    return portable::pow(h, 4.0 / static_cast<double>(grid.axes.size()));
}

double weightSum(const std::vector<GridPoint>& points)
{
    double sum = 0.0;
    for (const GridPoint& point : points)
        sum += point.weight;
    return sum;
}

/// Compares S / 3, S and 3 S at a tenth of the points, on the whole grid.
Result<ChosenSmoothness> comparedAround(
    const Grid& grid, const std::vector<GridPoint>& points, double smoothness, std::stop_token stop)
{
    const GridShape shape(grid);
    const auto isLeftOut = [](const GridPoint& point) { return (point.fold >> 3) % 10 == 0; };
    std::vector<double> weights;
    weights.reserve(points.size());
    for (const GridPoint& point : points)
        weights.push_back(isLeftOut(point) ? 0.0 : 1.0);
    GridSystem system(grid);
    system.setPoints(points, weights);
    std::vector<double> nodes(shape.nodes(), 0.0);
    ChosenSmoothness best{smoothness, std::numeric_limits<double>::infinity()};
    for (const double factor : {3.0, 1.0, 1.0 / 3.0}) {
        AXISCOMP_CHECK(system.solve(factor * smoothness, trialTolerance, stop, nodes));
        double square = 0.0;
        double weight = 0.0;
        for (const GridPoint& point : points) {
            if (!isLeftOut(point))
                continue;
            square += squareAt(point, shape, nodes);
            weight += point.weight;
        }
        const double rms = std::sqrt(square / weight);
        if (rms < best.crossValidation)
            best = {factor * smoothness, rms};
    }
    return best;
}

} // namespace

Result<ChosenSmoothness> chooseSmoothness(
    const Grid& grid, const std::vector<GridPoint>& points, std::stop_token stop)
{
    if (points.size() < fewestPoints)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "there are values at {count} points of the grid's range; {fewest} are needed "
                    "to choose the smoothness, so give it (--smoothness)")
                    .with("count", points.size())
                    .with("fewest", fewestPoints)}});
    const Grid trialGrid = coarserGrid(grid);
    const bool isCoarser = !sameSpans(trialGrid, grid);
    std::vector<GridPoint> trialPoints;
    const double share = static_cast<double>(mostTrialPoints) / static_cast<double>(points.size());
    for (const GridPoint& point : points)
        if (static_cast<double>(point.fold) < share * 4294967296.0)
            trialPoints.push_back(point);
    if (isCoarser)
        trialPoints = movedOnto(GridShape(trialGrid), GridShape(grid), std::move(trialPoints));
    double longest = 0.0;
    for (const GridAxis& axis : trialGrid.axes)
        longest = std::max(longest, static_cast<double>(axis.size));
    const double trialScale = weightSum(trialPoints) * fourthPower(trialGrid);
    CrossValidation validation(trialGrid, std::move(trialPoints), stop);
    DecadeSearch search([&](double decade) { return validation.rmsAt(decade); });
    AXISCOMP_TRY(const double decade,
        search.lowest(-4.0, 1.0, std::ceil(4.0 * portable::log10(longest)) + 1.0));
    const bool isTrial = isCoarser || points.size() > mostTrialPoints;
    if (!isTrial) {
        AXISCOMP_TRY(const double rms, validation.rmsAt(decade));
        return ChosenSmoothness{portable::pow(10.0, decade), rms};
    }
    const double scale = weightSum(points) * fourthPower(grid);
    return comparedAround(grid, points, portable::pow(10.0, decade) * trialScale / scale, stop);
}

} // namespace axiscomp
