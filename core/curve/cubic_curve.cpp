// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/cubic_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace axiscomp {

namespace {

/// The slope at a knot between two cells: a harmonic mean, weighted so that the cubic is monotone
/// where the knots are.
double innerSlope(double leftWidth, double left, double rightWidth, double right)
{
    if (!(left * right > 0.0))
        return 0.0;
    const double leftWeight = 2.0 * rightWidth + leftWidth;
    const double rightWeight = rightWidth + 2.0 * leftWidth;
    return (leftWeight + rightWeight) / (leftWeight / left + rightWeight / right);
}

/// The slope at an end: that of the parabola through three knots, bent as far as monotony demands.
double endSlope(double width, double slope, double nextWidth, double nextSlope)
{
    const double parabola =
        ((2.0 * width + nextWidth) * slope - width * nextSlope) / (width + nextWidth);
    if (!(parabola * slope > 0.0))
        return 0.0;
    const bool turns = slope * nextSlope < 0.0;
    return turns && std::abs(parabola) > 3.0 * std::abs(slope) ? 3.0 * slope : parabola;
}

struct Cells {
    std::span<const double> knots;
    std::span<const double> values;

    [[nodiscard]] std::size_t count() const { return knots.size() - 1; }
    [[nodiscard]] double width(std::size_t cell) const { return knots[cell + 1] - knots[cell]; }
    [[nodiscard]] double slope(std::size_t cell) const
    {
        return (values[cell + 1] - values[cell]) / width(cell);
    }
};

/// Solves lower[i] x[i-1] + diagonal[i] x[i] + upper[i] x[i+1] = x[i] (the right side) in place;
/// diagonally dominant.
void solveTridiagonal(const std::vector<double>& lower, std::vector<double> diagonal,
    const std::vector<double>& upper, std::vector<double>& x)
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

/// The equations that make the second derivative continuous at knot i:
///     w_i y'_(i-1) + 2 (w_(i-1) + w_i) y'_i + w_(i-1) y'_(i+1) = 3 (w_i s_(i-1) + w_(i-1) s_i)
/// with the widths w and slopes s of the cells before (i - 1) and behind (i) the knot.
struct SlopeEquations {
    std::vector<double> lower, diagonal, upper, right;

    void add(const Cells& cells, std::size_t before, std::size_t behind)
    {
        const double left = cells.width(before);
        const double width = cells.width(behind);
        lower.push_back(width);
        diagonal.push_back(2.0 * (left + width));
        upper.push_back(left);
        right.push_back(3.0 * (width * cells.slope(before) + left * cells.slope(behind)));
    }
};

std::vector<double> naturalSlopes(const Cells& cells)
{
    const std::size_t last = cells.count();
    SlopeEquations equations{{0.0}, {2.0}, {1.0}, {3.0 * cells.slope(0)}};
    for (std::size_t i = 1; i < last; ++i)
        equations.add(cells, i - 1, i);
    equations.lower.push_back(1.0);
    equations.diagonal.push_back(2.0);
    equations.upper.push_back(0.0);
    equations.right.push_back(3.0 * cells.slope(last - 1));
    solveTridiagonal(equations.lower, equations.diagonal, equations.upper, equations.right);
    return equations.right;
}

/// The equations of a ring are tridiagonal but for two corners, which the first slope brings in:
/// x = p + first * q, where p and q solve the others.
std::vector<double> closedSlopes(const Cells& cells)
{
    const std::size_t last = cells.count();
    if (last == 1) // one place, and one value
        return {0.0, 0.0};
    SlopeEquations equations;
    for (std::size_t i = 1; i < last; ++i)
        equations.add(cells, i - 1, i);
    std::vector<double> first(last - 1, 0.0);
    first.front() = -equations.lower.front();
    first.back() -= equations.upper.back();
    solveTridiagonal(equations.lower, equations.diagonal, equations.upper, equations.right);
    solveTridiagonal(equations.lower, equations.diagonal, equations.upper, first);
    SlopeEquations ring;
    ring.add(cells, last - 1, 0);
    const double slope = (ring.right[0] - ring.upper[0] * equations.right.front()
                             - ring.lower[0] * equations.right.back())
        / (ring.diagonal[0] + ring.upper[0] * first.front() + ring.lower[0] * first.back());
    std::vector<double> slopes{slope};
    for (std::size_t i = 0; i < first.size(); ++i)
        slopes.push_back(equations.right[i] + slope * first[i]);
    slopes.push_back(slope);
    return slopes;
}

} // namespace

double CubicCurve::at(double position) const
{
    if (wrap)
        position -= std::floor((position - knots.front()) / *wrap) * *wrap;
    if (position <= knots.front())
        return values.front();
    if (position >= knots.back())
        return values.back();
    const auto above = std::ranges::upper_bound(knots, position);
    const auto i = static_cast<std::size_t>(above - knots.begin()) - 1;
    const double width = knots[i + 1] - knots[i];
    const double t = (position - knots[i]) / width;
    const double rise = values[i + 1] - values[i];
    if (slopes.empty())
        return values[i] + t * rise;
    const double begin = width * slopes[i];
    const double end = width * slopes[i + 1];
    return values[i]
        + t * (begin + t * (3.0 * rise - 2.0 * begin - end + t * (begin + end - 2.0 * rise)));
}

void closeIfWrapped(CubicCurve& curve)
{
    if (!curve.wrap)
        return;
    curve.knots.push_back(curve.knots.front() + *curve.wrap);
    curve.values.push_back(curve.values.front());
}

std::vector<double> splineSlopes(
    std::span<const double> knots, std::span<const double> values, bool isClosed)
{
    const Cells cells{knots, values};
    return isClosed ? closedSlopes(cells) : naturalSlopes(cells);
}

std::vector<double> monotoneSlopes(
    std::span<const double> knots, std::span<const double> values, bool isClosed)
{
    const Cells cells{knots, values};
    const std::size_t last = cells.count();
    std::vector<double> slopes(knots.size());
    for (std::size_t i = 1; i < last; ++i)
        slopes[i] =
            innerSlope(cells.width(i - 1), cells.slope(i - 1), cells.width(i), cells.slope(i));
    if (isClosed) {
        slopes.front() = innerSlope(
            cells.width(last - 1), cells.slope(last - 1), cells.width(0), cells.slope(0));
        slopes.back() = slopes.front();
    } else if (last == 1) {
        slopes.front() = cells.slope(0);
        slopes.back() = cells.slope(0);
    } else {
        slopes.front() = endSlope(cells.width(0), cells.slope(0), cells.width(1), cells.slope(1));
        slopes.back() = endSlope(cells.width(last - 1), cells.slope(last - 1),
            cells.width(last - 2), cells.slope(last - 2));
    }
    return slopes;
}

} // namespace axiscomp
