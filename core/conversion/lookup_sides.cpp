// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/lookup_sides.h"

#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/neutral/sign_note.h"
#include "core/neutral/table_motion.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

/// Whether a column corrects a source, or nobody has said that it does not.
bool mayMoveSource(const NeutralTable& table)
{
    return std::ranges::any_of(table.columns, [&](const CompensationColumn& column) {
        return !targetOf(table, column) || ownAxis(table, column);
    });
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
        const auto own = ownAxis(table, column);
        for (std::size_t axis = 0; axis < table.axes.size(); ++axis) {
            const bool isMoved = own ? axis == *own : !targetOf(table, column);
            const double shift = isMoved ? largestShift(table, column, axis) : 0.0;
            if (shift > largest) {
                largest = shift;
                unit = column.unit;
            }
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

bool isOfDrive(const TableFormat& format, std::optional<SignConvention> stated)
{
    return isTriamec(format) && stated != SignConvention::Command;
}

Result<SetSides> setSides(const NeutralTable& table, const ConversionRequest& request)
{
    const bool isFromDrive = isOfDrive(*request.from, request.sourceSign);
    const bool isForDrive = isOfDrive(*request.to, request.targetSign);
    const std::optional<LookupAt> asked = request.lookupAt;
    if (asked && !isFromDrive && !isForDrive)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "where a table is looked up (--lookup-at) is said of a table of the drive, and "
                    "neither {from} nor {to} is one")
                    .with("from", request.from->facts.name)
                    .with("to", request.to->facts.name)}});
    SetSides sides;
    sides.target = isForDrive && asked == LookupAt::Set;
    if (!isFromDrive)
        return sides;
    if (!isForDrive) {
        AXISCOMP_TRY(const auto source, lookupOfTable(table.notes, asked));
        sides.source = source == LookupAt::Set;
        return sides;
    }
    AXISCOMP_TRY(auto source, lookupInNotes(table.notes));
    if (!source && request.from == &tam_table::format())
        source = asked; // which has no room for it
    if (asked && !source)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the file does not say where the drive looks its table up: in a calibration "
                    "file "
                    "add the line // lookup: encoder or // lookup: set")}});
    sides.source = source == LookupAt::Set;
    sides.target = asked ? sides.target : sides.source;
    return sides;
}

std::optional<LookupAt> lookupOfResult(const NeutralTable& table, const ConversionRequest& request)
{
    if (!isOfDrive(*request.to, request.targetSign))
        return std::nullopt;
    if (isOfDrive(*request.from, request.sourceSign))
        return request.lookupAt;
    if (!mayMoveSource(table))
        return std::nullopt;
    return request.lookupAt.value_or(LookupAt::Encoder);
}

std::vector<std::string> notesOfResult(const NeutralTable& table, const ConversionRequest& request)
{
    const auto lookupAt = lookupOfResult(table, request);
    const bool isKept =
        isOfDrive(*request.from, request.sourceSign) && isOfDrive(*request.to, request.targetSign);
    std::vector<std::string> notes =
        lookupAt || !isKept ? withLookupNote(table.notes, lookupAt) : table.notes;
    // Of other files the sign is known by their format.
    if (!isTriamec(*request.to))
        return withSignNote(std::move(notes), SignConvention::Feedback);
    if (!isTriamec(*request.from))
        notes = withoutStatements(std::move(notes));
    return withSignNote(std::move(notes), request.targetSign.value_or(request.to->facts.sign));
}

std::optional<Text> lookupRemark(
    const NeutralTable& source, SetSides sides, const ConversionRequest& request)
{
    if (!mayMoveSource(source))
        return std::nullopt;
    if (sides.isTargetConverted())
        return AXISCOMP_TEXT("Error",
            "the table is made for a drive that looks it up after the compensation, at the set "
            "position (lookup: set)");
    if (sides.isSourceConverted())
        return AXISCOMP_TEXT("Error",
            "the values are converted from those that the drive looks up after the compensation, "
            "at the set position (lookup: set)");
    const bool isFromDrive = isOfDrive(*request.from, request.sourceSign);
    const bool isSaid = request.lookupAt
        || isFromDrive == isOfDrive(*request.to, request.targetSign)
        || (isFromDrive && lookupInNotes(source.notes).value_or(std::nullopt));
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
