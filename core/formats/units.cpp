// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/units.h"

#include "core/table/position_unit.h"
#include "core/table/table_units.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

/// A factor between two units. A whole one is exactly that, and so is the reciprocal of one: 2.3 um
/// are 0.0023 mm, and no digits more.
struct Factor {
    double multiplier = 1.0;
    double divisor = 1.0;

    [[nodiscard]] double operator()(double number) const { return number * multiplier / divisor; }
};

double wholeIfNearly(double number)
{
    const double whole = std::round(number);
    return std::abs(number - whole) <= 1e-12 * whole ? whole : number;
}

void scale(std::vector<double>& numbers, const Factor& factor)
{
    for (double& number : numbers)
        number = factor(number);
}

Result<Factor> factorBetween(const std::string& from, const std::string& to)
{
    if (isSameUnit(from, to))
        return Factor{};
    if (const auto factor = unitFactor(from, to))
        return *factor < 1.0 ? Factor{1.0, wholeIfNearly(1.0 / *factor)}
                             : Factor{wholeIfNearly(*factor), 1.0};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error", "numbers in {from} cannot be given in {to}")
                .with("from", from)
                .with("to", to)}});
}

Result<void> convertAxis(SourceAxis& axis, const std::string& unit)
{
    AXISCOMP_TRY(const auto factor, factorBetween(axis.unit, unit));
    scale(axis.knots, factor);
    if (axis.wrap)
        axis.wrap = (factor)(*axis.wrap);
    axis.unit = unit;
    axis.step = (factor)(axis.step);
    return {};
}

Result<void> convertColumn(CompensationColumn& column, const std::string& unit)
{
    AXISCOMP_TRY(const auto factor, factorBetween(column.unit, unit));
    scale(column.values, factor);
    column.unit = unit;
    return {};
}

/// The one of two units that can hold numbers in another; the first for an unknown one.
std::string fittingUnit(const std::string& unit, std::string_view length, std::string_view angle)
{
    const bool isAngle = !unit.empty() && !angle.empty() && !unitFactor(unit, length)
        && unitFactor(unit, angle).has_value();
    return std::string(isAngle ? angle : length);
}

/// Of the positions that a column corrects: of its own axis, or of the first source that can be a
/// length or an angle; a correction is no temperature.
const std::string& correctedUnit(const NeutralTable& table, const CompensationColumn& column)
{
    if (const auto own = ownAxis(table, column))
        return table.axes[*own].unit;
    const auto position = std::ranges::find_if(table.axes,
        [](const SourceAxis& axis) { return axis.unit.empty() || isPositionUnit(axis.unit); });
    return (position == table.axes.end() ? table.axes.front() : *position).unit;
}

/// Whether values can be in the unit of the positions that they correct. Those of another axis than
/// a source may be angles over lengths, and the other way round.
bool canBeInCorrectedUnit(const NeutralTable& table, const CompensationColumn& column)
{
    const std::string& unit = correctedUnit(table, column);
    return ownAxis(table, column) || unitFactor(column.unit.empty() ? "mm" : column.unit, unit);
}

/// The units of positions in which values for another axis than theirs can be, each once.
std::vector<std::string> unitsForOther(const NeutralTable& table)
{
    std::vector<std::string> units;
    for (const SourceAxis& axis : table.axes)
        if (unitFactor("mm", axis.unit))
            addUnit(units, axis.unit);
    return units;
}

/// Of values that cannot be in the unit of the positions that they are added to.
Text otherKind(const NeutralTable& table, const CompensationColumn& column, const std::string& unit)
{
    const bool hasCounts = column.unit == countsUnit || unit == countsUnit;
    const TextPattern sentence = hasCounts
        ? AXISCOMP_TEXT("Error",
            "the values for {column} are in {unit}, and the positions that they are added to in "
            "{other}; state how many counts are one unit, with the setting {key} of the file that "
            "is read")
        : AXISCOMP_TEXT("Error",
            "the values for {column} are in {unit}, which cannot be given in {other}, the unit of "
            "the positions that they are added to; correct the units");
    return sentence.with("column", columnText(table, column))
        .with("unit", column.unit)
        .with("other", unit)
        .with("key", Verbatim{"counts-per-unit"});
}

Argument unitWords(const std::string& unit)
{
    if (unit.empty())
        return AXISCOMP_TEXT("Error", "a unit that is not said");
    return unit;
}

/// Of all sources, each once.
Argument statedUnitsOf(const NeutralTable& table)
{
    std::vector<std::string> units;
    for (const SourceAxis& axis : table.axes)
        if (!axis.unit.empty())
            addUnit(units, axis.unit);
    return units.empty() ? unitWords({}) : Argument(units);
}

} // namespace

Result<void> checkCounts(const FormatFacts& facts, const FormatSettings& settings)
{
    for (const auto& [key, value] : settings)
        if (key.ends_with("counts-per-unit") && numberOf(value))
            AXISCOMP_CHECK(checkAboveZero(facts, key, value));
    return {};
}

void remarkOnce(std::vector<Text>& remarks, Text remark)
{
    if (std::ranges::find(remarks, remark) == remarks.end())
        remarks.push_back(std::move(remark));
}

void takeUnits(NeutralTable& table, const SettingValues& settings, DiagnosticList& diagnostics)
{
    takePositionUnit(table, settings, diagnostics);
    takeValueUnit(table, settings, diagnostics);
}

void takePositionUnit(
    NeutralTable& table, const SettingValues& settings, DiagnosticList& diagnostics)
{
    for (SourceAxis& axis : table.axes)
        axis.unit = settings.text("position-unit");
    if (!settings.has("position-unit"))
        warnOfOpenPositionUnit(diagnostics);
}

void takeValueUnit(NeutralTable& table, const SettingValues& settings, DiagnosticList& diagnostics)
{
    for (CompensationColumn& column : table.columns)
        column.unit = settings.text("value-unit");
    if (!settings.has("value-unit"))
        warnOfOpenValueUnit(diagnostics);
}

void warnOfOpenPositionUnit(DiagnosticList& diagnostics)
{
    diagnostics.warning(DiagnosticCode::UnitNotGiven, 0, 0,
        AXISCOMP_TEXT("Error", "positions without a unit"),
        AXISCOMP_TEXT("Error", "the setting {key}, such as mm, where a unit matters")
            .with("key", Verbatim{"position-unit"}));
}

void warnOfOpenValueUnit(DiagnosticList& diagnostics)
{
    // No smaller unit as an example: most values have that of the positions they are added to.
    diagnostics.warning(DiagnosticCode::UnitNotGiven, 0, 0,
        AXISCOMP_TEXT("Error", "values without a unit"),
        AXISCOMP_TEXT("Error", "the setting {key}, such as mm, where a unit matters")
            .with("key", Verbatim{"value-unit"}));
}

std::optional<Diagnostic> unitContradiction(const NeutralTable& table)
{
    for (const CompensationColumn& column : table.columns) {
        const auto own = ownAxis(table, column);
        if (!own || column.unit.empty() || table.axes[*own].unit.empty()
            || isSameUnit(column.unit, table.axes[*own].unit))
            continue;
        return unitContradiction(table.axes[*own].unit, column.unit);
    }
    return std::nullopt;
}

Diagnostic unitContradiction(const std::string& positions, const std::string& values)
{
    return {Severity::Error, DiagnosticCode::Contradiction, 0, 0,
        AXISCOMP_TEXT("Error", "positions in {unit} and values in {other}")
            .with("unit", positions)
            .with("other", values),
        AXISCOMP_TEXT("Error", "one unit, since the controller adds the values to the positions"),
        {}};
}

Result<void> checkOneUnit(const FormatFacts& facts, const std::optional<Diagnostic>& contradiction)
{
    if (!contradiction)
        return {};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error", "{units}: the format {format} has one unit for both")
                .with("units", contradiction->found)
                .with("format", facts.name)}});
}

Result<NeutralTable> withUnitsOfValues(const NeutralTable& table, std::vector<Text>& remarks)
{
    NeutralTable known = table;
    const std::vector<std::string> forOther = unitsForOther(known);
    for (CompensationColumn& column : known.columns) {
        const std::string& unit = correctedUnit(known, column);
        if (column.unit.empty() && !ownAxis(known, column) && forOther.size() > 1)
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the values for {column} have no unit, and the positions are in "
                        "{positions}; state it in the header, as Z [mm], or as the setting {key} "
                        "of the file that is read")
                        .with("column", columnText(known, column))
                        .with("positions", forOther)
                        .with("key", Verbatim{"value-unit"})}});
        if (column.unit.empty() && !unit.empty() && canBeInCorrectedUnit(known, column)) {
            column.unit = unit;
            remarkOnce(remarks,
                AXISCOMP_TEXT("Error",
                    "the values for {column} have no unit; they are taken to be in {unit}, as the "
                    "positions are")
                    .with("column", columnText(known, column))
                    .with("unit", unit));
        } else if (unit.empty() && !column.unit.empty() && ownAxis(known, column)) {
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "the values for {column} are in {unit}, and the positions that they are "
                        "added to have no unit; state it in the header, as X [mm], or as the "
                        "setting {key} of the file that is read")
                        .with("column", columnText(known, column))
                        .with("unit", column.unit)
                        .with("key", Verbatim{"position-unit"})}});
        } else if (ownAxis(known, column) && !isSameUnit(column.unit, unit)
            && !unitFactor(column.unit, unit)) {
            return fail(ErrorCode::InvalidArgument, {{"reason", otherKind(known, column, unit)}});
        }
    }
    return known;
}

Result<NeutralTable> inUnits(const NeutralTable& table, std::string_view lengthUnit,
    std::string_view angleUnit, std::vector<Text>& remarks)
{
    NeutralTable converted = table;
    const auto assume = [&](std::string& unit, const TextPattern& what) {
        if (!unit.empty())
            return;
        unit = lengthUnit;
        remarkOnce(remarks,
            AXISCOMP_TEXT("Error", "the {what} have no unit; they are taken to be {unit}")
                .with("what", what)
                .with("unit", unit));
    };
    for (SourceAxis& axis : converted.axes) {
        assume(axis.unit, AXISCOMP_TEXT("Error", "positions"));
        AXISCOMP_CHECK(convertAxis(axis, fittingUnit(axis.unit, lengthUnit, angleUnit)));
    }
    for (CompensationColumn& column : converted.columns) {
        assume(column.unit, AXISCOMP_TEXT("Error", "values"));
        const std::string unit = fittingUnit(column.unit, lengthUnit, angleUnit);
        AXISCOMP_CHECK(convertColumn(column, unit));
    }
    return converted;
}

Result<NeutralTable> inSettingUnits(
    const NeutralTable& table, const SettingValues& settings, std::vector<Text>& remarks)
{
    NeutralTable converted = table;
    const std::string positionUnit = settings.text("position-unit");
    const std::string valueUnit = settings.text("value-unit");
    for (SourceAxis& axis : converted.axes) {
        if (positionUnit.empty())
            continue;
        if (axis.unit.empty())
            axis.unit = positionUnit;
        AXISCOMP_CHECK(convertAxis(axis, positionUnit));
    }
    for (CompensationColumn& column : converted.columns) {
        const bool canBe = canBeInCorrectedUnit(converted, column);
        const std::string wanted = !valueUnit.empty() ? valueUnit
            : canBe                                   ? correctedUnit(converted, column)
                                                      : column.unit;
        if (wanted.empty())
            continue;
        if (column.unit.empty())
            column.unit = wanted;
        AXISCOMP_CHECK(convertColumn(column, wanted));
    }
    for (const SourceAxis& axis : converted.axes)
        remarkOnce(remarks,
            AXISCOMP_TEXT("Error", "the positions are in {unit}")
                .with("unit", unitWords(axis.unit)));
    for (const CompensationColumn& column : converted.columns)
        remarkOnce(remarks,
            AXISCOMP_TEXT("Error", "the values are in {unit}")
                .with("unit", unitWords(column.unit)));
    return converted;
}

Result<void> checkUnitOfAxis(const NeutralTable& table)
{
    std::vector<std::string> positions;
    for (const SourceAxis& axis : table.axes)
        positions.push_back(axis.unit);
    for (const CompensationColumn& column : table.columns) {
        if (!column.unit.empty() && !canBeInCorrectedUnit(table, column))
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "a .TAMtbl has no units, and a drive takes its values in the unit of the "
                        "axis that they correct. These are in {unit} and the positions in "
                        "{positions}, none of which is that of the axis for certain: convert to a "
                        ".csv file first, and that one with --value-unit and the unit of the axis, "
                        "such as --value-unit {example}")
                        .with("unit", column.unit)
                        .with("positions", statedUnitsOf(table))
                        .with("example",
                            std::string(unitFactor(column.unit, "deg") ? "deg" : "mm"))}});
        if (!isUnitOfAxisCertain(positions, targetOf(table, column)))
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error",
                        "a .TAMtbl has no units, and a drive takes its values in the unit of the "
                        "axis that they correct. The positions have different units, and it is "
                        "not stated which one that is: convert to a .csv file first, and that one "
                        "with --value-unit, such as --value-unit mm, or, if the values correct "
                        "the axis of one of the positions, state the target, such as #1 for the "
                        "first")}});
    }
    return {};
}

Result<NeutralTable> inPositionUnits(const NeutralTable& table, std::vector<Text>& remarks)
{
    NeutralTable converted = table;
    for (CompensationColumn& column : converted.columns) {
        const std::string& unit = correctedUnit(converted, column);
        if (unit.empty() || column.unit.empty()) {
            remarkOnce(remarks,
                AXISCOMP_TEXT("Error",
                    "not all units are said: the values are taken to be in the unit of the "
                    "positions"));
            continue;
        }
        if (isSameUnit(column.unit, unit) || !canBeInCorrectedUnit(converted, column))
            continue;
        const std::string before = column.unit;
        AXISCOMP_CHECK(convertColumn(column, unit));
        remarkOnce(remarks,
            AXISCOMP_TEXT("Error",
                "the values were in {before} and are now in {unit}, the unit of the positions")
                .with("before", before)
                .with("unit", unit));
    }
    return converted;
}

} // namespace axiscomp
