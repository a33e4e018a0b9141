// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/directions.h"
#include "core/conversion/resampling/resampling_errors.h"

#include "core/neutral/table_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace axiscomp {

namespace {

Argument targetText(const CompensationColumn& column)
{
    if (column.target.empty())
        return AXISCOMP_TEXT("Error", "the target without a name");
    return column.target;
}

/// The columns of one target.
struct Group {
    const CompensationColumn* first = nullptr;
    const CompensationColumn* both = nullptr;
    const CompensationColumn* positive = nullptr;
    const CompensationColumn* negative = nullptr;
};

const CompensationColumn*& memberOf(Group& group, Direction direction)
{
    switch (direction) {
    case Direction::Positive:
        return group.positive;
    case Direction::Negative:
        return group.negative;
    case Direction::Both:
        break;
    }
    return group.both;
}

Result<std::vector<Group>> groupsOf(const NeutralTable& table)
{
    std::vector<Group> groups;
    for (const CompensationColumn& column : table.columns) {
        // columns for both directions need no counterpart, and formats without names have several
        Group* group = nullptr;
        for (Group& other : groups)
            if (other.first->target == column.target
                && !(other.both && column.direction == Direction::Both))
                group = &other;
        if (!group) {
            groups.emplace_back();
            group = &groups.back();
            group->first = &column;
        }
        const CompensationColumn*& member = memberOf(*group, column.direction);
        if (member)
            return invalidArgument((column.direction == Direction::Positive
                    ? AXISCOMP_TEXT("Error",
                        "there are two columns for {target} in positive direction; keep one of "
                        "them")
                    : AXISCOMP_TEXT("Error",
                        "there are two columns for {target} in negative direction; keep one of "
                        "them"))
                                       .with("target", targetText(column)));
        member = &column;
        if (group->both && (group->positive || group->negative))
            return invalidArgument(AXISCOMP_TEXT("Error",
                "for {target} there are values for both directions and others for one; keep one of "
                "them")
                                       .with("target", targetText(column)));
    }
    return groups;
}

class Merger {
public:
    Merger(const NeutralTable& table, DirectionChoice choice) : m_table(table), m_choice(choice)
    {
        m_result.table = table;
        m_result.table.columns.clear();
        m_result.columns.resize(table.columns.size());
    }

    [[nodiscard]] Result<MergedDirections> run()
    {
        AXISCOMP_TRY(const auto groups, groupsOf(m_table));
        for (const Group& group : groups)
            AXISCOMP_CHECK(merge(group));
        return std::move(m_result);
    }

private:
    [[nodiscard]] Result<void> merge(const Group& group);
    [[nodiscard]] Result<void> mergePair(const Group& group);
    [[nodiscard]] Result<void> takeSingle(const Group& group);
    [[nodiscard]] TextPattern missing(bool hasPositive) const;
    /// The points whose merged values were made up, at least in part.
    [[nodiscard]] std::vector<std::uint32_t> filledOf(
        const CompensationColumn& positive, const CompensationColumn& negative) const;

    const NeutralTable& m_table;
    DirectionChoice m_choice;
    MergedDirections m_result;
};

Result<void> Merger::merge(const Group& group)
{
    for (const CompensationColumn* column : {group.both, group.positive, group.negative})
        if (column)
            m_result.columns[static_cast<std::size_t>(column - m_table.columns.data())] =
                m_result.table.columns.size();
    if (group.both) {
        m_result.table.columns.push_back(*group.both);
        return {};
    }
    return group.positive && group.negative ? mergePair(group) : takeSingle(group);
}

/// Why a column in one direction does not do.
TextPattern Merger::missing(bool hasPositive) const
{
    if (m_choice == DirectionChoice::Mean)
        return hasPositive ? AXISCOMP_TEXT("Error",
                   "{target} has values for the positive direction only, so that there is no mean; "
                   "choose the positive direction")
                           : AXISCOMP_TEXT("Error",
                               "{target} has values for the negative direction only, so that "
                               "there is no mean; choose the negative direction");
    return hasPositive ? AXISCOMP_TEXT("Error",
               "{target} has values for the positive direction only, so that there is no negative "
               "one; choose the positive direction")
                       : AXISCOMP_TEXT("Error",
                           "{target} has values for the negative direction only, so that there is "
                           "no positive one; choose the negative direction");
}

Result<void> Merger::takeSingle(const Group& group)
{
    const bool isChosen = (m_choice == DirectionChoice::Positive && group.positive)
        || (m_choice == DirectionChoice::Negative && group.negative);
    if (!isChosen)
        return invalidArgument(
            missing(group.positive != nullptr).with("target", targetText(*group.first)));
    CompensationColumn column = *group.first;
    column.direction = Direction::Both;
    m_result.table.columns.push_back(std::move(column));
    return {};
}

std::vector<std::uint32_t> Merger::filledOf(
    const CompensationColumn& positive, const CompensationColumn& negative) const
{
    if (m_choice != DirectionChoice::Mean)
        return m_choice == DirectionChoice::Positive ? positive.filled : negative.filled;
    std::vector<std::uint32_t> filled;
    std::ranges::set_union(positive.filled, negative.filled, std::back_inserter(filled));
    return filled;
}

Result<void> Merger::mergePair(const Group& group)
{
    const Text what =
        AXISCOMP_TEXT("Error", "values for {column}").with("column", targetText(*group.first));
    const auto positiveFactor = factorBetween(group.positive->unit, group.first->unit, what);
    const auto negativeFactor = factorBetween(group.negative->unit, group.first->unit, what);
    if (!positiveFactor || !negativeFactor)
        return fail(positiveFactor ? negativeFactor.error() : positiveFactor.error());
    CompensationColumn column = *group.first;
    column.direction = Direction::Both;
    DirectionLoss loss{m_result.table.columns.size(), 0.0, {}};
    for (std::size_t i = 0; i < column.values.size(); ++i) {
        const double positive = *positiveFactor * group.positive->values[i];
        const double negative = *negativeFactor * group.negative->values[i];
        if (m_choice == DirectionChoice::Mean)
            column.values[i] = positive / 2.0 + negative / 2.0; // no overflow
        else
            column.values[i] = m_choice == DirectionChoice::Positive ? positive : negative;
        const double half = std::abs(positive / 2.0 - negative / 2.0);
        if (half > loss.largestHalfDifference) {
            const Position position = knotPosition(m_table, i);
            loss.largestHalfDifference = half;
            loss.position.assign(position.begin(),
                position.begin() + static_cast<std::ptrdiff_t>(m_table.axes.size()));
        }
    }
    column.filled = filledOf(*group.positive, *group.negative);
    m_result.losses.push_back(std::move(loss));
    m_result.table.columns.push_back(std::move(column));
    return {};
}

} // namespace

TextPattern choiceText(DirectionChoice choice)
{
    switch (choice) {
    case DirectionChoice::Positive:
        return AXISCOMP_TEXT("Error", "positive");
    case DirectionChoice::Negative:
        return AXISCOMP_TEXT("Error", "negative");
    case DirectionChoice::Mean:
        break;
    }
    return AXISCOMP_TEXT("Error", "mean");
}

Result<MergedDirections> mergeDirections(const NeutralTable& table, DirectionChoice choice)
{
    AXISCOMP_CHECK(checkConsistent(table));
    return Merger(table, choice).run();
}

} // namespace axiscomp
