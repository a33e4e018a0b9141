// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/compensation_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiscomp {

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

LoadedTable loaded(std::shared_ptr<const CompensationTable> table)
{
    if (!table)
        return {};
    const auto largest =
        std::ranges::max_element(table->values, {}, [](float value) { return std::abs(value); });
    const auto element = static_cast<std::size_t>(largest - table->values.begin());
    return {std::move(table), element};
}

} // namespace axiscomp
