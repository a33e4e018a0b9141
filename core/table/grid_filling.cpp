// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/grid_filling.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace axiscomp {

namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

using Index = std::array<std::size_t, 3>;

struct Shape {
    std::size_t dimensions;
    Index size{1, 1, 1};
    Index stride{1, 1, 1};

    explicit Shape(const GridCoordinates& coordinates) : dimensions(coordinates.size())
    {
        for (std::size_t d = 0; d < dimensions; ++d)
            size[d] = coordinates[d].size();
        stride = {1, size[0], size[0] * size[1]};
    }
    [[nodiscard]] std::size_t points() const { return size[0] * size[1] * size[2]; }
    [[nodiscard]] std::size_t index(std::size_t point, std::size_t d) const
    {
        return point / stride[d] % size[d];
    }
};

/// The lower envelope of parabolas over one line of the grid: for each of its places the one that
/// is lowest there (Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, 2012).
class LineEnvelope {
public:
    LineEnvelope(const std::vector<double>& places)
        : m_places(places)
        , m_squares(places.size())
        , m_nearest(places.size())
    {
    }

    /// The squared distance of what each place knows, infinite where it knows nothing; nearest() is
    /// the place that knows what is nearest.
    void find(std::vector<double>& squares);
    [[nodiscard]] std::size_t nearest(std::size_t place) const { return m_nearest[place]; }

private:
    struct Piece {
        std::size_t place;
        double from;
    };
    /// From where on the second of two parabolas is lower.
    [[nodiscard]] double crossing(
        const std::vector<double>& squares, std::size_t first, std::size_t second) const
    {
        const double a = m_places[first];
        const double b = m_places[second];
        return ((squares[second] + b * b) - (squares[first] + a * a)) / (2.0 * (b - a));
    }

    const std::vector<double>& m_places;
    std::vector<double> m_squares;
    std::vector<std::size_t> m_nearest;
    std::vector<Piece> m_pieces;
};

void LineEnvelope::find(std::vector<double>& squares)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    m_pieces.clear();
    for (std::size_t place = 0; place < squares.size(); ++place) {
        if (squares[place] == infinite)
            continue;
        double from = -infinite;
        while (!m_pieces.empty()) {
            from = crossing(squares, m_pieces.back().place, place);
            if (from > m_pieces.back().from)
                break;
            m_pieces.pop_back();
            from = -infinite;
        }
        m_pieces.push_back({place, from});
    }
    if (m_pieces.empty()) {
        m_nearest.assign(squares.size(), nowhere);
        return;
    }
    std::size_t piece = 0;
    for (std::size_t place = 0; place < squares.size(); ++place) {
        while (piece + 1 < m_pieces.size() && m_pieces[piece + 1].from < m_places[place])
            ++piece;
        m_nearest[place] = m_pieces[piece].place;
        const double step = m_places[place] - m_places[m_nearest[place]];
        m_squares[place] = squares[m_nearest[place]] + step * step;
    }
    squares.swap(m_squares);
}

/// A plane in coordinates from -1 to 1, so that its equations are well conditioned.
struct Plane {
    Eigen::Vector4d coefficients = Eigen::Vector4d::Zero();
    bool isDetermined = false;
};

Eigen::Vector4d planeRow(const GridCoordinates& coordinates, const Shape& shape, std::size_t point)
{
    Eigen::Vector4d row = Eigen::Vector4d::Zero();
    for (std::size_t d = 0; d < shape.dimensions; ++d) {
        const std::vector<double>& places = coordinates[d];
        const double half = 0.5 * (places.back() - places.front());
        row[static_cast<Eigen::Index>(d)] =
            (places[shape.index(point, d)] - places.front()) / half - 1.0;
    }
    row[static_cast<Eigen::Index>(shape.dimensions)] = 1.0;
    return row;
}

Plane leastSquaresPlane(
    const GridCoordinates& coordinates, const Shape& shape, std::span<const double> values)
{
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t point = 0; point < values.size(); ++point) {
        if (std::isnan(values[point]))
            continue;
        const Eigen::Vector4d row = planeRow(coordinates, shape, point);
        normal += row * row.transpose();
        right += values[point] * row;
    }
    const auto unknowns = static_cast<Eigen::Index>(shape.dimensions + 1);
    Eigen::FullPivHouseholderQR<Eigen::MatrixXd> solver(normal.topLeftCorner(unknowns, unknowns));
    solver.setThreshold(1e-12);
    Plane plane;
    plane.isDetermined = solver.rank() == unknowns;
    if (plane.isDetermined)
        plane.coefficients.head(unknowns) = solver.solve(right.head(unknowns));
    return plane;
}

/// The equations of the values that bend least. One for each second difference that a missing point
/// takes part in: along a dimension, and mixed, which counts twice as in the energy of a thin
/// plate.
class Bending {
public:
    Bending(const GridCoordinates& coordinates, const Shape& shape, std::span<double> values)
        : m_coordinates(coordinates)
        , m_shape(shape)
        , m_values(values)
        , m_unknownOf(values.size(), nowhere)
    {
        for (std::size_t point = 0; point < values.size(); ++point)
            if (std::isnan(values[point])) {
                m_unknownOf[point] = m_missing.size();
                m_missing.push_back(point);
            }
    }

    [[nodiscard]] bool solve();

private:
    struct Term {
        std::size_t point;
        double factor;
    };
    void addStraight(std::size_t point, std::size_t d);
    void addMixed(std::size_t point, std::size_t d, std::size_t e);
    void addEquation(std::span<const Term> terms);
    [[nodiscard]] double step(std::size_t point, std::size_t d, std::size_t ahead) const
    {
        const std::size_t i = m_shape.index(point, d) + ahead;
        return m_coordinates[d][i + 1] - m_coordinates[d][i];
    }

    const GridCoordinates& m_coordinates;
    const Shape& m_shape;
    std::span<double> m_values;
    std::vector<std::size_t> m_unknownOf;
    std::vector<std::size_t> m_missing;
    std::vector<Eigen::Triplet<double>> m_factors;
    std::vector<double> m_known; ///< of each equation: what the measured points contribute
};

void Bending::addEquation(std::span<const Term> terms)
{
    double known = 0.0;
    bool isOfInterest = false;
    for (const Term& term : terms) {
        if (m_unknownOf[term.point] == nowhere)
            known -= term.factor * m_values[term.point];
        else
            isOfInterest = true;
    }
    if (!isOfInterest)
        return;
    const auto row = static_cast<int>(m_known.size());
    for (const Term& term : terms)
        if (m_unknownOf[term.point] != nowhere)
            m_factors.emplace_back(row, static_cast<int>(m_unknownOf[term.point]), term.factor);
    m_known.push_back(known);
}

void Bending::addStraight(std::size_t point, std::size_t d)
{
    if (m_shape.index(point, d) + 2 >= m_shape.size[d])
        return;
    const double before = step(point, d, 0);
    const double after = step(point, d, 1);
    const double first = 2.0 / (before * (before + after));
    const double last = 2.0 / (after * (before + after));
    const std::size_t stride = m_shape.stride[d];
    addEquation(std::array{
        Term{point, first}, Term{point + stride, -first - last}, Term{point + 2 * stride, last}});
}

void Bending::addMixed(std::size_t point, std::size_t d, std::size_t e)
{
    if (m_shape.index(point, d) + 1 >= m_shape.size[d]
        || m_shape.index(point, e) + 1 >= m_shape.size[e])
        return;
    const double factor = std::sqrt(2.0) / (step(point, d, 0) * step(point, e, 0));
    const std::size_t right = m_shape.stride[d];
    const std::size_t up = m_shape.stride[e];
    addEquation(std::array{Term{point, factor}, Term{point + right, -factor},
        Term{point + up, -factor}, Term{point + right + up, factor}});
}

bool Bending::solve()
{
    for (std::size_t point = 0; point < m_values.size(); ++point)
        for (std::size_t d = 0; d < m_shape.dimensions; ++d) {
            addStraight(point, d);
            for (std::size_t e = d + 1; e < m_shape.dimensions; ++e)
                addMixed(point, d, e);
        }
    Eigen::SparseMatrix<double> equations(
        static_cast<Eigen::Index>(m_known.size()), static_cast<Eigen::Index>(m_missing.size()));
    equations.setFromTriplets(m_factors.begin(), m_factors.end());
    const Eigen::Map<const Eigen::VectorXd> known(
        m_known.data(), static_cast<Eigen::Index>(m_known.size()));
    const Eigen::SparseMatrix<double> normal = equations.transpose() * equations;
    const Eigen::VectorXd right = equations.transpose() * known;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    if (solver.info() != Eigen::Success)
        return false;
    const Eigen::VectorXd solution = solver.solve(right);
    if (!solution.allFinite())
        return false;
    for (std::size_t n = 0; n < m_missing.size(); ++n)
        m_values[m_missing[n]] = solution[static_cast<Eigen::Index>(n)];
    return true;
}

} // namespace

void fillNearest(const GridCoordinates& coordinates, std::span<double> values)
{
    const Shape shape(coordinates);
    std::vector<double> squares(values.size());
    std::vector<std::size_t> from(values.size());
    for (std::size_t point = 0; point < values.size(); ++point) {
        const bool isMissing = std::isnan(values[point]);
        squares[point] = isMissing ? std::numeric_limits<double>::infinity() : 0.0;
        from[point] = isMissing ? nowhere : point;
    }
    for (std::size_t d = 0; d < shape.dimensions; ++d) {
        LineEnvelope envelope(coordinates[d]);
        std::vector<double> line(shape.size[d]);
        std::vector<std::size_t> known(shape.size[d]);
        for (std::size_t begin = 0; begin < values.size(); ++begin) {
            if (shape.index(begin, d) != 0)
                continue;
            for (std::size_t i = 0; i < line.size(); ++i) {
                line[i] = squares[begin + i * shape.stride[d]];
                known[i] = from[begin + i * shape.stride[d]];
            }
            envelope.find(line);
            for (std::size_t i = 0; i < line.size() && envelope.nearest(i) != nowhere; ++i) {
                squares[begin + i * shape.stride[d]] = line[i];
                from[begin + i * shape.stride[d]] = known[envelope.nearest(i)];
            }
        }
    }
    for (std::size_t point = 0; point < values.size(); ++point)
        if (from[point] != point)
            values[point] = values[from[point]];
}

bool fillPlane(const GridCoordinates& coordinates, std::span<double> values)
{
    const Shape shape(coordinates);
    const Plane plane = leastSquaresPlane(coordinates, shape, values);
    if (!plane.isDetermined)
        return false;
    for (std::size_t point = 0; point < values.size(); ++point)
        if (std::isnan(values[point]))
            values[point] = plane.coefficients.dot(planeRow(coordinates, shape, point));
    return true;
}

bool fillSmooth(const GridCoordinates& coordinates, std::span<double> values)
{
    const Shape shape(coordinates);
    return leastSquaresPlane(coordinates, shape, values).isDetermined
        && Bending(coordinates, shape, values).solve();
}

std::size_t mostSmoothPoints(std::size_t dimensions)
{
    return dimensions < 3 ? 200'000 : 20'000;
}

} // namespace axiscomp
