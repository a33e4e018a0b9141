// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/table_motion.h"

#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

auto invalid(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

bool areFinite(const std::vector<double>& numbers)
{
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

Result<void> checkAxis(const SourceAxis& axis, const Text& name)
{
    const std::vector<double>& knots = axis.knots;
    if (knots.size() < 2)
        return invalid(
            AXISCOMP_TEXT("Error", "{axis} has fewer than two positions").with("axis", name));
    const bool ascends = std::ranges::adjacent_find(knots, std::greater_equal<>()) == knots.end();
    if (!areFinite(knots) || !ascends || !std::isfinite(knots.back() - knots.front()))
        return invalid(AXISCOMP_TEXT("Error", "the positions of {axis} do not increase strictly")
                           .with("axis", name));
    const double span = knots.back() - knots.front();
    constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
    const double allowance = rounding * (std::abs(knots.front()) + std::abs(knots.back()));
    if (axis.wrap && !(std::isfinite(*axis.wrap) && *axis.wrap >= span - allowance))
        return invalid(AXISCOMP_TEXT("Error",
            "the period of {axis}, {period}, is shorter than the range of its positions, {range}")
                           .with("axis", name)
                           .with("period", quantityOf(*axis.wrap, axis.unit))
                           .with("range", quantityOf(span, axis.unit)));
    return {};
}

bool isKnown(std::string_view unit)
{
    return unitFactor(unit, unit).has_value();
}

} // namespace

Result<void> checkConsistent(const NeutralTable& table)
{
    if (table.axes.empty() || table.axes.size() > 3)
        return invalid(AXISCOMP_TEXT("Error", "a table has 1 to 3 source axes, this has {count}")
                           .with("count", table.axes.size()));
    if (table.columns.empty())
        return invalid(AXISCOMP_TEXT("Error", "the table has no values"));
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        if (auto fine = checkAxis(table.axes[n], axisText(table, n)); !fine)
            return fine;
    for (const CompensationColumn& column : table.columns) {
        if (column.values.size() != table.pointCount())
            return invalid(
                AXISCOMP_TEXT("Error", "{number} values for {column}, for {points} points")
                    .with("number", column.values.size())
                    .with("column", columnText(table, column))
                    .with("points", table.pointCount()));
        if (!areFinite(column.values))
            return invalid(AXISCOMP_TEXT("Error", "a value for {column} is not a finite number")
                               .with("column", columnText(table, column)));
    }
    return {};
}

Result<double> factorBetween(std::string_view from, std::string_view to, Text what)
{
    if (isSameUnit(from, to))
        return 1.0;
    if (const auto factor = unitFactor(from, to))
        return *factor;
    if (!isKnown(from) || !isKnown(to))
        return 1.0;
    return invalid(AXISCOMP_TEXT(
        "Error", "the {what} are in {from}, which cannot be given in {to}; correct the units")
                       .with("what", std::move(what))
                       .with("from", from)
                       .with("to", to));
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

Quantity quantityOf(double number, const std::string& unit)
{
    return {roundedText(number), unit};
}

Argument positionText(const NeutralTable& table, std::span<const double> position)
{
    if (table.axes.size() == 1)
        return quantityOf(position[0], table.axes[0].unit);
    std::vector<Text> texts;
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        texts.push_back(AXISCOMP_TEXT("Error", "{axis} = {position}")
                            .with("axis", axisText(table, n))
                            .with("position", quantityOf(position[n], table.axes[n].unit)));
    return texts;
}

std::size_t strideOf(const NeutralTable& table, std::size_t axis)
{
    std::size_t stride = 1;
    for (std::size_t n = 0; n < axis; ++n)
        stride *= table.axes[n].knots.size();
    return stride;
}

TableLines::TableLines(const NeutralTable& table, std::size_t axis)
    : stride(strideOf(table, axis))
    , length(table.axes[axis].knots.size())
    , count(table.pointCount() / length)
{
}

std::size_t TableLines::perPart() const
{
    constexpr std::size_t enough = 32'768; // points
    return std::max<std::size_t>(1, enough / length);
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
                && sharesDirection(table.columns[a].direction, table.columns[b].direction))
                return invalid(AXISCOMP_TEXT("Error",
                    "columns {first} and {second} both correct {axis} in the same direction; keep "
                    "one of them")
                                   .with("first", a + 1)
                                   .with("second", b + 1)
                                   .with("axis", axisText(table, *ownAxes[a])));
    std::vector<Mover> movers;
    for (std::size_t axis = 0; axis < table.axes.size(); ++axis) {
        Mover mover{axis, {}};
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const CompensationColumn& column = table.columns[i];
            if (ownAxes[i] != axis || !sharesDirection(column.direction, direction))
                continue;
            AXISCOMP_TRY(const auto factor,
                factorBetween(column.unit, table.axes[axis].unit,
                    AXISCOMP_TEXT("Error", "values for {column}")
                        .with("column", columnText(table, column))));
            mover.parts.push_back({i, factor});
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

Motion::Line Motion::along(std::size_t axis, std::span<const double> position) const
{
    Line line;
    for (const Part& part : m_parts)
        if (part.axis == axis)
            line.m_parts.emplace_back(part.column.along(axis, position), part.factor);
    return line;
}

} // namespace axiscomp
