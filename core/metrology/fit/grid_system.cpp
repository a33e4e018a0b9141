// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/grid_system.h"
#include "core/base/portable_math.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axiscomp {

namespace {

constexpr std::size_t mostDirectNodes = 20'000;

using NodeSegment = Eigen::Map<Eigen::ArrayXd>;
using ConstNodeSegment = Eigen::Map<const Eigen::ArrayXd>;
using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;

Vector vectorOf(std::vector<double>& numbers)
{
    return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

ConstVector vectorOf(const std::vector<double>& numbers)
{
    return {numbers.data(), static_cast<Eigen::Index>(numbers.size())};
}

/// D2^T D2 of one axis with n nodes: the element (i, i + step), step 0 or 1. Those at step 2 are 1.
double secondDifferences(std::size_t n, std::size_t i, int step)
{
    const auto isRow = [n](std::size_t row) { return row >= 1 && row + 2 <= n; };
    if (step == 0)
        return (i >= 1 && isRow(i - 1) ? 1.0 : 0.0) + (isRow(i) ? 4.0 : 0.0)
            + (isRow(i + 1) && i + 1 < n ? 1.0 : 0.0);
    return (isRow(i) ? -2.0 : 0.0) + (isRow(i + 1) ? -2.0 : 0.0);
}

/// D1^T D1 of one axis: the element (i, i + step).
double firstDifferences(std::size_t n, std::size_t i, int step)
{
    if (step != 0)
        return -1.0;
    return (i > 0 ? 1.0 : 0.0) + (i + 1 < n ? 1.0 : 0.0);
}

} // namespace

/// The inverse of the equations for points that lie everywhere equally dense, nearly: in the basis
/// of the eigenvectors of D2^T D2 along each axis the penalty and the points' share are taken as
/// diagonal. Single precision, which slows the iteration down by nothing.
class GridSystem::Preconditioner {
public:
    Preconditioner(const GridShape& shape, const std::array<double, 3>& along,
        const std::array<std::array<double, 3>, 3>& across);

    /// density: sum of weights for each cell.
    void use(double density, double penalty);
    void apply(const std::vector<double>& from, std::vector<double>& to);

private:
    struct Axis {
        Eigen::MatrixXf basis; ///< columns are eigenvectors
        Eigen::VectorXd second; ///< of D2^T D2
        Eigen::VectorXd first; ///< of D1^T D1
        Eigen::VectorXd mass; ///< of linear interpolation between points that lie everywhere
    };
    [[nodiscard]] static Eigen::MatrixXd basisOf(const Eigen::MatrixXd& second);
    [[nodiscard]] static Axis axisOf(std::size_t n);
    enum class Way { ToBasis, Back };
    void turn(Way way);

    const GridShape& m_shape;
    const std::array<double, 3>& m_along;
    const std::array<std::array<double, 3>, 3>& m_across;
    std::vector<Axis> m_axes;
    Eigen::VectorXf m_inverse;
    Eigen::VectorXf m_work;
    Eigen::VectorXf m_turned;
};

GridSystem::Preconditioner::Preconditioner(const GridShape& shape,
    const std::array<double, 3>& along, const std::array<std::array<double, 3>, 3>& across)
    : m_shape(shape)
    , m_along(along)
    , m_across(across)
{
    for (std::size_t axis = 0; axis < shape.dimensions; ++axis) {
        const auto same = std::ranges::find_if(m_axes, [&](const Axis& other) {
            return static_cast<std::size_t>(other.second.size()) == shape.size[axis];
        });
        Axis made = same != m_axes.end() ? *same : axisOf(shape.size[axis]);
        m_axes.push_back(std::move(made));
    }
}

/// Natural ends as the equations have them; of long axes cosines, which are quicker to have and
/// differ at the ends only.
Eigen::MatrixXd GridSystem::Preconditioner::basisOf(const Eigen::MatrixXd& second)
{
    constexpr Eigen::Index mostSolved = 300;
    const Eigen::Index count = second.rows();
    if (count <= mostSolved)
        return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(second).eigenvectors();
    Eigen::MatrixXd basis(count, count);
    const auto n = static_cast<double>(count);
    // Every cosine of the basis is that of a 4n-th part of a turn.
    std::vector<double> cosines(static_cast<std::size_t>(4 * count));
    for (std::size_t part = 0; part < cosines.size(); ++part)
        cosines[part] = portable::cos(std::numbers::pi * static_cast<double>(part) / (2.0 * n));
    for (Eigen::Index k = 0; k < count; ++k)
        for (Eigen::Index i = 0; i < count; ++i)
            basis(i, k) = std::sqrt((k == 0 ? 1.0 : 2.0) / n)
                * cosines[static_cast<std::size_t>(k * (2 * i + 1) % (4 * count))];
    return basis;
}

GridSystem::Preconditioner::Axis GridSystem::Preconditioner::axisOf(std::size_t n)
{
    const auto count = static_cast<Eigen::Index>(n);
    Eigen::MatrixXd second = Eigen::MatrixXd::Zero(count, count);
    Eigen::SparseMatrix<double> first(count, count);
    Eigen::SparseMatrix<double> mass(count, count);
    const auto set = [](auto& matrix, Eigen::Index i, Eigen::Index k, double value) {
        matrix.coeffRef(i, k) = value;
        matrix.coeffRef(k, i) = value;
    };
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto place = static_cast<std::size_t>(i);
        const bool isEnd = i == 0 || i + 1 == count;
        set(second, i, i, secondDifferences(n, place, 0));
        set(first, i, i, firstDifferences(n, place, 0));
        set(mass, i, i, isEnd ? 1.0 / 3.0 : 2.0 / 3.0);
        if (i + 1 < count) {
            set(second, i, i + 1, secondDifferences(n, place, 1));
            set(first, i, i + 1, firstDifferences(n, place, 1));
            set(mass, i, i + 1, 1.0 / 6.0);
        }
        if (i + 2 < count)
            set(second, i, i + 2, 1.0);
    }
    const Eigen::MatrixXd basis = basisOf(second);
    const auto diagonal = [&basis](const auto& matrix) -> Eigen::VectorXd {
        return basis.cwiseProduct(matrix * basis).colwise().sum().transpose();
    };
    Axis axis;
    axis.basis = basis.cast<float>();
    axis.second = diagonal(Eigen::SparseMatrix<double>(second.sparseView())).cwiseMax(0.0);
    axis.first = diagonal(first);
    axis.mass = diagonal(mass);
    return axis;
}

void GridSystem::Preconditioner::use(double density, double penalty)
{
    const std::size_t nodes = m_shape.nodes();
    m_inverse.resize(static_cast<Eigen::Index>(nodes));
    m_work.resize(m_inverse.size());
    m_turned.resize(m_inverse.size());
    for (std::size_t node = 0; node < nodes; ++node) {
        std::array<Eigen::Index, 3> place{};
        double mass = density;
        double bend = 0.0;
        for (std::size_t a = 0; a < m_shape.dimensions; ++a) {
            place[a] = static_cast<Eigen::Index>(m_shape.place(node, a));
            mass *= m_axes[a].mass[place[a]];
            bend += m_along[a] * m_axes[a].second[place[a]];
            for (std::size_t b = 0; b < a; ++b)
                bend += m_across[a][b] * m_axes[a].first[place[a]] * m_axes[b].first[place[b]];
        }
        m_inverse[static_cast<Eigen::Index>(node)] =
            static_cast<float>(1.0 / (mass + penalty * bend));
    }
}

void GridSystem::Preconditioner::turn(Way way)
{
    using Matrix = Eigen::Map<Eigen::MatrixXf>;
    const auto size = [this](std::size_t axis) {
        return static_cast<Eigen::Index>(m_shape.size[axis]);
    };
    const Eigen::Index nodes = m_work.size();
    const Matrix lines(m_work.data(), size(0), nodes / size(0));
    Matrix turnedLines(m_turned.data(), size(0), nodes / size(0));
    if (way == Way::ToBasis)
        turnedLines.noalias() = m_axes[0].basis.transpose() * lines;
    else
        turnedLines.noalias() = m_axes[0].basis * lines;
    m_work.swap(m_turned);
    for (std::size_t axis = 1; axis < m_shape.dimensions; ++axis) {
        const auto rows = static_cast<Eigen::Index>(m_shape.stride[axis]);
        const Eigen::Index slab = rows * size(axis);
        for (Eigen::Index first = 0; first < nodes; first += slab) {
            const Matrix from(m_work.data() + first, rows, size(axis));
            Matrix to(m_turned.data() + first, rows, size(axis));
            if (way == Way::ToBasis)
                to.noalias() = from * m_axes[axis].basis;
            else
                to.noalias() = from * m_axes[axis].basis.transpose();
        }
        m_work.swap(m_turned);
    }
}

void GridSystem::Preconditioner::apply(const std::vector<double>& from, std::vector<double>& to)
{
    // single precision has a smaller range
    const double size = vectorOf(from).lpNorm<Eigen::Infinity>();
    const double scale = size > 0.0 ? size : 1.0;
    m_work = (vectorOf(from) / scale).cast<float>();
    turn(Way::ToBasis);
    m_work.array() *= m_inverse.array();
    turn(Way::Back);
    vectorOf(to) = scale * m_work.cast<double>();
}

GridSystem::GridSystem(const Grid& grid) : m_shape(grid)
{
    double h = 1.0;
    for (std::size_t a = 0; a < m_shape.dimensions; ++a)
        h *= portable::pow(grid.axes[a].distance, 1.0 / static_cast<double>(m_shape.dimensions));
    for (std::size_t a = 0; a < m_shape.dimensions; ++a) {
        const double ratio = h / grid.axes[a].distance;
        m_along[a] = ratio * ratio * ratio * ratio;
        for (std::size_t b = 0; b < m_shape.dimensions; ++b) {
            const double across = ratio * h / grid.axes[b].distance;
            m_across[a][b] = 2.0 * across * across;
        }
    }
    const auto reach = [this](std::size_t axis) { return axis < m_shape.dimensions ? 1 : 0; };
    for (int z = 0; z <= reach(2); ++z) {
        for (int y = z == 0 ? 0 : -reach(1); y <= reach(1); ++y) {
            for (int x = z == 0 && y == 0 ? 0 : -1; x <= 1; ++x) {
                const auto offset = x + y * static_cast<std::ptrdiff_t>(m_shape.stride[1])
                    + z * static_cast<std::ptrdiff_t>(m_shape.stride[2]);
                m_neighbours.push_back({{x, y, z}, offset});
            }
        }
    }
    for (std::size_t i = 0; i < m_shape.corners(); ++i) {
        for (std::size_t k = i; k < m_shape.corners(); ++k) {
            std::array<int, 3> step{};
            for (std::size_t a = 0; a < 3; ++a)
                step[a] = static_cast<int>(k >> a & 1U) - static_cast<int>(i >> a & 1U);
            const auto found = std::ranges::find(m_neighbours, step, &Neighbour::step);
            m_neighbourOfCorners[i][k] = static_cast<std::size_t>(found - m_neighbours.begin());
        }
    }
}

GridSystem::~GridSystem() = default;

void GridSystem::setPoints(const std::vector<GridPoint>& points, std::span<const double> weights)
{
    m_data.assign(m_neighbours.size(), Numbers(m_shape.nodes(), 0.0));
    m_right.assign(m_shape.nodes(), 0.0);
    m_weight = 0.0;
    std::array<std::size_t, 8> offsets{};
    for (std::size_t corner = 0; corner < m_shape.corners(); ++corner)
        offsets[corner] = m_shape.cornerOffset(corner);
    for (std::size_t n = 0; n < points.size(); ++n) {
        const GridPoint& point = points[n];
        const double weight = point.weight * (weights.empty() ? 1.0 : weights[n]);
        if (weight == 0.0)
            continue;
        m_weight += weight;
        const std::array<double, 8> shares = point.cornerWeights(m_shape.dimensions);
        for (std::size_t i = 0; i < m_shape.corners(); ++i) {
            const std::size_t node = point.node + offsets[i];
            const double share = weight * shares[i];
            if (share == 0.0)
                continue;
            m_right[node] += share * point.value;
            for (std::size_t k = i; k < m_shape.corners(); ++k)
                m_data[m_neighbourOfCorners[i][k]][node] += share * shares[k];
        }
    }
}

double GridSystem::penaltyBetween(
    const std::array<std::size_t, 3>& place, const std::array<int, 3>& step) const
{
    double sum = 0.0;
    const auto& size = m_shape.size;
    int steps = 0;
    for (const int s : step)
        steps += std::abs(s);
    for (std::size_t a = 0; a < m_shape.dimensions; ++a) {
        // the element of a positive step belongs to its lower end
        const std::size_t atA = step[a] < 0 ? place[a] - 1 : place[a];
        if (steps == std::abs(step[a]))
            sum += m_along[a] * secondDifferences(size[a], atA, std::abs(step[a]));
        for (std::size_t b = 0; b < a; ++b) {
            if (steps != std::abs(step[a]) + std::abs(step[b]))
                continue;
            const std::size_t atB = step[b] < 0 ? place[b] - 1 : place[b];
            sum += m_across[a][b] * firstDifferences(size[a], atA, step[a])
                * firstDifferences(size[b], atB, step[b]);
        }
    }
    return sum;
}

void GridSystem::setPenalty(double penalty)
{
    m_penalty = penalty;
    m_matrix.resize(m_data.size());
    for (std::size_t n = 0; n < m_neighbours.size(); ++n) {
        const std::array<int, 3>& step = m_neighbours[n].step;
        Numbers& elements = m_matrix[n];
        elements = m_data[n];
        // along a line only its two first and two last elements differ from each other
        std::array<std::size_t, 3> place{};
        for (place[2] = 0; place[2] + static_cast<std::size_t>(step[2]) < m_shape.size[2];
             ++place[2]) {
            for (place[1] = 0; place[1] < m_shape.size[1]; ++place[1]) {
                const auto y = static_cast<std::ptrdiff_t>(place[1]) + step[1];
                if (y < 0 || y >= static_cast<std::ptrdiff_t>(m_shape.size[1]))
                    continue;
                const std::size_t first =
                    place[1] * m_shape.stride[1] + place[2] * m_shape.stride[2];
                double inner = 0.0;
                for (std::size_t i = 0; i < m_shape.size[0]; ++i) {
                    const auto x = static_cast<std::ptrdiff_t>(i) + step[0];
                    if (x < 0 || x >= static_cast<std::ptrdiff_t>(m_shape.size[0]))
                        continue;
                    place[0] = i;
                    if (i <= 3 || i + 3 >= m_shape.size[0])
                        inner = penalty * penaltyBetween(place, step);
                    elements[first + i] += inner;
                }
            }
        }
    }
}

void GridSystem::multiplyNeighbours(
    std::size_t j, std::size_t k, const Numbers& x, Numbers& y) const
{
    const auto count = static_cast<std::ptrdiff_t>(m_shape.size[0]);
    const std::size_t first = j * m_shape.stride[1] + k * m_shape.stride[2];
    NodeSegment(&y[first], count) +=
        ConstNodeSegment(&m_matrix[0][first], count) * ConstNodeSegment(&x[first], count);
    for (std::size_t n = 1; n < m_neighbours.size(); ++n) {
        const auto& [step, offset] = m_neighbours[n];
        const auto otherJ = static_cast<std::ptrdiff_t>(j) + step[1];
        const bool isInside = otherJ >= 0 && otherJ < static_cast<std::ptrdiff_t>(m_shape.size[1])
            && k + static_cast<std::size_t>(step[2]) < m_shape.size[2];
        if (!isInside)
            continue;
        const std::size_t from = first + (step[0] < 0 ? 1 : 0);
        const auto to = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + offset);
        const std::ptrdiff_t length = count - std::abs(step[0]);
        const ConstNodeSegment elements(&m_matrix[n][from], length);
        NodeSegment(&y[from], length) += elements * ConstNodeSegment(&x[to], length);
        NodeSegment(&y[to], length) += elements * ConstNodeSegment(&x[from], length);
    }
}

void GridSystem::multiplySecondNeighbours(
    std::size_t j, std::size_t k, const Numbers& x, Numbers& y) const
{
    const std::array<std::size_t, 3> place{0, j, k};
    const std::size_t first = j * m_shape.stride[1] + k * m_shape.stride[2];
    for (std::size_t axis = 0; axis < m_shape.dimensions; ++axis) {
        if (place[axis] + 2 >= m_shape.size[axis])
            continue;
        const auto length = static_cast<std::ptrdiff_t>(m_shape.size[0]) - (axis == 0 ? 2 : 0);
        const std::size_t other = first + 2 * m_shape.stride[axis];
        const double element = m_penalty * m_along[axis];
        NodeSegment(&y[first], length) += element * ConstNodeSegment(&x[other], length);
        NodeSegment(&y[other], length) += element * ConstNodeSegment(&x[first], length);
    }
}

void GridSystem::multiply(const Numbers& x, Numbers& y) const
{
    std::ranges::fill(y, 0.0);
    for (std::size_t k = 0; k < m_shape.size[2]; ++k) {
        for (std::size_t j = 0; j < m_shape.size[1]; ++j) {
            multiplyNeighbours(j, k, x, y);
            if (m_penalty != 0.0)
                multiplySecondNeighbours(j, k, x, y);
        }
    }
}

bool GridSystem::isDiagonal() const
{
    return m_penalty == 0.0
        && std::all_of(m_matrix.begin() + 1, m_matrix.end(), [](const Numbers& elements) {
               return std::ranges::all_of(elements, [](double element) { return element == 0.0; });
           });
}

Result<void> GridSystem::solveDirectly(Numbers& nodes) const
{
    const auto count = static_cast<Eigen::Index>(m_shape.nodes());
    std::vector<Eigen::Triplet<double>> elements;
    const auto add = [&elements](std::size_t row, std::size_t column, double element) {
        if (element != 0.0) // the lower triangle
            elements.emplace_back(static_cast<int>(row), static_cast<int>(column), element);
    };
    for (std::size_t n = 0; n < m_neighbours.size(); ++n)
        for (std::size_t node = 0; node < m_shape.nodes(); ++node)
            add(static_cast<std::size_t>(
                    static_cast<std::ptrdiff_t>(node) + m_neighbours[n].offset),
                node, m_matrix[n][node]);
    for (std::size_t node = 0; node < m_shape.nodes(); ++node)
        for (std::size_t axis = 0; axis < m_shape.dimensions; ++axis)
            if (m_shape.place(node, axis) + 2 < m_shape.size[axis])
                add(node + 2 * m_shape.stride[axis], node, m_penalty * m_along[axis]);
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(elements.begin(), elements.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const bool isSolvable = solver.info() == Eigen::Success && solver.vectorD().minCoeff() > 0.0;
    if (isSolvable)
        vectorOf(nodes) = solver.solve(vectorOf(m_right));
    if (!isSolvable || !vectorOf(nodes).allFinite())
        return fail(ErrorCode::NotConverged,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the points do not determine every point of the grid; take a larger "
                    "smoothness or a coarser grid")}});
    return {};
}

/// Preconditioned conjugate gradients; false: not within the steps.
Result<bool> GridSystem::iterate(
    double tolerance, std::stop_token stop, int mostSteps, Numbers& nodes) const
{
    const std::size_t count = m_shape.nodes();
    Numbers residual(count);
    Numbers product(count);
    Numbers turned(count);
    const double limit = tolerance * vectorOf(m_right).norm();
    multiply(nodes, product);
    vectorOf(residual) = vectorOf(m_right) - vectorOf(product);
    if (vectorOf(residual).norm() <= limit)
        return true;
    m_preconditioner->apply(residual, turned);
    Numbers direction = turned;
    double slope = vectorOf(residual).dot(vectorOf(turned));
    for (int step = 0; step < mostSteps; ++step) {
        if (stop.stop_requested())
            return fail(ErrorCode::Cancelled);
        multiply(direction, product);
        const double length = slope / vectorOf(direction).dot(vectorOf(product));
        if (!std::isfinite(length))
            return false;
        vectorOf(nodes) += length * vectorOf(direction);
        vectorOf(residual) -= length * vectorOf(product);
        if (vectorOf(residual).norm() <= limit)
            return true;
        // Polak and Ribiere: the preconditioner is rounded
        const double before = vectorOf(residual).dot(vectorOf(turned));
        m_preconditioner->apply(residual, turned);
        const double next = vectorOf(residual).dot(vectorOf(turned));
        vectorOf(direction) =
            vectorOf(turned) + std::max(0.0, (next - before) / slope) * vectorOf(direction);
        slope = next;
    }
    return false;
}

Result<void> GridSystem::solve(
    double smoothness, double tolerance, std::stop_token stop, Numbers& nodes)
{
    setPenalty(smoothness * m_weight / static_cast<double>(m_shape.nodes()));
    if (isDiagonal()) {
        for (std::size_t node = 0; node < nodes.size(); ++node)
            nodes[node] = m_right[node] / m_matrix[0][node];
        return {};
    }
    if (m_shape.dimensions == 1)
        return solveDirectly(nodes);
    const bool canBeDirect = m_shape.nodes() <= mostDirectNodes;
    double cells = 1.0;
    for (std::size_t axis = 0; axis < m_shape.dimensions; ++axis)
        cells *= static_cast<double>(m_shape.size[axis] - 1);
    if (!m_preconditioner)
        m_preconditioner = std::make_unique<Preconditioner>(m_shape, m_along, m_across);
    m_preconditioner->use(m_weight / cells, m_penalty);
    AXISCOMP_TRY(const bool isDone, iterate(tolerance, stop, canBeDirect ? 200 : 2000, nodes));
    if (isDone)
        return {};
    if (canBeDirect)
        return solveDirectly(nodes);
    return fail(ErrorCode::NotConverged,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "the points lie too unevenly for so little smoothness; take a larger smoothness "
                "or a coarser grid")}});
}

} // namespace axiscomp
