// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/deformed_grid.h"

#include "core/table/lookup.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

ContourPoint ErrorPlane::at(std::size_t i, std::size_t j, double exaggeration) const
{
    const GridAxis& x = grid().axes[0];
    const GridAxis& y = grid().axes[1];
    const std::size_t point = i + j * x.size;
    return {
        x.position(i) + exaggeration * perValue[0] * static_cast<double>(errors[0]->values[point]),
        y.position(j) + exaggeration * perValue[1] * static_cast<double>(errors[1]->values[point])};
}

ContourPoint ErrorPlane::at(const ContourPoint& place, double exaggeration) const
{
    return {place.x + exaggeration * perValue[0] * Lookup(*errors[0]).at(place.x, place.y),
        place.y + exaggeration * perValue[1] * Lookup(*errors[1]).at(place.x, place.y)};
}

double ErrorPlane::largest(std::size_t dimension) const
{
    const TableStatistics numbers = statistics(*errors.at(dimension));
    return perValue.at(dimension) * std::max(-numbers.minimum, numbers.maximum);
}

DrawnLines drawnLines(const GridAxis& axis, double from, double to, int most)
{
    const double last = axis.size - 1.0;
    const auto indexAt = [&](double position) {
        return static_cast<std::size_t>(
            std::clamp((position - axis.start) / axis.distance, 0.0, last));
    };
    // One more on each side: lines go on to the border of what is seen.
    const std::size_t begin = indexAt(from);
    const std::size_t end = std::min(indexAt(to) + 1, std::size_t{axis.size} - 1);
    DrawnLines drawn;
    const auto enough = static_cast<std::size_t>(most);
    for (std::size_t power = 1; drawn.step * enough < end - begin; power *= 10)
        for (const std::size_t factor : {std::size_t{1}, std::size_t{2}, std::size_t{5}})
            if (drawn.step * enough < end - begin)
                drawn.step = factor * power;
    // Always the same lines, wherever the sight begins.
    constexpr std::size_t pointsPerLine = 8;
    const std::size_t between = std::max(std::size_t{1}, drawn.step / pointsPerLine);
    const auto fill = [&](std::vector<std::size_t>& indices, std::size_t step) {
        for (std::size_t n = begin - begin % step; n < end; n += step)
            indices.push_back(n);
        indices.push_back(end);
    };
    fill(drawn.lines, drawn.step);
    fill(drawn.points, between);
    return drawn;
}

double fittingExaggeration(const ErrorPlane& plane)
{
    constexpr double part = 1.0 / 10.0;
    constexpr double most = 1e12; // there are no errors
    double factor = most;
    for (std::size_t n = 0; n < plane.errors.size(); ++n) {
        const GridAxis& axis = plane.grid().axes[n];
        if (const double largest = plane.largest(n); largest > 0.0)
            factor = std::min(factor, part * (axis.last() - axis.start) / largest);
    }
    return factor < most ? factor : 1.0;
}

} // namespace axiscomp::ui
