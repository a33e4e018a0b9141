// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/own_axis.h"

#include "core/formats/format_writer.h"
#include "core/formats/units.h"
#include "core/table/position_unit.h"

namespace axiscomp {

namespace {

constexpr std::string_view positionKey = "position-unit";
constexpr std::string_view valueKey = "value-unit";

std::optional<Diagnostic> contradictionOf(const SettingValues& settings)
{
    if (!settings.has(positionKey) || !settings.has(valueKey)
        || isSameUnit(settings.text(positionKey), settings.text(valueKey)))
        return std::nullopt;
    return unitContradiction(settings.text(positionKey), settings.text(valueKey));
}

/// What positions and values are written in; empty when nobody says it.
std::string chosenUnit(const NeutralTable& table, const SettingValues& settings)
{
    for (const std::string& unit :
        {settings.text(positionKey), settings.text(valueKey), table.axes.front().unit})
        if (!unit.empty())
            return unit;
    return {};
}

} // namespace

void takeOneUnit(NeutralTable& table, const SettingValues& settings, DiagnosticList& diagnostics,
    std::string_view stated)
{
    const std::string set = settings.text(settings.has(positionKey) ? positionKey : valueKey);
    const std::string unit = set.empty() ? std::string(stated) : set;
    if (!stated.empty() && !isSameUnit(unit, stated))
        diagnostics.error(DiagnosticCode::Contradiction, 0, 0,
            AXISCOMP_TEXT("Error", "numbers in {unit}, as the file says").with("unit", stated),
            AXISCOMP_TEXT("Error", "{unit}, as the setting says").with("unit", unit));
    for (SourceAxis& axis : table.axes)
        axis.unit = unit;
    for (CompensationColumn& column : table.columns) {
        column.unit = unit;
        column.target = sourceTarget(0);
    }
    if (auto contradiction = contradictionOf(settings))
        diagnostics.error(*std::move(contradiction));
    if (unit.empty())
        diagnostics.warning(DiagnosticCode::UnitNotGiven, 0, 0,
            AXISCOMP_TEXT("Error", "numbers without a unit"),
            AXISCOMP_TEXT("Error", "the setting {key}, such as mm, where a unit matters")
                .with("key", positionKey));
}

Result<NeutralTable> asOwnAxisTable(const FormatFacts& facts, const NeutralTable& table,
    const SettingValues& settings, std::vector<Text>& remarks)
{
    AXISCOMP_CHECK(checkOwnAxis(
        facts, table, AXISCOMP_TEXT("Error", "choose a format for cross compensation")));
    AXISCOMP_CHECK(checkOneUnit(facts, contradictionOf(settings)));
    NeutralTable own = table;
    const std::string unit = chosenUnit(own, settings);
    own.name.clear();
    own.notes.clear();
    for (SourceAxis& axis : own.axes) {
        axis.name.clear();
        axis.unit = axis.unit.empty() ? unit : axis.unit;
    }
    for (CompensationColumn& column : own.columns) {
        column.name.clear();
        column.target = sourceTarget(0);
        column.unit = column.unit.empty() ? unit : column.unit;
    }
    remarks.push_back(
        AXISCOMP_TEXT("Error", "positions and values are in {unit}")
            .with("unit",
                unit.empty() ? Argument(AXISCOMP_TEXT("Error", "no known unit")) : Argument(unit)));
    return unit.empty() ? own : inUnits(own, unit, unit, remarks);
}

} // namespace axiscomp
