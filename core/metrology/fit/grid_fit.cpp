// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/grid_fit.h"

#include "core/metrology/fit/fit_errors.h"
#include "core/metrology/fit/grid_points.h"
#include "core/metrology/fit/grid_smoothness.h"
#include "core/metrology/fit/grid_system.h"
#include "core/table/grid_filling.h"
#include "core/text/number_text.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

constexpr double equationTolerance = 1e-7; // of the equations, relative
constexpr std::size_t mostGridNodes = 4'000'000;
constexpr std::size_t mostScatteredPoints = 100'000'000;
constexpr int farDistances = 3;

bool areFiniteNumbers(std::span<const double> numbers)
{
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

Result<void> checkRequest(const ScatteredValues& values, const GridFitRequest& request)
{
    const Grid& grid = request.grid;
    const bool isGrid = !grid.axes.empty() && grid.axes.size() <= 3
        && std::ranges::all_of(grid.axes, [](const GridAxis& axis) {
               return axis.size >= 2 && std::isfinite(axis.start) && axis.distance > 0.0
                   && pointsAreDistinct(axis);
           });
    if (!isGrid)
        return badFit(AXISCOMP_TEXT("Error",
            "a grid has one to three dimensions, with two points and a distance above 0 in each"));
    double nodes = 1.0;
    for (const GridAxis& axis : grid.axes)
        nodes *= static_cast<double>(axis.size);
    if (nodes > static_cast<double>(mostGridNodes))
        return badFit(AXISCOMP_TEXT(
            "Error", "the grid would have more than {count} points; take fewer along an axis")
                          .with("count", mostGridNodes));
    const std::size_t count = values.values.size();
    bool isComplete = count > 0 && count <= mostScatteredPoints
        && (values.weights.empty() || values.weights.size() == count);
    for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
        isComplete = isComplete && values.coordinates[axis].size() == count
            && areFiniteNumbers(values.coordinates[axis]);
    if (!isComplete || !areFiniteNumbers(values.values) || !areFiniteNumbers(values.weights))
        return badFit(AXISCOMP_TEXT("Error",
            "points need one finite number for each dimension, for their value and for their "
            "weight"));
    if (std::ranges::any_of(values.weights, [](double weight) { return !(weight > 0.0); }))
        return badFit(AXISCOMP_TEXT("Error", "weights must be larger than 0"));
    if (request.smoothness && !(std::isfinite(*request.smoothness) && *request.smoothness >= 0.0))
        return badFit(AXISCOMP_TEXT("Error", "the smoothness must be a number of 0 or more"));
    return {};
}

using Marks = std::vector<bool>;

/// The nodes in which a point has a share.
Marks measuredNodes(const GridShape& shape, const std::vector<GridPoint>& points)
{
    Marks measured(shape.nodes(), false);
    for (const GridPoint& point : points) {
        const std::array<double, 8> weights = point.cornerWeights(shape.dimensions);
        for (std::size_t corner = 0; corner < shape.corners(); ++corner)
            if (weights[corner] > 0.0)
                measured[point.node + shape.cornerOffset(corner)] = true;
    }
    return measured;
}

/// The nodes without a point within the distances along every axis: a point is less than one away
/// from the nodes in which it has a share.
Marks farNodes(const GridShape& shape, Marks near)
{
    for (int step = 1; step < farDistances; ++step) {
        for (std::size_t axis = 0; axis < shape.dimensions; ++axis) {
            const Marks before = near;
            const std::size_t stride = shape.stride[axis];
            for (std::size_t node = 0; node < before.size(); ++node) {
                if (!before[node])
                    continue;
                const std::size_t place = shape.place(node, axis);
                if (place > 0)
                    near[node - stride] = true;
                if (place + 1 < shape.size[axis])
                    near[node + stride] = true;
            }
        }
    }
    near.flip();
    return near;
}

Result<void> checkNear(const Grid& grid, const GridShape& shape, const Marks& far)
{
    const auto count = std::ranges::count(far, true);
    if (count == 0)
        return {};
    std::array<std::size_t, 3> first = shape.size;
    std::array<std::size_t, 3> last{};
    for (std::size_t node = 0; node < far.size(); ++node) {
        for (std::size_t axis = 0; far[node] && axis < shape.dimensions; ++axis) {
            first[axis] = std::min(first[axis], shape.place(node, axis));
            last[axis] = std::max(last[axis], shape.place(node, axis));
        }
    }
    std::vector<Text> region;
    for (std::size_t axis = 0; axis < shape.dimensions; ++axis) {
        const GridAxis& along = grid.axes[axis];
        region.push_back(
            AXISCOMP_TEXT("Error", "{axis} {from} to {to}")
                .with("axis", along.name)
                .with("from", Quantity{roundedText(along.position(first[axis])), along.unit})
                .with("to", Quantity{roundedText(along.position(last[axis])), along.unit}));
    }
    return fail(ErrorCode::NoDataThere,
        {{"count", count}, {"region", std::move(region)}, {"distances", farDistances}});
}

/// Huber's weights at 1.345 sigma, sigma from the median of the sizes of the residuals.
std::vector<double> huberWeights(const std::vector<double>& residuals)
{
    std::vector<double> sizes;
    sizes.reserve(residuals.size());
    for (const double residual : residuals)
        sizes.push_back(std::abs(residual));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double limit = 1.345 * 1.4826 * *middle;
    std::vector<double> weights;
    weights.reserve(residuals.size());
    for (const double residual : residuals)
        weights.push_back(std::abs(residual) <= limit ? 1.0 : limit / std::abs(residual));
    return weights;
}

/// The least-squares plane through points, in numbers of nodes from the first one. The penalty does
/// not see it; what is left is fitted, so that a plane which is added to the values is added to the
/// nodes as exactly.
class TrendPlane {
public:
    TrendPlane() = default;
    TrendPlane(const GridShape& shape, const std::vector<GridPoint>& points)
    {
        Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
        Eigen::Vector4d right = Eigen::Vector4d::Zero();
        for (const GridPoint& point : points) {
            const Eigen::Vector4d row = rowOf(shape, point.node, point.fraction);
            normal += point.weight * row * row.transpose();
            right += point.weight * point.value * row;
        }
        m_coefficients = normal.completeOrthogonalDecomposition().solve(right);
    }
    [[nodiscard]] double at(
        const GridShape& shape, std::size_t node, const std::array<double, 3>& fraction = {}) const
    {
        return m_coefficients.dot(rowOf(shape, node, fraction));
    }

private:
    static Eigen::Vector4d rowOf(
        const GridShape& shape, std::size_t node, const std::array<double, 3>& fraction)
    {
        Eigen::Vector4d row{1.0, 0.0, 0.0, 0.0};
        for (std::size_t axis = 0; axis < shape.dimensions; ++axis) {
            const double number = static_cast<double>(shape.place(node, axis)) + fraction[axis];
            row[static_cast<Eigen::Index>(axis) + 1] =
                2.0 * number / static_cast<double>(shape.size[axis] - 1) - 1.0;
        }
        return row;
    }

    Eigen::Vector4d m_coefficients = Eigen::Vector4d::Zero();
};

class GridFitter {
public:
    GridFitter(const ScatteredValues& values, const GridFitRequest& request)
        : m_request(request)
        , m_shape(request.grid)
        , m_located(locate(request.grid, values))
        , m_nodes(m_shape.nodes(), 0.0)
    {
        m_fit.outside = values.values.size() - m_located.points.size();
        m_fit.usedPoints = m_located.points.size();
        if (request.smoothness == 0.0) // exactly the means on nodes
            return;
        m_plane = TrendPlane(m_shape, m_located.points);
        for (GridPoint& point : m_located.points)
            point.value -= m_plane.at(m_shape, point.node, point.fraction);
    }

    [[nodiscard]] Result<GridFit> run();

private:
    [[nodiscard]] Result<void> fitNodes();
    [[nodiscard]] Result<void> choose();
    [[nodiscard]] Result<void> solve();
    [[nodiscard]] Result<void> solveRobustly();
    [[nodiscard]] Result<void> findFarNodes();
    void fillFarNodes();
    [[nodiscard]] std::vector<double> residuals() const;
    [[nodiscard]] double valueOf(const GridPoint& point) const
    {
        return point.value + m_plane.at(m_shape, point.node, point.fraction);
    }
    void describe();
    void describeRepeats();

    const GridFitRequest& m_request;
    GridShape m_shape;
    GridPoints m_located;
    TrendPlane m_plane; ///< what the points' values were relieved of
    std::vector<double> m_robust; ///< weights of the points; empty: 1
    std::vector<double> m_nodes;
    Marks m_far;
    GridFit m_fit;
};

Result<void> GridFitter::choose()
{
    if (m_request.smoothness) {
        m_fit.smoothness = *m_request.smoothness;
        return {};
    }
    const auto chosen = [&]() -> Result<ChosenSmoothness> {
        if (m_robust.empty())
            return chooseSmoothness(m_request.grid, m_located.points, m_request.stop);
        std::vector<GridPoint> weighted = m_located.points;
        for (std::size_t i = 0; i < weighted.size(); ++i)
            weighted[i].weight *= m_robust[i];
        return chooseSmoothness(m_request.grid, weighted, m_request.stop);
    }();
    if (!chosen)
        return fail(chosen.error());
    m_fit.smoothness = chosen->smoothness;
    m_fit.crossValidation = chosen->crossValidation;
    return {};
}

Result<void> GridFitter::solve()
{
    GridSystem system(m_request.grid);
    system.setPoints(m_located.points, m_robust);
    return system.solve(m_fit.smoothness, equationTolerance, m_request.stop, m_nodes);
}

Result<void> GridFitter::solveRobustly()
{
    constexpr int mostRounds = 10;
    AXISCOMP_CHECK(solve());
    for (int round = 0; round < mostRounds; ++round) {
        std::vector<double> weights = huberWeights(residuals());
        double change = m_robust.empty() ? 1.0 : 0.0;
        for (std::size_t i = 0; i < m_robust.size(); ++i)
            change = std::max(change, std::abs(weights[i] - m_robust[i]));
        m_robust = std::move(weights);
        if (change < 1e-3)
            break;
        AXISCOMP_CHECK(solve());
    }
    return {};
}

std::vector<double> GridFitter::residuals() const
{
    std::vector<double> left;
    left.reserve(m_located.points.size());
    for (const GridPoint& point : m_located.points)
        left.push_back(point.value - interpolated(m_shape, m_nodes, point));
    return left;
}

Result<void> GridFitter::findFarNodes()
{
    const Marks measured = measuredNodes(m_shape, m_located.points);
    m_far = farNodes(m_shape, measured);
    if (m_request.smoothness == 0.0 && std::ranges::count(measured, false) > 0)
        return badFit(AXISCOMP_TEXT("Error",
            "with a smoothness of 0 every point of the grid needs a measured one beside it, and "
            "{count} have none; take a larger smoothness or a coarser grid")
                          .with("count", std::ranges::count(measured, false)));
    if (m_request.farPoints == FarPoints::Refuse)
        AXISCOMP_CHECK(checkNear(m_request.grid, m_shape, m_far));
    for (std::size_t node = 0; node < measured.size(); ++node)
        if (!measured[node])
            m_fit.filled.push_back(static_cast<std::uint32_t>(node));
    return {};
}

void GridFitter::describeRepeats()
{
    const std::vector<GridPoint>& points = m_located.points;
    double square = 0.0;
    std::size_t freedom = 0;
    for (std::size_t begin = 0; begin < points.size();) {
        std::size_t end = begin;
        double sum = 0.0;
        while (end < points.size() && points[end].node == points[begin].node
            && points[end].fraction == points[begin].fraction)
            sum += points[end++].value;
        const double mean = sum / static_cast<double>(end - begin);
        for (std::size_t i = begin; i < end; ++i)
            square += (points[i].value - mean) * (points[i].value - mean);
        freedom += end - begin - 1;
        begin = end;
    }
    if (freedom > 0)
        m_fit.repeatability = std::sqrt(square / static_cast<double>(freedom));
}

void GridFitter::describe()
{
    const std::vector<double> left = residuals();
    double weight = 0.0;
    double sum = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < left.size(); ++i) {
        const GridPoint& point = m_located.points[i];
        weight += point.weight;
        sum += point.weight * valueOf(point);
        square += point.weight * left[i] * left[i];
        if (!(std::abs(left[i]) <= m_fit.residualLargest)) {
            m_fit.residualLargest = std::abs(left[i]);
            m_fit.largestAt = m_located.sources[i];
        }
        if (!m_robust.empty() && m_robust[i] < 0.3)
            m_fit.doubtful.push_back({m_located.sources[i], left[i], m_robust[i]});
    }
    std::ranges::sort(m_fit.doubtful, {}, &DoubtfulPoint::index);
    const double mean = sum / weight;
    double variance = 0.0;
    for (const GridPoint& point : m_located.points)
        variance += point.weight * std::pow(valueOf(point) - mean, 2);
    m_fit.residualRms = std::sqrt(square / weight);
    m_fit.valueRms = std::sqrt(variance / weight);
    m_fit.explained = variance > 0.0 ? std::clamp(1.0 - square / variance, 0.0, 1.0) : 1.0;
    describeRepeats();
}

/// Far nodes get the value of the nearest that is not far.
void GridFitter::fillFarNodes()
{
    GridCoordinates coordinates;
    for (std::size_t axis = 0; axis < m_shape.dimensions; ++axis) {
        coordinates.emplace_back();
        for (std::size_t i = 0; i < m_shape.size[axis]; ++i)
            coordinates.back().push_back(static_cast<double>(i));
    }
    for (std::size_t node = 0; node < m_far.size(); ++node)
        if (m_far[node])
            m_nodes[node] = std::numeric_limits<double>::quiet_NaN();
    fillNearest(coordinates, m_nodes);
}

Result<GridFit> GridFitter::run()
{
    if (m_located.points.empty())
        return badFit(AXISCOMP_TEXT("Error",
            "no point lies within the grid; check its start and end, and the unit of the "
            "positions"));
    AXISCOMP_CHECK(findFarNodes());
    if (!m_request.nodes.empty()) {
        m_nodes = m_request.nodes;
        for (std::size_t node = 0; node < m_nodes.size(); ++node)
            m_nodes[node] -= m_plane.at(m_shape, node);
    } else {
        AXISCOMP_CHECK(fitNodes());
    }
    describe();
    for (std::size_t node = 0; node < m_nodes.size(); ++node)
        m_nodes[node] += m_plane.at(m_shape, node);
    if (m_request.farPoints == FarPoints::Nearest)
        fillFarNodes();
    m_fit.values = std::move(m_nodes);
    return std::move(m_fit);
}

Result<void> GridFitter::fitNodes()
{
    AXISCOMP_CHECK(choose());
    if (m_request.isRobust) {
        AXISCOMP_CHECK(solveRobustly());
        if (!m_request.smoothness) { // gross errors had their say in the first choice
            AXISCOMP_CHECK(choose());
            AXISCOMP_CHECK(solveRobustly());
        }
    } else {
        AXISCOMP_CHECK(solve());
    }
    return {};
}

} // namespace

Result<GridFit> fitGrid(const ScatteredValues& values, const GridFitRequest& request)
{
    AXISCOMP_CHECK(checkRequest(values, request));
    return GridFitter(values, request).run();
}

} // namespace axiscomp
