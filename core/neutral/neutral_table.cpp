// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/neutral_table.h"

#include "core/table/even_spacing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiscomp {

std::string_view signName(SignConvention sign)
{
    return sign == SignConvention::Feedback ? "feedback" : "command";
}

std::string_view directionName(Direction direction)
{
    switch (direction) {
    case Direction::Positive:
        return "positive";
    case Direction::Negative:
        return "negative";
    case Direction::Both:
        break;
    }
    return "both";
}

std::size_t NeutralTable::pointCount() const
{
    std::size_t count = axes.empty() ? 0 : 1;
    for (const SourceAxis& axis : axes)
        count *= axis.knots.size();
    return count;
}

bool isEven(const SourceAxis& axis)
{
    const EvenSpacing spacing = fitEvenSpacing(axis.knots, noDecimals);
    return spacing.even || spacing.deviation <= axis.step / 2.0;
}

bool isEven(const NeutralTable& table)
{
    return std::ranges::all_of(table.axes, [](const SourceAxis& axis) { return isEven(axis); });
}

std::optional<std::size_t> ownAxis(const NeutralTable& table, const CompensationColumn& column)
{
    const auto named = std::ranges::find(table.axes, column.target, &SourceAxis::name);
    if (!column.target.empty() && named != table.axes.end())
        return static_cast<std::size_t>(named - table.axes.begin());
    const bool isNamed = !column.target.empty() && !table.axes.front().name.empty();
    const bool isOnlyTarget = std::ranges::all_of(table.columns,
        [&](const CompensationColumn& other) { return other.target == column.target; });
    const bool isPair =
        table.columns.size() == 2 && table.columns[0].direction != table.columns[1].direction;
    if (isNamed || !isOnlyTarget || (table.columns.size() > 1 && !isPair))
        return std::nullopt;
    return 0;
}

std::vector<NeutralTable> separateColumns(std::span<const NeutralTable> tables)
{
    std::vector<NeutralTable> separate;
    for (const NeutralTable& table : tables) {
        NeutralTable single = table;
        for (std::size_t n = 0; n < table.columns.size(); ++n) {
            const CompensationColumn& column = table.columns[n];
            const bool isOtherDirection = n > 0 && column.direction != Direction::Both
                && table.columns[n - 1].direction != Direction::Both
                && table.columns[n - 1].direction != column.direction
                && table.columns[n - 1].target == column.target;
            if (isOtherDirection) {
                separate.back().columns.push_back(column);
                continue;
            }
            single.columns = {column};
            separate.push_back(single);
        }
    }
    return separate;
}

Text axisText(const NeutralTable& table, std::size_t axis)
{
    const std::string& name = table.axes[axis].name;
    if (name.empty())
        return AXISCOMP_TEXT("Error", "source {number}").with("number", axis + 1);
    return Verbatim{name};
}

std::vector<Text> axisTexts(const NeutralTable& table)
{
    std::vector<Text> texts;
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        texts.push_back(axisText(table, n));
    return texts;
}

Text columnText(const NeutralTable& table, const CompensationColumn& column)
{
    Text text = AXISCOMP_TEXT("Error", "{axes}").with("axes", axisTexts(table));
    if (!column.target.empty())
        text = AXISCOMP_TEXT("Error", "{axes} to {target}")
                   .with("axes", axisTexts(table))
                   .with("target", column.target);
    if (column.direction == Direction::Both)
        return text;
    return (column.direction == Direction::Positive ? AXISCOMP_TEXT("Error", "{column}, positive")
                                                    : AXISCOMP_TEXT("Error", "{column}, negative"))
        .with("column", std::move(text));
}

} // namespace axiscomp
