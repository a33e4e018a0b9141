// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/compensation_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiscomp {

SurveyedTable surveyed(std::shared_ptr<const CompensationTable> table)
{
    if (!table)
        return {};
    const auto largest =
        std::ranges::max_element(table->values, {}, [](float value) { return std::abs(value); });
    const auto element = static_cast<std::size_t>(largest - table->values.begin());
    return {std::move(table), element};
}

} // namespace axiscomp
