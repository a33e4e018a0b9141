// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/neutral_table.h"

#include "core/neutral/drive_note.h"
#include "core/table/even_spacing.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

bool sharesDirection(Direction a, Direction b)
{
    return a == b || a == Direction::Both || b == Direction::Both;
}

std::size_t NeutralTable::pointCount() const
{
    std::size_t count = axes.empty() ? 0 : 1;
    for (const SourceAxis& axis : axes)
        count *= axis.knots.size();
    return count;
}

std::vector<std::size_t> knotCounts(const NeutralTable& table)
{
    std::vector<std::size_t> counts;
    for (const SourceAxis& axis : table.axes)
        counts.push_back(axis.knots.size());
    return counts;
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

std::vector<std::string> sourceNames(const NeutralTable& table)
{
    std::vector<std::string> names;
    for (const SourceAxis& axis : table.axes)
        names.push_back(axis.name);
    return names;
}

std::optional<TargetAxis> targetOf(const NeutralTable& table, const CompensationColumn& column)
{
    return targetAxis(column.target, sourceNames(table));
}

std::optional<std::size_t> ownAxis(const NeutralTable& table, const CompensationColumn& column)
{
    const auto target = targetOf(table, column);
    return target ? target->source : std::nullopt;
}

std::string targetName(const NeutralTable& table, const CompensationColumn& column)
{
    const auto target = targetOf(table, column);
    if (!target)
        return {};
    if (target->source)
        return table.axes[*target->source].name;
    return column.target == otherAxis ? std::string() : column.target;
}

namespace {

Error targetNotKnown(const NeutralTable& table, const CompensationColumn& column)
{
    std::vector<Text> choices;
    for (std::size_t n = 0; n < table.axes.size(); ++n) {
        const std::string& name = table.axes[n].name;
        choices.push_back(name.empty() ? AXISCOMP_TEXT("Error", "{statement} (source {number})")
                                             .with("statement", sourceTarget(n))
                                             .with("number", n + 1)
                                       : AXISCOMP_TEXT("Error", "{statement} ({axis})")
                                             .with("statement", sourceTarget(n))
                                             .with("axis", name));
    }
    choices.push_back(AXISCOMP_TEXT("Error", "{statement} (an axis that is no source)")
                          .with("statement", otherAxis));
    const Text name = column.name.empty() ? columnText(table, column) : Text(Verbatim{column.name});
    return {ErrorCode::TargetNotKnown, {{"column", name}, {"sources", std::move(choices)}}, {}};
}

} // namespace

Result<void> checkTargets(const NeutralTable& table)
{
    for (const CompensationColumn& column : table.columns)
        if (!targetOf(table, column))
            return fail(targetNotKnown(table, column));
    return {};
}

Result<NeutralTable> withTargets(
    NeutralTable table, std::span<const std::string> statements, bool areHeaders)
{
    if (statements.empty())
        return table;
    if (statements.size() != 1 && statements.size() != table.columns.size())
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "{count} targets are stated for {columns} columns; state one for all or one "
                    "for each")
                    .with("count", statements.size())
                    .with("columns", table.columns.size())}});
    const std::vector<std::string> names = sourceNames(table);
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        const std::string& statement = statements[statements.size() == 1 ? 0 : n];
        table.columns[n].target = areHeaders ? targetAmong(statement, names) : statement;
        if (targetAxis(table.columns[n].target, names))
            continue;
        Error error = targetNotKnown(table, table.columns[n]);
        if (!statement.empty())
            error.context.set("stated", Verbatim{statement});
        return fail(std::move(error));
    }
    return table;
}

namespace {

bool isOtherDirectionOf(const CompensationColumn& before, const CompensationColumn& column)
{
    return column.direction != Direction::Both && before.direction != Direction::Both
        && before.direction != column.direction && before.target == column.target;
}

/// Behind the column that begins at first, or the pair of directions.
std::size_t endOfColumn(const NeutralTable& table, std::size_t first)
{
    std::size_t end = first + 1;
    while (end < table.columns.size()
        && isOtherDirectionOf(table.columns[end - 1], table.columns[end]))
        ++end;
    return end;
}

bool saysDrive(const std::string& note)
{
    return statedIn(note, driveKey).has_value();
}

/// Which drive was measured a file says once: its comments are the notes of its first table.
void takeDriveNotes(NeutralTable& table, const NeutralTable& first)
{
    if (std::ranges::none_of(table.notes, saysDrive))
        std::ranges::copy_if(first.notes, std::back_inserter(table.notes), saysDrive);
}

} // namespace

std::vector<NeutralTable> separateColumns(std::span<const NeutralTable> tables)
{
    std::vector<NeutralTable> separate;
    for (const NeutralTable& table : tables) {
        NeutralTable single = table;
        takeDriveNotes(single, tables.front());
        for (std::size_t first = 0; first < table.columns.size();) {
            const std::size_t end = endOfColumn(table, first);
            single.columns.assign(table.columns.begin() + static_cast<std::ptrdiff_t>(first),
                table.columns.begin() + static_cast<std::ptrdiff_t>(end));
            separate.push_back(single);
            first = end;
        }
    }
    return separate;
}

std::shared_ptr<const NeutralTable> sourcesBeside(
    std::span<const NeutralTable> tables, std::size_t separate)
{
    for (const NeutralTable& table : tables)
        for (std::size_t first = 0; first < table.columns.size();) {
            const std::size_t end = endOfColumn(table, first);
            if (separate-- > 0) {
                first = end;
                continue;
            }
            NeutralTable beside{table.name, table.axes, {}, table.sign, table.notes};
            for (std::size_t n = 0; n < table.columns.size(); ++n)
                if ((n < first || n >= end) && ownAxis(table, table.columns[n]))
                    beside.columns.push_back(table.columns[n]);
            return beside.columns.empty() ? nullptr
                                          : std::make_shared<const NeutralTable>(std::move(beside));
        }
    return nullptr;
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

std::optional<Text> targetText(const NeutralTable& table, const CompensationColumn& column)
{
    const auto target = targetOf(table, column);
    if (!target)
        return std::nullopt;
    if (target->source)
        return axisText(table, *target->source);
    return column.target == otherAxis ? Text(AXISCOMP_TEXT("Error", "another axis"))
                                      : Text(Verbatim{column.target});
}

Text columnText(const NeutralTable& table, const CompensationColumn& column)
{
    Text text = AXISCOMP_TEXT("Error", "{axes}").with("axes", axisTexts(table));
    if (auto target = targetText(table, column))
        text = AXISCOMP_TEXT("Error", "{axes} to {target}")
                   .with("axes", axisTexts(table))
                   .with("target", *std::move(target));
    if (column.direction == Direction::Both)
        return text;
    return (column.direction == Direction::Positive ? AXISCOMP_TEXT("Error", "{column}, positive")
                                                    : AXISCOMP_TEXT("Error", "{column}, negative"))
        .with("column", std::move(text));
}

} // namespace axiscomp
