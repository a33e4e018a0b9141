// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/cubic_curve.h"

#include "core/curve/curve_slopes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace axiscomp {

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
