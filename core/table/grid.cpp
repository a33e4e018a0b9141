// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/grid.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

bool sameSpans(const Grid& a, const Grid& b)
{
    return std::ranges::equal(a.axes, b.axes, [](const GridAxis& x, const GridAxis& y) {
        return x.start == y.start && x.distance == y.distance && x.size == y.size;
    });
}

namespace {

template <typename Values> TableStatistics figuresOf(const Values& values)
{
    if (values.empty())
        return {};
    const auto [minimum, maximum] = std::ranges::minmax(values);
    double squares = 0.0;
    for (const auto value : values)
        squares += static_cast<double>(value) * static_cast<double>(value);
    return {static_cast<double>(minimum), static_cast<double>(maximum),
        std::sqrt(squares / static_cast<double>(values.size()))};
}

} // namespace

TableStatistics statistics(const CompensationTable& table)
{
    return figuresOf(table.values);
}

TableStatistics statisticsOf(std::span<const double> values)
{
    return figuresOf(values);
}

} // namespace axiscomp
