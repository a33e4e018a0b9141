// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/wrap_range.h"

#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

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

} // namespace axiscomp
