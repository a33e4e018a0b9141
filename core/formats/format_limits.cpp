// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_writer.h"
#include "core/neutral/table_motion.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>

namespace axiscomp {

namespace {

class Holding {
public:
    explicit Holding(const FormatFacts& facts) : m_facts(facts) { }

    [[nodiscard]] Result<void> check(const NeutralTable& table) const;
    [[nodiscard]] auto refuse(Text reason, Text wayOut) const
    {
        return cannotHold(m_facts, std::move(reason), std::move(wayOut));
    }

private:
    [[nodiscard]] Result<void> checkKnotRule(const NeutralTable& table) const;
    [[nodiscard]] Result<void> checkColumns(const NeutralTable& table) const;

    const FormatFacts& m_facts;
};

Result<void> Holding::checkKnotRule(const NeutralTable& table) const
{
    if (m_facts.knots == KnotRule::Any)
        return {};
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        if (!isEven(table.axes[n]))
            return refuse(
                AXISCOMP_TEXT("Error", "the positions of source {number} are not evenly spaced")
                    .with("number", n + 1),
                AXISCOMP_TEXT("Error", "resample it onto an even grid"));
    if (m_facts.knots != KnotRule::SquareCells)
        return {};
    const auto distance = [](const SourceAxis& axis) {
        return (axis.knots.back() - axis.knots.front())
            / static_cast<double>(axis.knots.size() - 1);
    };
    const double first = distance(table.axes.front());
    for (const SourceAxis& axis : table.axes)
        if (std::abs(distance(axis) - first) > 1e-9 * first)
            return refuse(AXISCOMP_TEXT("Error",
                              "it takes one distance for all sources, and these are different"),
                AXISCOMP_TEXT("Error", "resample it with the same distance for each source"));
    return {};
}

Result<void> Holding::checkColumns(const NeutralTable& table) const
{
    const bool hasDirections = std::ranges::any_of(table.columns,
        [](const CompensationColumn& column) { return column.direction != Direction::Both; });
    if (hasDirections && !m_facts.holdsDirections)
        return refuse(AXISCOMP_TEXT("Error", "it has one value for both directions of motion"),
            AXISCOMP_TEXT("Error", "choose the mean, the positive or the negative direction"));
    std::set<std::string> targets;
    for (const CompensationColumn& column : table.columns)
        targets.insert(column.target);
    const std::size_t pairs = hasDirections ? targets.size() : table.columns.size();
    if (m_facts.mostColumns > 0 && pairs > m_facts.mostColumns)
        return refuse(
            AXISCOMP_TEXT("Error", "{count} columns are more than the {limit} of one table")
                .with("count", pairs)
                .with("limit", m_facts.mostColumns),
            AXISCOMP_TEXT("Error", "choose a column, and write the others to files of their own"));
    return {};
}

Result<void> Holding::check(const NeutralTable& table) const
{
    const auto dimensions = static_cast<int>(table.axes.size());
    if (dimensions < m_facts.fewestDimensions || dimensions > m_facts.mostDimensions) {
        const Argument range = m_facts.fewestDimensions == m_facts.mostDimensions
            ? Argument(m_facts.mostDimensions)
            : Argument(AXISCOMP_TEXT("Error", "{number} to {number2}")
                           .with("number", m_facts.fewestDimensions)
                           .with("number2", m_facts.mostDimensions));
        return refuse(AXISCOMP_COUNTED("Error", "it has {count} source axes, possible are {range}",
                          "it has 1 source axis, possible are {range}")
                          .with("count", dimensions)
                          .with("range", range),
            AXISCOMP_TEXT("Error", "choose another format"));
    }
    if (m_facts.mostPoints > 0 && table.pointCount() > m_facts.mostPoints)
        return refuse(AXISCOMP_TEXT("Error",
                          "{count} points are more than the {limit} that the controller takes")
                          .with("count", table.pointCount())
                          .with("limit", m_facts.mostPoints),
            AXISCOMP_TEXT("Error", "resample it onto a coarser grid"));
    const bool wraps = std::ranges::any_of(
        table.axes, [](const SourceAxis& axis) { return axis.wrap.has_value(); });
    if (wraps && !m_facts.holdsWrap)
        return refuse(AXISCOMP_TEXT("Error", "it has no modulo axes"),
            AXISCOMP_TEXT("Error",
                "treat the axis as linear (--no-wrap, in a machine file no-wrap = true) when it "
                "stays within one revolution"));
    if (auto fits = checkKnotRule(table); !fits)
        return fits;
    return checkColumns(table);
}

/// Nothing: a table has none of this number, or does not state it.
std::optional<Text> namedAxisOf(const NeutralTable& table, AxisOfTable axis)
{
    if (axis.number >= (axis.isTarget ? table.columns.size() : table.axes.size()))
        return std::nullopt;
    return axis.isTarget ? targetText(table, table.columns[axis.number])
                         : axisText(table, axis.number);
}

/// Each axis once that the tables have in this place.
std::vector<Text> namedAxesOf(std::span<const NeutralTable> tables, AxisOfTable place)
{
    std::vector<Text> axes;
    for (const NeutralTable& table : tables) {
        const auto axis = namedAxisOf(table, place);
        const auto isSame = [&axis](const Text& known) {
            return sameLetters(known.english(), axis->english());
        };
        if (axis && std::ranges::none_of(axes, isSame))
            axes.push_back(*axis);
    }
    return axes;
}

} // namespace

Result<void> checkNamedAxes(
    const FormatFacts& facts, std::span<const NeutralTable> tables, const FormatSettings& settings)
{
    for (const FormatSetting& setting : facts.settings) {
        const auto given = settings.find(setting.key);
        if (!setting.namedAxis || given == settings.end())
            continue;
        auto axes = namedAxesOf(tables, *setting.namedAxis);
        if (axes.size() > 1)
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the setting {key} says {value} for tables of different axes, {axes}; "
                        "choose one of the tables (--table), or leave the setting out")
                        .with("key", setting.key)
                        .with("value", given->second)
                        .with("axes", std::move(axes))}});
    }
    return {};
}

Result<void> checkHolds(const FormatFacts& facts, std::span<const NeutralTable> tables)
{
    const Holding holding(facts);
    if (facts.mostTables > 0 && tables.size() > facts.mostTables)
        return holding.refuse(
            AXISCOMP_TEXT("Error", "{count} tables are more than the {limit} of one file")
                .with("count", tables.size())
                .with("limit", facts.mostTables),
            AXISCOMP_TEXT("Error", "choose one, and write the others to files of their own"));
    for (const NeutralTable& table : tables) {
        if (auto fits = holding.check(table); !fits)
            return fits;
        if (auto fine = checkConsistent(table); !fine)
            return fine;
    }
    return {};
}

} // namespace axiscomp
