// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/lookup_sides.h"

#include "core/formats/formats.h"
#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

bool hasOwnAxis(const NeutralTable& table)
{
    return std::ranges::any_of(table.columns,
        [&](const CompensationColumn& column) { return ownAxis(table, column).has_value(); });
}

/// By how much a column says something else one of its own values further on: the most that the
/// two places of the encoder, before and after the compensation, can make of it. To first order in
/// the slope.
double largestShift(const NeutralTable& table, const CompensationColumn& column, std::size_t axis)
{
    const SourceAxis& along = table.axes[axis];
    const double factor = column.unit.empty() || along.unit.empty()
        ? 1.0
        : unitFactor(column.unit, along.unit).value_or(1.0);
    const TableLines lines(table, axis);
    double largest = 0.0;
    for (std::size_t line = 0; line < lines.count; ++line) {
        for (std::size_t i = 1; i < lines.length; ++i) {
            const std::size_t at = lines.first(line) + i * lines.stride;
            const double before = column.values[at - lines.stride];
            const double value = column.values[at];
            const double slope = (value - before) / (along.knots[i] - along.knots[i - 1]);
            const double size = std::max(std::abs(before), std::abs(value));
            largest = std::max(largest, std::abs(slope) * size * factor);
        }
    }
    return largest;
}

std::optional<Text> assumption(const NeutralTable& table)
{
    double largest = 0.0;
    std::string unit;
    for (const CompensationColumn& column : table.columns) {
        const auto axis = ownAxis(table, column);
        if (!axis)
            continue;
        const double shift = largestShift(table, column, *axis);
        if (shift > largest) {
            largest = shift;
            unit = column.unit;
        }
    }
    if (largest <= 0.0)
        return std::nullopt;
    constexpr int digits = 3;
    return AXISCOMP_TEXT("Error",
        "the drive is taken to look the table up before the compensation, at the position of the "
        "encoder; at the set position (lookup: set) its corrections would differ by up to "
        "{largest}")
        .with("largest", Quantity{significantText(largest, digits), unit});
}

} // namespace

Result<SetSides> setSides(const NeutralTable& table, const ConversionRequest& request)
{
    const bool isOfDrive = isTriamec(*request.from);
    const bool isForDrive = isTriamec(*request.to);
    std::optional<LookupAt> source;
    if (isOfDrive) {
        AXISCOMP_TRY(source, lookupInNotes(table.notes));
    }
    const std::optional<LookupAt> asked = request.lookupAt;
    if (asked && !isOfDrive && !isForDrive)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "where a table is looked up (--lookup-at) is said of a table of the drive, and "
                    "neither {from} nor {to} is one")
                    .with("from", request.from->facts.name)
                    .with("to", request.to->facts.name)}});
    if (asked && isOfDrive && isForDrive && !source)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the file does not say where the drive looks its table up: in a calibration "
                    "file "
                    "add the line // lookup: encoder or // lookup: set")}});
    if (!isForDrive) {
        AXISCOMP_TRY(source, lookupOfTable(table.notes, asked));
        return SetSides{isOfDrive && source == LookupAt::Set, false};
    }
    const std::optional<LookupAt> target = asked ? asked : source;
    if (!isOfDrive || source == target)
        return SetSides{false, !isOfDrive && target == LookupAt::Set};
    return SetSides{source == LookupAt::Set, target == LookupAt::Set};
}

std::optional<LookupAt> lookupOfResult(const NeutralTable& table, const ConversionRequest& request)
{
    if (!isTriamec(*request.to) || !hasOwnAxis(table))
        return std::nullopt;
    if (!request.lookupAt && isTriamec(*request.from))
        return std::nullopt;
    return request.lookupAt.value_or(LookupAt::Encoder);
}

std::optional<Text> lookupRemark(
    const NeutralTable& source, SetSides sides, const ConversionRequest& request)
{
    if (!hasOwnAxis(source))
        return std::nullopt;
    if (sides.target)
        return AXISCOMP_TEXT("Error",
            "the table is made for a drive that looks it up after the compensation, at the set "
            "position (lookup: set)");
    if (sides.source)
        return AXISCOMP_TEXT("Error",
            "the values are converted from those that the drive looks up after the compensation, "
            "at the set position (lookup: set)");
    const bool isSaid = request.lookupAt || isTriamec(*request.from) == isTriamec(*request.to)
        || (isTriamec(*request.from) && lookupInNotes(source.notes).value_or(std::nullopt));
    return isSaid ? std::nullopt : assumption(source);
}

NeutralTable withTurnedSigns(NeutralTable table, SignConvention sign)
{
    for (CompensationColumn& column : table.columns)
        for (double& value : column.values)
            value = 0.0 - value; // no negative zero
    table.sign = sign;
    return table;
}

} // namespace axiscomp
