// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/rapidcode/rapidcode_table.h"

#include "core/formats/format_writer.h"
#include "core/formats/units.h"
#include "core/table/even_spacing.h"
#include "core/table/grid.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

/// There is no correction beyond the ends: one that rounding put inside of the last position that a
/// person gave would take the correction from that.
double plainEnd(double end)
{
    const double plain = numberOf(roundedText(end)).value_or(end);
    return InsideRange(end, end).contains(plain) ? plain : end;
}

RapidCodeInput inputOf(const SourceAxis& axis)
{
    constexpr int noDecimals = -30;
    const double delta = fitEvenSpacing(axis.knots, noDecimals).distance;
    return {plainEnd(axis.knots.front()), plainEnd(axis.knots.back()), delta, axis.knots.size()};
}

Result<std::vector<std::int64_t>> countsOf(
    const FormatFacts& facts, const std::vector<double>& values, double countsPerUnit)
{
    constexpr double largest = std::numeric_limits<std::int32_t>::max();
    std::vector<std::int64_t> counts;
    counts.reserve(values.size());
    for (const double value : values) {
        const double count = std::round(value * countsPerUnit);
        if (!(std::abs(count) <= largest))
            return cannotHold(facts,
                AXISCOMP_TEXT("Error",
                    "the value {value} is {count} counts, and at most 2147483647 can be held")
                    .with("value", Quantity{toText(value)})
                    .with("count", Quantity{toText(count)}),
                AXISCOMP_TEXT("Error", "check counts-per-unit and the unit of the values"));
        counts.push_back(static_cast<std::int64_t>(count));
    }
    return counts;
}

} // namespace

std::vector<double> RapidCodeInput::knots() const
{
    std::vector<double> positions = evenKnots(minimum, delta, points);
    positions.back() = maximum;
    return positions;
}

std::optional<std::size_t> rapidCodePoints(double minimum, double maximum, double delta)
{
    const double cells = (maximum - minimum) / delta;
    if (!(cells >= 0.5 && cells < static_cast<double>(rapidCodeMostPoints)))
        return std::nullopt;
    if (std::abs(cells - std::round(cells)) > 1e-9 * cells)
        return std::nullopt;
    return static_cast<std::size_t>(std::llround(cells)) + 1;
}

Result<RapidCodeTable> rapidCodeTable(const FormatFacts& facts, const NeutralTable& table,
    const SettingValues& settings, std::vector<Text>& remarks)
{
    AXISCOMP_TRY(auto converted, inSettingUnits(table, settings, remarks));
    RapidCodeTable result;
    result.countsPerUnit = settings.number("counts-per-unit");
    if (result.countsPerUnit == 0.0)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT(
                    "Error", "the setting counts-per-unit is 0, expected a number of counts")}});
    CompensationColumn& column = converted.columns.front();
    AXISCOMP_TRY(auto counts, countsOf(facts, column.values, result.countsPerUnit));
    result.counts = std::move(counts);
    for (std::size_t i = 0; i < result.counts.size(); ++i)
        column.values[i] = static_cast<double>(result.counts[i]) / result.countsPerUnit;
    result.actsOnInput = ownAxis(table, table.columns.front()).has_value();
    if (converted.name.empty())
        converted.name = column.name;
    column.name.clear();
    for (SourceAxis& axis : converted.axes) {
        result.inputs.push_back(inputOf(axis));
        axis.knots = result.inputs.back().knots();
        axis.step = 0.0;
    }
    converted.notes.clear();
    result.held = std::move(converted);
    remarks.push_back(
        (column.unit.empty() ? AXISCOMP_TEXT(
             "Error", "counts-per-unit is understood as {count} counts for 1 unit of the values")
                             : AXISCOMP_TEXT("Error",
                                 "counts-per-unit is understood as {count} counts for 1 {unit}"))
            .with("count", Quantity{toText(result.countsPerUnit)})
            .with("unit", column.unit));
    remarks.push_back(rapidCodeInputAdvice(result));
    return result;
}

Text rapidCodeInputAdvice(const RapidCodeTable& table)
{
    return table.actsOnInput
        ? AXISCOMP_TEXT("Error",
            "an input axis is the output axis: its command position must be the input, the actual "
            "position is not possible")
        : AXISCOMP_TEXT("Error",
            "the inputs are other axes: their command or their actual positions can be the inputs");
}

std::string oneLine(std::string_view text)
{
    const std::string clean = toUtf8(text, Encoding::Utf8);
    return std::string(trimmed(clean));
}

} // namespace axiscomp
