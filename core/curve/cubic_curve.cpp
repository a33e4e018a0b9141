// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/cubic_curve.h"

#include "core/curve/curve_slopes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace axiscomp {

namespace {

/// The piece of a position between the first knot and the last: knots[piece] <= position <
/// knots[piece + 1]. last: where to look first.
std::size_t pieceOf(const std::vector<double>& knots, double position, std::size_t last)
{
    for (std::size_t i = last; i < std::min(last + 2, knots.size() - 1); ++i)
        if (knots[i] <= position && position < knots[i + 1])
            return i;
    return static_cast<std::size_t>(std::ranges::upper_bound(knots, position) - knots.begin()) - 1;
}

} // namespace

double CubicCurve::at(double position) const
{
    std::size_t piece = 0;
    return at(position, piece);
}

double CubicCurve::at(double position, std::size_t& piece) const
{
    if (wrap)
        position -= std::floor((position - knots.front()) / *wrap) * *wrap;
    if (position <= knots.front())
        return values.front();
    if (position >= knots.back())
        return values.back();
    const std::size_t i = pieceOf(knots, position, piece);
    piece = i;
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

double CubicCurve::slopeAt(double position, std::size_t& piece) const
{
    if (position >= knots.back())
        return slopes.back();
    const std::size_t i = pieceOf(knots, position, piece);
    piece = i;
    const double width = knots[i + 1] - knots[i];
    const double t = (position - knots[i]) / width;
    const double rise = (values[i + 1] - values[i]) / width;
    return slopes[i]
        + t
        * (6.0 * rise - 4.0 * slopes[i] - 2.0 * slopes[i + 1]
            + 3.0 * t * (slopes[i] + slopes[i + 1] - 2.0 * rise));
}

CubicCurve meanOf(const CubicCurve& one, const CubicCurve& other)
{
    const double from = std::max(one.knots.front(), other.knots.front());
    const double to = std::min(one.knots.back(), other.knots.back());
    CubicCurve mean;
    std::ranges::set_union(one.knots, other.knots, std::back_inserter(mean.knots));
    std::size_t piece = 0;
    std::size_t otherPiece = 0;
    for (const double knot : mean.knots) {
        if (knot >= from && knot <= to) {
            mean.values.push_back(0.5 * (one.at(knot, piece) + other.at(knot, otherPiece)));
            mean.slopes.push_back(
                0.5 * (one.slopeAt(knot, piece) + other.slopeAt(knot, otherPiece)));
            continue;
        }
        const bool isOne = knot >= one.knots.front() && knot <= one.knots.back();
        const CubicCurve& goesOn = isOne ? one : other;
        const CubicCurve& ended = isOne ? other : one;
        const double end = std::clamp(knot, from, to);
        std::size_t& place = isOne ? piece : otherPiece;
        mean.values.push_back(goesOn.at(knot, place) + 0.5 * (ended.at(end) - goesOn.at(end)));
        mean.slopes.push_back(goesOn.slopeAt(knot, place));
    }
    return mean;
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
    std::vector<double> slopes;
    findSplineSlopes(knots, values, isClosed, slopes);
    return slopes;
}

std::vector<double> monotoneSlopes(
    std::span<const double> knots, std::span<const double> values, bool isClosed)
{
    std::vector<double> slopes;
    findMonotoneSlopes(knots, values, isClosed, slopes);
    return slopes;
}

} // namespace axiscomp
