// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/adjustment.h"

#include "core/formats/units.h"
#include "core/neutral/controller_lookup.h"
#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace axiscomp {

namespace {

tl::unexpected<Error> refuse(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

/// In the turn of a modulo axis that begins with its first knot.
double inTurn(const SourceAxis& axis, double position)
{
    if (!axis.wrap)
        return position;
    const double turns = std::floor((position - axis.knots.front()) / *axis.wrap);
    return position - turns * *axis.wrap;
}

/// position: as inTurn says. The last knot of a grid may be rounded.
bool isWithin(const SourceAxis& axis, double position)
{
    const double rounding = 1e-9 * (axis.knots.back() - axis.knots.front());
    return axis.knots.front() - rounding <= position && position <= axis.knots.back() + rounding;
}

/// The values at a position. Of the two directions of a table the mean counts, so that the reversal
/// stays.
double valueAt(const NeutralTable& table, std::size_t column, std::span<const double> position)
{
    const CompensationColumn& own = table.columns[column];
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        const CompensationColumn& other = table.columns[n];
        const bool isPair = own.direction != Direction::Both && other.direction != Direction::Both
            && other.target == own.target;
        if (n != column && !isPair)
            continue;
        sum += unitFactor(other.unit, own.unit).value_or(1.0)
            * ControllerLookup(table, n, {.outside = Outside::Hold}).at(position);
        ++count;
    }
    return sum / count;
}

/// Columns that correct the same axis in the same direction are told apart by their names.
Text namedColumn(const NeutralTable& table, const CompensationColumn& column)
{
    const auto alike =
        std::ranges::count_if(table.columns, [&column](const CompensationColumn& other) {
            return other.target == column.target && other.direction == column.direction;
        });
    return alike > 1 && !column.name.empty() ? Text(Verbatim{column.name})
                                             : columnText(table, column);
}

} // namespace

Result<NeutralTable> adjusted(
    NeutralTable table, const Adjustment& adjustment, std::vector<Text>& remarks)
{
    if (!std::isfinite(adjustment.scale) || adjustment.scale == 0.0
        || !std::isfinite(adjustment.offset))
        return refuse(AXISCOMP_TEXT("Error",
            "the values are multiplied by a number that is not 0, and shifted by a number"));
    if (!adjustment.zero.empty() && adjustment.offset != 0.0)
        return refuse(AXISCOMP_TEXT(
            "Error", "an offset and a position at which the values are 0 contradict each other"));
    if (adjustment.scale != 1.0) {
        remarkOnce(remarks,
            AXISCOMP_TEXT("Error", "the values are multiplied by {factor}")
                .with("factor", Quantity{toText(adjustment.scale)}));
        for (CompensationColumn& column : table.columns)
            for (double& value : column.values)
                value *= adjustment.scale;
    }
    shiftColumns(table, std::vector<double>(table.columns.size(), adjustment.offset), remarks);
    return table;
}

Result<std::vector<double>> zeroWithin(const NeutralTable& table, const Adjustment& adjustment)
{
    std::vector<double> zero = adjustment.zero;
    if (zero.empty())
        return zero;
    if (zero.size() != table.axes.size())
        return refuse(AXISCOMP_TEXT("Error",
            "the position at which the values are 0 needs a number for each of the {count} source "
            "axes")
                          .with("count", table.axes.size()));
    for (std::size_t n = 0; n < zero.size(); ++n) {
        const SourceAxis& axis = table.axes[n];
        zero[n] = inTurn(axis, zero[n]);
        if (isWithin(axis, zero[n]))
            continue;
        return refuse(AXISCOMP_TEXT("Error",
            "{position} of source {number}, where the values shall be 0, is outside of the table, "
            "which goes from {first} to {last}")
                          .with("position", Quantity{toText(adjustment.zero[n]), axis.unit})
                          .with("number", n + 1)
                          .with("first", Quantity{roundedText(axis.knots.front()), axis.unit})
                          .with("last", Quantity{roundedText(axis.knots.back()), axis.unit}));
    }
    return zero;
}

std::optional<std::vector<double>> shiftsToZero(
    const NeutralTable& table, std::span<const double> position)
{
    for (std::size_t n = 0; n < position.size(); ++n)
        if (!isWithin(table.axes[n], inTurn(table.axes[n], position[n])))
            return std::nullopt;
    std::vector<double> shifts;
    for (std::size_t n = 0; n < table.columns.size(); ++n)
        shifts.push_back(0.0 - valueAt(table, n, position)); // no negative zero
    return shifts;
}

void shiftColumns(NeutralTable& table, std::span<const double> shifts, std::vector<Text>& remarks)
{
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        const double shift = shifts[n];
        if (shift == 0.0)
            continue;
        CompensationColumn& column = table.columns[n];
        for (double& value : column.values)
            value += shift;
        remarkOnce(remarks,
            AXISCOMP_TEXT("Error", "the values of {column} are shifted by {shift}")
                .with("column", namedColumn(table, column))
                .with("shift", quantityOf(shift, column.unit)));
    }
}

} // namespace axiscomp
