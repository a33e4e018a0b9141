// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/table_motion.h"

#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

auto invalid(std::string reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

bool areFinite(const std::vector<double>& numbers)
{
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

Result<void> checkAxis(const SourceAxis& axis, const std::string& name)
{
    const std::vector<double>& knots = axis.knots;
    if (knots.size() < 2)
        return invalid(name + " has fewer than two positions");
    const bool ascends = std::ranges::adjacent_find(knots, std::greater_equal<>()) == knots.end();
    if (!areFinite(knots) || !ascends || !std::isfinite(knots.back() - knots.front()))
        return invalid("the positions of " + name + " do not increase strictly");
    const double span = knots.back() - knots.front();
    constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
    const double allowance = rounding * (std::abs(knots.front()) + std::abs(knots.back()));
    if (axis.wrap && !(std::isfinite(*axis.wrap) && *axis.wrap >= span - allowance))
        return invalid("the period of " + name + ", " + quantityText(*axis.wrap, axis.unit)
            + ", is shorter than the range of its positions, " + quantityText(span, axis.unit));
    return {};
}

bool isKnown(std::string_view unit)
{
    return unitFactor(unit, unit).has_value();
}

bool overlap(Direction a, Direction b)
{
    return a == b || a == Direction::Both || b == Direction::Both;
}

} // namespace

Result<void> checkConsistent(const NeutralTable& table)
{
    if (table.axes.empty() || table.axes.size() > 3)
        return invalid(
            "a table has 1 to 3 source axes, this has " + std::to_string(table.axes.size()));
    if (table.columns.empty())
        return invalid("the table has no values");
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        if (auto fine = checkAxis(table.axes[n], axisText(table, n)); !fine)
            return fine;
    for (const CompensationColumn& column : table.columns) {
        if (column.values.size() != table.pointCount())
            return invalid(std::to_string(column.values.size()) + " values for "
                + columnText(table, column) + ", for " + std::to_string(table.pointCount())
                + " points");
        if (!areFinite(column.values))
            return invalid("a value for " + columnText(table, column) + " is not a finite number");
    }
    return {};
}

Result<double> factorBetween(std::string_view from, std::string_view to, std::string_view what)
{
    if (isSameUnit(from, to))
        return 1.0;
    if (const auto factor = unitFactor(from, to))
        return *factor;
    if (!isKnown(from) || !isKnown(to))
        return 1.0;
    return invalid("the " + std::string(what) + " are in " + std::string(from)
        + ", which cannot be given in " + std::string(to) + "; correct the units");
}

Position knotPosition(const NeutralTable& table, std::size_t index)
{
    Position position{};
    for (std::size_t n = 0; n < table.axes.size(); ++n) {
        const std::vector<double>& knots = table.axes[n].knots;
        position[n] = knots[index % knots.size()];
        index /= knots.size();
    }
    return position;
}

std::string quantityText(double number, const std::string& unit)
{
    return roundedText(number) + (unit.empty() ? "" : " " + unit);
}

std::string axisText(const NeutralTable& table, std::size_t axis)
{
    const std::string& name = table.axes[axis].name;
    return name.empty() ? "source " + std::to_string(axis + 1) : name;
}

std::string positionText(const NeutralTable& table, std::span<const double> position)
{
    if (table.axes.size() == 1)
        return quantityText(position[0], table.axes[0].unit);
    std::string text;
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        text += (n == 0 ? "" : ", ") + axisText(table, n) + " = "
            + quantityText(position[n], table.axes[n].unit);
    return text;
}

std::size_t strideOf(const NeutralTable& table, std::size_t axis)
{
    std::size_t stride = 1;
    for (std::size_t n = 0; n < axis; ++n)
        stride *= table.axes[n].knots.size();
    return stride;
}

bool isFullTurn(const SourceAxis& axis)
{
    if (!axis.wrap)
        return false;
    const double first = axis.knots.front();
    const double last = axis.knots.back();
    const double rounding =
        16.0 * std::numeric_limits<double>::epsilon() * (std::abs(first) + std::abs(last));
    return last - first >= *axis.wrap - rounding;
}

OwnAxes ownAxesOf(const NeutralTable& table)
{
    OwnAxes axes;
    for (const CompensationColumn& column : table.columns)
        axes.push_back(ownAxis(table, column));
    return axes;
}

Result<std::vector<Mover>> moversOf(
    const NeutralTable& table, const OwnAxes& ownAxes, Direction direction)
{
    for (std::size_t b = 0; b < table.columns.size(); ++b)
        for (std::size_t a = 0; a < b; ++a)
            if (ownAxes[a] && ownAxes[a] == ownAxes[b]
                && overlap(table.columns[a].direction, table.columns[b].direction))
                return invalid("columns " + std::to_string(a + 1) + " and " + std::to_string(b + 1)
                    + " both correct " + axisText(table, *ownAxes[a])
                    + " in the same direction; keep one of them");
    std::vector<Mover> movers;
    for (std::size_t axis = 0; axis < table.axes.size(); ++axis) {
        Mover mover{axis, {}};
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const CompensationColumn& column = table.columns[i];
            if (ownAxes[i] != axis || !overlap(column.direction, direction))
                continue;
            const auto factor = factorBetween(
                column.unit, table.axes[axis].unit, "values for " + columnText(table, column));
            if (!factor)
                return fail(factor.error());
            mover.parts.push_back({i, *factor});
        }
        for (Mover::Part& part : mover.parts)
            part.factor /= static_cast<double>(mover.parts.size());
        if (!mover.parts.empty())
            movers.push_back(std::move(mover));
    }
    return movers;
}

Motion::Motion(
    const NeutralTable& table, const TableBehaviour& behaviour, const std::vector<Mover>& movers)
{
    for (const Mover& mover : movers)
        for (const Mover::Part& part : mover.parts)
            m_parts.push_back(
                {ControllerLookup(table, part.column, behaviour), mover.axis, part.factor});
}

Position Motion::offset(std::span<const double> position) const
{
    Position offset{};
    for (const Part& part : m_parts)
        offset[part.axis] += part.factor * part.column.at(position);
    return offset;
}

} // namespace axiscomp
