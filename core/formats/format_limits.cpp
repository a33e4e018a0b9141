// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_writer.h"
#include "core/neutral/table_motion.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace axiscomp {

namespace {

class Holding {
public:
    explicit Holding(const FormatFacts& facts) : m_facts(facts) { }

    [[nodiscard]] Result<void> check(const NeutralTable& table) const;
    [[nodiscard]] auto refuse(std::string reason, std::string wayOut) const
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
                "the positions of source " + std::to_string(n + 1) + " are not evenly spaced",
                "resample it onto an even grid");
    if (m_facts.knots != KnotRule::SquareCells)
        return {};
    const auto distance = [](const SourceAxis& axis) {
        return (axis.knots.back() - axis.knots.front())
            / static_cast<double>(axis.knots.size() - 1);
    };
    const double first = distance(table.axes.front());
    for (const SourceAxis& axis : table.axes)
        if (std::abs(distance(axis) - first) > 1e-9 * first)
            return refuse("it takes one distance for all sources, and these are different",
                "resample it with the same distance for each source");
    return {};
}

Result<void> Holding::checkColumns(const NeutralTable& table) const
{
    const bool hasDirections = std::ranges::any_of(table.columns,
        [](const CompensationColumn& column) { return column.direction != Direction::Both; });
    if (hasDirections && !m_facts.holdsDirections)
        return refuse("it has one value for both directions of motion",
            "choose the mean, the positive or the negative direction");
    std::set<std::string> targets;
    for (const CompensationColumn& column : table.columns)
        targets.insert(column.target);
    const std::size_t pairs = hasDirections ? targets.size() : table.columns.size();
    if (m_facts.mostColumns > 0 && pairs > m_facts.mostColumns)
        return refuse(std::to_string(pairs) + " columns are more than the "
                + std::to_string(m_facts.mostColumns) + " of one table",
            "choose a column, and write the others to files of their own");
    return {};
}

Result<void> Holding::check(const NeutralTable& table) const
{
    const auto dimensions = static_cast<int>(table.axes.size());
    if (dimensions < m_facts.fewestDimensions || dimensions > m_facts.mostDimensions) {
        const std::string range = m_facts.fewestDimensions == m_facts.mostDimensions
            ? std::to_string(m_facts.mostDimensions)
            : std::to_string(m_facts.fewestDimensions) + " to "
                + std::to_string(m_facts.mostDimensions);
        return refuse("it has " + std::to_string(dimensions)
                + (dimensions == 1 ? " source axis" : " source axes") + ", possible are " + range,
            "choose another format");
    }
    if (m_facts.mostPoints > 0 && table.pointCount() > m_facts.mostPoints)
        return refuse(std::to_string(table.pointCount()) + " points are more than the "
                + std::to_string(m_facts.mostPoints) + " that the controller takes",
            "resample it onto a coarser grid");
    const bool wraps = std::ranges::any_of(
        table.axes, [](const SourceAxis& axis) { return axis.wrap.has_value(); });
    if (wraps && !m_facts.holdsWrap)
        return refuse("it has no modulo axes",
            "leave the modulo out when the axis stays within one revolution");
    if (auto fits = checkKnotRule(table); !fits)
        return fits;
    return checkColumns(table);
}

} // namespace

Result<void> checkHolds(const FormatFacts& facts, std::span<const NeutralTable> tables)
{
    const Holding holding(facts);
    if (facts.mostTables > 0 && tables.size() > facts.mostTables)
        return holding.refuse(std::to_string(tables.size()) + " tables are more than the "
                + std::to_string(facts.mostTables) + " of one file",
            "choose one, and write the others to files of their own");
    for (const NeutralTable& table : tables) {
        if (auto fits = holding.check(table); !fits)
            return fits;
        if (auto fine = checkConsistent(table); !fine)
            return fine;
    }
    return {};
}

} // namespace axiscomp
