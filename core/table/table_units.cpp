// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_units.h"

#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

std::vector<std::string> unitsOfPositions(const Grid& grid)
{
    std::vector<std::string> units;
    for (const GridAxis& axis : grid.axes)
        units.push_back(axis.unit);
    return units;
}

bool haveOneUnit(std::span<const std::string> units)
{
    return std::ranges::all_of(
        units, [&](const std::string& unit) { return isSameUnit(unit, units.front()); });
}

/// From the unit that the table states to that of the drive; 1 where one of them says none.
Result<double> driveFactor(const std::string& from, const std::string& to, const Text& what)
{
    if (from.empty() || to.empty() || isSameUnit(from, to))
        return 1.0;
    if (const auto factor = unitFactor(from, to))
        return *factor;
    return fail(
        ErrorCode::UnitMismatch, {{"what", what}, {"unit", from}, {"other", symbolOrWord(to)}});
}

/// "0.0021 mm"
Quantity largestCorrection(const CompensationTable& table)
{
    float largest = 0.0F;
    for (const float value : table.values)
        largest = std::max(largest, std::fabs(value));
    return {toText(largest), table.unit};
}

void scaleAxis(GridAxis& axis, double factor, const std::string& unit)
{
    // Dividing by a whole number is exact where multiplying by its reciprocal is not.
    const double divisor = factor < 1.0 ? std::round(1.0 / factor) : 1.0;
    const bool isWhole = factor < 1.0 && std::abs(divisor * factor - 1.0) < 1e-12;
    axis.start = isWhole ? axis.start / divisor : axis.start * factor;
    axis.distance = isWhole ? axis.distance / divisor : axis.distance * factor;
    axis.unit = unit;
}

/// What the values are in; empty: the table does not say, or nothing that the drive's unit can be.
Result<std::string> unitOfValues(
    const CompensationTable& table, const std::string& drive, UnstatedUnit unstated)
{
    if (!table.unit.empty() || unstated == UnstatedUnit::OfDrive)
        return table.unit;
    std::vector<std::string> units = unitsForValues(table);
    std::erase_if(units, [&](const std::string& unit) { return !unitFactor(unit, drive); });
    if (units.size() > 1)
        return fail(ErrorCode::UnitMissing, {{"positions", units}});
    return units.empty() ? std::string() : units.front();
}

/// The sentence for values that were in a unit before, which the table has stated or not.
TextPattern valuePattern(const std::string& before, bool isStated, const std::string& drive)
{
    if (unitSymbol(drive).empty())
        return before.empty()
            ? AXISCOMP_TEXT("Error",
                "Neither the table nor the drive states a unit for the values. The largest "
                "correction is {largest}.")
            : AXISCOMP_TEXT("Error",
                "The drive states no unit for the axis; the values are written in "
                "{before}. The largest correction is {largest}.");
    if (isStated)
        return AXISCOMP_TEXT("Error",
            "The values are converted from {before} to {after}. The largest correction is "
            "{largest}.");
    return before.empty() || isSameUnit(before, drive)
        ? AXISCOMP_TEXT("Error",
            "The table states no unit for its values; they are taken to be in {after}. The "
            "largest correction is {largest}.")
        : AXISCOMP_TEXT("Error",
            "The table states no unit for its values; they are taken to be in {before}, as its "
            "positions are, and converted to {after}. The largest correction is {largest}.");
}

/// What a person has to know of the unit of the values, where there is something.
std::optional<Text> valueRemark(const std::string& before, bool isStated, const std::string& drive,
    const CompensationTable& converted)
{
    if (isStated && !unitSymbol(drive).empty() && isSameUnit(before, drive))
        return std::nullopt;
    return valuePattern(before, isStated, drive)
        .with("before", before)
        .with("after", symbolOrWord(drive))
        .with("largest", largestCorrection(converted));
}

/// Whether the table states a unit of something. Where it states none at all, the remark on its
/// values says so once.
bool statesUnits(const CompensationTable& table)
{
    return !table.unit.empty() || std::ranges::any_of(table.grid.axes, [](const GridAxis& axis) {
        return !axis.unit.empty();
    });
}

/// For positions without a unit beside others that have one: it may have been forgotten.
Text positionAssumption(const GridAxis& axis, std::size_t number, const std::string& drive)
{
    const std::string after = symbolOrWord(drive);
    return AXISCOMP_TEXT("Error",
        "The table states no unit for the positions of dimension {number}; they are taken to be in "
        "{after}: {first} to {last}.")
        .with("number", number)
        .with("after", after)
        .with("first", Quantity{roundedText(axis.start), after})
        .with("last", Quantity{roundedText(axis.last()), after});
}

/// Brings the positions of a dimension into the unit of the drive.
Result<std::optional<Text>> convertPositions(
    GridAxis& axis, std::size_t number, const std::string& drive)
{
    const std::string before = axis.unit;
    AXISCOMP_TRY(const double factor,
        driveFactor(before, drive,
            AXISCOMP_TEXT("Error", "positions of dimension {number}").with("number", number)));
    if (factor == 1.0)
        return std::nullopt;
    const std::string after = symbolOrWord(drive);
    scaleAxis(axis, factor, after);
    return AXISCOMP_TEXT("Error",
        "The positions of dimension {number} are converted from {before} to {after}: {first} to "
        "{last}.")
        .with("number", number)
        .with("before", before)
        .with("after", after)
        .with("first", Quantity{roundedText(axis.start), after})
        .with("last", Quantity{roundedText(axis.last()), after});
}

} // namespace

UnstatedUnit unstatedUnit(std::string_view statedForValues)
{
    return statedForValues == unitOfDrive ? UnstatedUnit::OfDrive : UnstatedUnit::OfPositions;
}

std::optional<UnitChange> changedUnit(const TableUnits& before, const TableUnits& now)
{
    const auto change = [](std::optional<std::size_t> dimension, const std::string& was,
                            const std::string& is) -> std::optional<UnitChange> {
        UnitChange found{dimension, symbolOrWord(was), symbolOrWord(is)};
        if (was.empty() || isSameUnit(found.before, found.now))
            return std::nullopt;
        return found;
    };
    if (auto found = change(std::nullopt, before.values, now.values))
        return found;
    for (std::size_t n = 0; n < before.positions.size(); ++n)
        if (auto found = change(n, before.positions[n],
                n < now.positions.size() ? now.positions[n] : std::string()))
            return found;
    return std::nullopt;
}

Text unitNow(const UnitChange& change)
{
    return change.now.empty() ? AXISCOMP_TEXT("Error", "an unknown unit")
                              : Text(Verbatim{change.now});
}

void takeStatedUnit(std::string& unit, const std::string& stated)
{
    if (!stated.empty())
        unit = stated == unitOfDrive ? std::string() : stated;
}

void takeStatedUnits(CompensationTable& table, const StatedUnits& stated)
{
    takeStatedUnit(table.unit, stated.values);
    for (GridAxis& axis : table.grid.axes)
        takeStatedUnit(axis.unit, stated.positions);
}

std::vector<std::string> unitsForValues(
    std::span<const std::string> positions, const std::optional<TargetAxis>& target)
{
    std::vector<std::string> units;
    if (target && target->source) {
        if (const std::string& own = positions[*target->source]; !own.empty())
            units.push_back(own);
        return units;
    }
    for (const std::string& unit : positions)
        if (isPositionUnit(unit))
            addUnit(units, unit);
    return units;
}

std::vector<std::string> unitsForValues(const CompensationTable& table)
{
    return unitsForValues(unitsOfPositions(table.grid), targetOf(table));
}

bool isUnitOfAxisCertain(
    std::span<const std::string> positions, const std::optional<TargetAxis>& target)
{
    return unitsForValues(positions, target).size() < 2 && (target || haveOneUnit(positions));
}

bool isUnitOfAxisCertain(const CompensationTable& table)
{
    return isUnitOfAxisCertain(unitsOfPositions(table.grid), targetOf(table));
}

bool haveOneUnit(const Grid& grid)
{
    return haveOneUnit(unitsOfPositions(grid));
}

Result<TableInUnits> inDriveUnits(
    const CompensationTable& table, const TableUnits& units, UnstatedUnit unstated)
{
    TableInUnits result{table, {}};
    CompensationTable& converted = result.table;
    AXISCOMP_TRY(const std::string before, unitOfValues(table, units.values, unstated));
    AXISCOMP_TRY(
        const double factor, driveFactor(before, units.values, AXISCOMP_TEXT("Error", "values")));
    if (factor != 1.0) {
        for (float& value : converted.values)
            value = static_cast<float>(static_cast<double>(value) * factor);
    }
    const bool isStated = !table.unit.empty();
    if (factor != 1.0 || !isStated)
        converted.unit = unitSymbol(units.values);
    if (auto remark = valueRemark(before, isStated, units.values, converted))
        result.remarks.push_back(std::move(*remark));
    const std::size_t dimensions = std::min(converted.grid.axes.size(), units.positions.size());
    for (std::size_t n = 0; n < dimensions; ++n) {
        const bool isAssumed = table.grid.axes[n].unit.empty() && statesUnits(table)
            && !unitSymbol(units.positions[n]).empty();
        if (isAssumed)
            result.remarks.push_back(
                positionAssumption(table.grid.axes[n], n + 1, units.positions[n]));
        AXISCOMP_TRY(
            auto remark, convertPositions(converted.grid.axes[n], n + 1, units.positions[n]));
        if (remark)
            result.remarks.push_back(std::move(*remark));
    }
    return result;
}

Result<TableInUnits> inUnitsOfAxis(const CompensationTable& table, const TableUnits& units,
    std::optional<std::size_t> ownDimension, UnstatedUnit unstated)
{
    if (targetOf(table) || !ownDimension)
        return inDriveUnits(table, units, unstated);
    CompensationTable asked = table;
    asked.target = sourceTarget(*ownDimension);
    AXISCOMP_TRY(auto converted, inDriveUnits(asked, units, unstated));
    converted.table.target = table.target;
    return converted;
}

} // namespace axiscomp
