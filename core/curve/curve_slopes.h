// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace axiscomp {

// Slopes of cubic curves (cubic_curve.h). Number: double, or Eight for eight curves over the same
// knots, each with the same bits.

namespace detail {

template <typename Number> struct CurveCells {
    std::span<const double> knots;
    std::span<const Number> values;

    [[nodiscard]] std::size_t count() const { return knots.size() - 1; }
    [[nodiscard]] double width(std::size_t cell) const { return knots[cell + 1] - knots[cell]; }
    [[gnu::always_inline]] void slope(std::size_t cell, Number& slope) const
    {
        slope = (values[cell + 1] - values[cell]) / width(cell);
    }
};

/// The slope at a knot between two cells: a harmonic mean, weighted so that the cubic is monotone
/// where the knots are.
template <typename Number>
[[gnu::always_inline]] inline void innerSlope(
    const CurveCells<Number>& cells, std::size_t before, std::size_t behind, Number& slope)
{
    Number left;
    Number right;
    cells.slope(before, left);
    cells.slope(behind, right);
    const double leftWeight = 2.0 * cells.width(behind) + cells.width(before);
    const double rightWeight = cells.width(behind) + 2.0 * cells.width(before);
    const Number mean = (leftWeight + rightWeight) / (leftWeight / left + rightWeight / right);
    slope = left * right > 0.0 ? mean : Number{};
}

/// The slope at an end: that of the parabola through three knots, bent as far as monotony demands.
template <typename Number>
[[gnu::always_inline]] inline void endSlope(
    const CurveCells<Number>& cells, std::size_t cell, std::size_t next, Number& slope)
{
    Number own;
    Number other;
    cells.slope(cell, own);
    cells.slope(next, other);
    const double width = cells.width(cell);
    const double nextWidth = cells.width(next);
    const Number parabola = ((2.0 * width + nextWidth) * own - width * other) / (width + nextWidth);
    const Number size = parabola < 0.0 ? -parabola : parabola;
    const Number most = 3.0 * (own < 0.0 ? -own : own);
    const Number held = size > most ? 3.0 * own : parabola;
    const Number bent = own * other < 0.0 ? held : parabola;
    slope = parabola * own > 0.0 ? bent : Number{};
}

/// The equations that make the second derivative continuous at knot i:
///     w_i y'_(i-1) + 2 (w_(i-1) + w_i) y'_i + w_(i-1) y'_(i+1) = 3 (w_i s_(i-1) + w_(i-1) s_i)
/// with the widths w and slopes s of the cells before (i - 1) and behind (i) the knot.
template <typename Number> struct SlopeEquations {
    std::vector<double> lower, diagonal, upper;
    std::vector<Number> right;

    void add(const CurveCells<Number>& cells, std::size_t before, std::size_t behind)
    {
        const double left = cells.width(before);
        const double width = cells.width(behind);
        Number slopeBefore;
        Number slopeBehind;
        cells.slope(before, slopeBefore);
        cells.slope(behind, slopeBehind);
        lower.push_back(width);
        diagonal.push_back(2.0 * (left + width));
        upper.push_back(left);
        right.push_back(3.0 * (width * slopeBefore + left * slopeBehind));
    }
};

/// Solves lower[i] x[i-1] + diagonal[i] x[i] + upper[i] x[i+1] = x[i] (the right side) in place;
/// diagonally dominant.
template <typename Number>
void solveTridiagonal(const std::vector<double>& lower, std::vector<double> diagonal,
    const std::vector<double>& upper, std::vector<Number>& x)
{
    for (std::size_t i = 1; i < x.size(); ++i) {
        const double factor = lower[i] / diagonal[i - 1];
        diagonal[i] -= factor * upper[i - 1];
        x[i] -= factor * x[i - 1];
    }
    x.back() /= diagonal.back();
    for (std::size_t i = x.size() - 1; i-- > 0;)
        x[i] = (x[i] - upper[i] * x[i + 1]) / diagonal[i];
}

template <typename Number>
void naturalSlopes(const CurveCells<Number>& cells, std::vector<Number>& slopes)
{
    const std::size_t last = cells.count();
    Number end;
    cells.slope(0, end);
    SlopeEquations<Number> equations{{0.0}, {2.0}, {1.0}, {}};
    equations.right.push_back(3.0 * end);
    for (std::size_t i = 1; i < last; ++i)
        equations.add(cells, i - 1, i);
    cells.slope(last - 1, end);
    equations.lower.push_back(1.0);
    equations.diagonal.push_back(2.0);
    equations.upper.push_back(0.0);
    equations.right.push_back(3.0 * end);
    solveTridiagonal(equations.lower, equations.diagonal, equations.upper, equations.right);
    slopes = std::move(equations.right);
}

/// The equations of a ring are tridiagonal but for two corners, which the first slope brings in:
/// x = p + first * q, where p and q solve the others.
template <typename Number>
void closedSlopes(const CurveCells<Number>& cells, std::vector<Number>& slopes)
{
    const std::size_t last = cells.count();
    slopes.assign(cells.knots.size(), Number{});
    if (last == 1) // one place, and one value
        return;
    SlopeEquations<Number> equations;
    for (std::size_t i = 1; i < last; ++i)
        equations.add(cells, i - 1, i);
    std::vector<double> first(last - 1, 0.0);
    first.front() = -equations.lower.front();
    first.back() -= equations.upper.back();
    solveTridiagonal(equations.lower, equations.diagonal, equations.upper, equations.right);
    solveTridiagonal(equations.lower, equations.diagonal, equations.upper, first);
    SlopeEquations<Number> ring;
    ring.add(cells, last - 1, 0);
    const Number slope = (ring.right[0] - ring.upper[0] * equations.right.front()
                             - ring.lower[0] * equations.right.back())
        / (ring.diagonal[0] + ring.upper[0] * first.front() + ring.lower[0] * first.back());
    slopes.front() = slope;
    for (std::size_t i = 0; i < first.size(); ++i)
        slopes[i + 1] = equations.right[i] + slope * first[i];
    slopes.back() = slope;
}

} // namespace detail

/// Slopes of the natural cubic spline through values at knots: the second derivative is continuous,
/// and 0 at both ends. isClosed: the last knot is the first one again, and the curve goes on there
/// (first value = last value).
template <typename Number>
void findSplineSlopes(std::span<const double> knots, std::span<const Number> values, bool isClosed,
    std::vector<Number>& slopes)
{
    const detail::CurveCells<Number> cells{knots, values};
    if (isClosed)
        detail::closedSlopes(cells, slopes);
    else
        detail::naturalSlopes(cells, slopes);
}

/// Slopes of the monotone cubic through values at knots: weighted harmonic means, so that the curve
/// never overshoots the values (Fritsch and Carlson 1980; slopes of Fritsch and Butland 1984, as in
/// SLATEC's PCHIM).
template <typename Number>
void findMonotoneSlopes(std::span<const double> knots, std::span<const Number> values,
    bool isClosed, std::vector<Number>& slopes)
{
    const detail::CurveCells<Number> cells{knots, values};
    const std::size_t last = cells.count();
    slopes.resize(knots.size());
    for (std::size_t i = 1; i < last; ++i)
        detail::innerSlope(cells, i - 1, i, slopes[i]);
    if (isClosed) {
        detail::innerSlope(cells, last - 1, 0, slopes.front());
        slopes.back() = slopes.front();
    } else if (last == 1) {
        cells.slope(0, slopes.front());
        slopes.back() = slopes.front();
    } else {
        detail::endSlope(cells, 0, 1, slopes.front());
        detail::endSlope(cells, last - 1, last - 2, slopes.back());
    }
}

} // namespace axiscomp
