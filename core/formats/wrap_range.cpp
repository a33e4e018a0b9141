// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/wrap_range.h"

#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

Result<void> checkWrapRange(const FormatSettings& given)
{
    const auto wrap = given.find(wrapRangeKey);
    if (wrap == given.end() || numberOf(wrap->second).value_or(1.0) > 0.0)
        return {};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error", "the setting wrap-range is {value}, expected more than 0")
                .with("value", wrap->second)}});
}

Result<void> takeWrapRange(SourceAxis& axis, const SettingValues& values)
{
    if (!values.has(wrapRangeKey))
        return {};
    const double wrap = values.number(wrapRangeKey);
    if (axis.wrap && std::abs(*axis.wrap - wrap) > 1e-12 * wrap)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the setting wrap-range is {value}, and the table repeats after {period}")
                    .with("value", Quantity{toText(wrap)})
                    .with("period", Quantity{roundedText(*axis.wrap)})}});
    axis.wrap = wrap;
    return {};
}

NeutralTable asWholeTurn(NeutralTable table, const FormatSettings& given)
{
    const auto wrap = given.find(wrapRangeKey);
    const auto range = wrap == given.end() ? std::nullopt : numberOf(wrap->second);
    if (!range || table.axes.size() != 1 || table.axes[0].wrap)
        return table;
    const std::string& unit = table.axes[0].unit;
    auto fileUnit = given.find("position-unit"); // of such a file it is that of the values
    if (fileUnit == given.end())
        fileUnit = given.find("value-unit");
    const auto factor =
        commonUnitFactor(fileUnit == given.end() ? std::string() : fileUnit->second, unit);
    const bool isClosed = std::ranges::all_of(table.columns, [](const CompensationColumn& column) {
        return column.values.front() == column.values.back();
    });
    if (!factor || !isClosed)
        return table;
    NeutralTable turn = table;
    turn.axes[0].wrap = *range * *factor;
    return isFullTurn(turn.axes[0]) && checkConsistent(turn) ? turn : table;
}

} // namespace axiscomp
