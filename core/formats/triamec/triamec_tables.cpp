// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/triamec/triamec_tables.h"

#include "core/formats/format_writer.h"
#include "core/formats/formats.h"
#include "core/formats/units.h"
#include "core/table/even_spacing.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

auto refuse(Text reason, Text wayOut)
{
    return cannotHold(calibration_csv::format().facts, std::move(reason), std::move(wayOut));
}

bool hasKnots(const GridAxis& axis, const std::vector<double>& knots)
{
    for (std::size_t i = 0; i < knots.size(); ++i)
        if (axis.position(i) != knots[i])
            return false;
    return true;
}

/// A distance that is computed from positions is not the stated one to the last bit. That one is
/// kept where it still gives the positions.
GridAxis gridAxis(const SourceAxis& axis)
{
    GridAxis grid{axis.name, axis.unit, axis.knots.front(), axis.distance.value_or(0.0),
        static_cast<std::uint32_t>(axis.knots.size())};
    if (axis.distance && hasKnots(grid, axis.knots))
        return grid;
    const EvenSpacing spacing = fitEvenSpacing(axis.knots, noDecimals);
    grid.start = spacing.start;
    grid.distance = spacing.distance;
    return grid;
}

/// The number that a person would write for a float32: 0.0021 and not 0.0020999999046325684. Made
/// a float32 again it is the same.
double plainValue(float value)
{
    const std::string text = toText(value);
    return numberOf(text).value_or(static_cast<double>(value));
}

Result<std::vector<float>> floatValues(const CompensationColumn& column)
{
    std::vector<float> values;
    values.reserve(column.values.size());
    for (const double value : column.values) {
        values.push_back(static_cast<float>(value));
        if (!std::isfinite(values.back()))
            return refuse(AXISCOMP_TEXT("Error", "a value is beyond what a float32 can be"),
                AXISCOMP_TEXT("Error", "check the unit of the values"));
    }
    return values;
}

} // namespace

std::string nameOfTable(const NeutralTable& table, std::size_t index)
{
    const CompensationColumn& column = table.columns[index];
    const std::string target = targetName(table, column);
    for (const std::string* name : {&column.name, &target, &table.name})
        if (!name->empty() && (name != &table.name || table.columns.size() == 1))
            return *name;
    return "Table " + std::to_string(index + 1);
}

NeutralTable neutralTable(
    const CalibrationData& data, const std::vector<std::vector<double>>& knots)
{
    NeutralTable neutral;
    neutral.notes = data.notes;
    for (std::size_t n = 0; n < data.grid.axes.size(); ++n) {
        const GridAxis& from = data.grid.axes[n];
        SourceAxis axis;
        axis.name = from.name;
        axis.unit = from.unit;
        axis.knots = knots.empty() ? evenKnots(from.start, from.distance, from.size) : knots[n];
        if (knots.empty())
            axis.distance = from.distance;
        neutral.axes.push_back(std::move(axis));
    }
    for (const CompensationTable& table : data.tables) {
        CompensationColumn column;
        column.name = table.name;
        column.unit = table.unit;
        column.target = table.target;
        column.filled = table.filled;
        column.values.reserve(table.values.size());
        for (const float value : table.values)
            column.values.push_back(plainValue(value));
        neutral.columns.push_back(std::move(column));
    }
    return neutral;
}

StatedUnits statedUnits(const FormatSettings& settings, StatedUnits stated)
{
    const auto take = [&settings](std::string_view key, std::string& unit) {
        const auto setting = settings.find(key);
        if (unit.empty() && setting != settings.end())
            unit = setting->second;
    };
    take("position-unit", stated.positions);
    take("value-unit", stated.values);
    return stated;
}

void stateUnits(CalibrationData& data, const FormatSettings& settings)
{
    const auto positions = settings.find("position-unit");
    const auto values = settings.find("value-unit");
    if (positions != settings.end())
        for (GridAxis& axis : data.grid.axes)
            axis.unit = positions->second;
    for (CompensationTable& table : data.tables) {
        table.grid = data.grid;
        if (values != settings.end())
            table.unit = values->second;
    }
}

std::vector<Diagnostic> openUnits(const CalibrationData& data)
{
    DiagnosticList diagnostics(2);
    if (std::ranges::any_of(data.grid.axes, &std::string::empty, &GridAxis::unit))
        warnOfOpenPositionUnit(diagnostics);
    if (std::ranges::any_of(data.tables, &std::string::empty, &CompensationTable::unit))
        warnOfOpenValueUnit(diagnostics);
    return diagnostics.take();
}

Result<CalibrationData> calibrationData(const NeutralTable& table)
{
    if (table.sign != SignConvention::Feedback)
        return refuse(AXISCOMP_TEXT("Error", "its values are offsets of the command"),
            AXISCOMP_TEXT("Error", "convert the sign"));
    const NeutralTable tables[] = {table};
    AXISCOMP_CHECK(checkHolds(calibration_csv::format().facts, tables));
    CalibrationData data;
    data.notes = table.notes;
    for (const SourceAxis& axis : table.axes)
        data.grid.axes.push_back(gridAxis(axis));
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        AXISCOMP_TRY(auto values, floatValues(table.columns[n]));
        data.tables.push_back({nameOfTable(table, n), table.columns[n].unit, data.grid,
            std::move(values), portableTarget(table.columns[n].target, sourceNames(table)),
            table.columns[n].filled});
    }
    return data;
}

} // namespace axiscomp
