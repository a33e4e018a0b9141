// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"

#include "core/neutral/added_columns.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace axiscomp {

namespace {

/// Numbers that are read are finite; what is computed from them need not be, nor be different.
void checkComputed(const NeutralTable& table, DiagnosticList& diagnostics)
{
    const auto isFinite = [](double number) { return std::isfinite(number); };
    for (const SourceAxis& axis : table.axes) {
        const bool isAscending =
            std::ranges::adjacent_find(axis.knots, std::greater_equal<>()) == axis.knots.end();
        if (!isAscending || !std::ranges::all_of(axis.knots, isFinite))
            diagnostics.error(DiagnosticCode::NotFinite, 0, 0,
                axis.name.empty()
                    ? AXISCOMP_TEXT("Error", "positions of the axis")
                    : AXISCOMP_TEXT("Error", "positions of {axis}").with("axis", axis.name),
                AXISCOMP_TEXT(
                    "Error", "numbers that a computer can tell from each other; check their size"));
    }
    for (const CompensationColumn& column : table.columns)
        if (!std::ranges::all_of(column.values, isFinite))
            diagnostics.error(DiagnosticCode::NotFinite, 0, 0,
                column.target.empty()
                    ? AXISCOMP_TEXT("Error", "values of the table")
                    : AXISCOMP_TEXT("Error", "values of {target}").with("target", column.target),
                AXISCOMP_TEXT("Error", "numbers that a computer can hold; check their size"));
}

/// A zero has no sign, whatever a file or the factor of a unit says.
void dropSignsOfZeros(std::vector<double>& numbers)
{
    for (double& number : numbers)
        number = number == 0.0 ? 0.0 : number;
}
void dropSignsOfZeros(NeutralTable& table)
{
    for (SourceAxis& axis : table.axes)
        dropSignsOfZeros(axis.knots);
    for (CompensationColumn& column : table.columns)
        dropSignsOfZeros(column.values);
}

/// What a reader leaves as NaN has no value.
void complete(NeutralTable& table, MissingPoints missing, DiagnosticList& diagnostics)
{
    IncompleteGrid grid;
    grid.names = axisTexts(table);
    for (const SourceAxis& axis : table.axes) {
        grid.knots.push_back(axis.knots);
        grid.units.push_back(axis.unit);
    }
    for (const CompensationColumn& column : table.columns) {
        grid.tables.push_back(column.values);
        grid.tableNames.push_back(columnText(table, column));
        grid.valueUnits.push_back(column.unit);
    }
    auto completed = completeGrid(std::move(grid), missing, diagnostics);
    if (!completed)
        return;
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        table.axes[n].knots = std::move(completed->knots[n]);
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        CompensationColumn& column = table.columns[n];
        column.values = std::move(completed->tables[n]);
        column.filled = std::move(completed->filled[n]);
        if (!column.filled.empty())
            table.notes.push_back(filledNote(
                columnText(table, column).english(), column.filled.size(), column.values.size()));
    }
}

constexpr std::string_view rotaryAxesKey = "rotary-axes";

/// "C", "B2": what turns by ISO 841.
bool isRotaryByName(std::string_view axis)
{
    constexpr std::string_view letters = "ABCabc";
    return !axis.empty() && letters.find(axis.front()) != std::string_view::npos
        && std::ranges::all_of(axis.substr(1), [](char c) { return c >= '0' && c <= '9'; });
}

/// Where a file does not say which axes turn, those that nobody names are taken to be in mm.
void warnOfLinearAxes(
    const FormatFacts& facts, const std::vector<NeutralTable>& tables, DiagnosticList& diagnostics)
{
    if (std::ranges::find(facts.settings, rotaryAxesKey, &FormatSetting::key)
        == facts.settings.end())
        return;
    std::set<std::string> linear;
    const auto add = [&linear](const std::string& axis, const std::string& unit) {
        if (unit == "mm" && isRotaryByName(axis))
            linear.insert(axis);
    };
    for (const NeutralTable& table : tables) {
        for (const SourceAxis& axis : table.axes)
            add(axis.name, axis.unit);
        for (const CompensationColumn& column : table.columns)
            add(targetName(table, column), column.unit);
    }
    for (const std::string& axis : linear)
        diagnostics.warning(DiagnosticCode::Assumption, 0, 0,
            AXISCOMP_TEXT("Error", "axis {axis}, whose numbers are taken to be in mm")
                .with("axis", axis),
            AXISCOMP_TEXT("Error", "the setting {key} where the axis is rotary")
                .with("key", Verbatim{std::string(rotaryAxesKey)}));
}

/// A setting that names the rotary axes of a file means none where it names no axis of it.
void checkRotaryAxes(const std::vector<NeutralTable>& tables, const SettingValues& settings,
    DiagnosticList& diagnostics)
{
    constexpr std::string_view key = rotaryAxesKey;
    const std::string given = settings.text(key);
    std::vector<Token> rotary;
    splitTokens({given, 0, 0}, ", ", rotary);
    std::set<std::string> axes;
    for (const NeutralTable& table : tables) {
        for (const SourceAxis& axis : table.axes)
            axes.insert(axis.name);
        for (const CompensationColumn& column : table.columns)
            axes.insert(targetName(table, column));
    }
    axes.erase("");
    const auto isThere = [&axes](const Token& name) {
        return std::ranges::any_of(
            axes, [&name](const std::string& axis) { return sameLetters(axis, name.text); });
    };
    if (rotary.empty() || axes.empty() || std::ranges::any_of(rotary, isThere))
        return;
    diagnostics.error(DiagnosticCode::Contradiction, 0, 0,
        AXISCOMP_TEXT("Error", "{axes} as the setting {key}").with("axes", given).with("key", key),
        AXISCOMP_TEXT("Error", "an axis of the file: {axes}")
            .with("axes", std::vector<std::string>(axes.begin(), axes.end())));
}

} // namespace

void TextReading::error(std::string_view number, DiagnosticCode code, std::size_t line,
    std::size_t column, Text found, Text expected)
{
    diagnostics.error({.severity = Severity::Error,
        .code = code,
        .line = line,
        .column = column,
        .found = std::move(found),
        .expected = std::move(expected),
        .controllerError = std::string(number)});
}

void warnOfAddedTables(std::span<const NeutralTable> tables, DiagnosticList& diagnostics)
{
    for (AddedColumns& added : addedColumns(tables))
        diagnostics.warning(DiagnosticCode::Assumption, 0, 0,
            AXISCOMP_TEXT("Error", "several tables of {axes}")
                .with("axes", std::move(added.columns)),
            AXISCOMP_TEXT("Error",
                "their sum, since the controller adds them; a table that is converted "
                "alone is a part of it"));
}

void warnOfSwitchedOff(const Token& statement, DiagnosticList& diagnostics)
{
    diagnostics.warning(DiagnosticCode::Assumption, statement.line, statement.column,
        AXISCOMP_TEXT("Error", "\"{statement}\", which switches a table of the file off")
            .with("statement", quoted(statement)),
        AXISCOMP_TEXT("Error", "tables that are in use; this one does not act on the machine"));
}

Result<TableReading> readText(const FormatFacts& facts, std::string_view text,
    const TableReadOptions& options, std::vector<NeutralTable> (*parse)(TextReading&))
{
    AXISCOMP_TRY(const auto settings, SettingValues::of(facts, options.settings, false));
    TableReading reading;
    DiagnosticList diagnostics(options.maximumDiagnostics);
    if (isReadableText(text, facts.mostBytes, diagnostics)) {
        TextReading source{text, options, settings, diagnostics};
        reading.tables = parse(source);
        for (NeutralTable& table : reading.tables)
            dropSignsOfZeros(table);
        checkRotaryAxes(reading.tables, settings, diagnostics);
        warnOfLinearAxes(facts, reading.tables, diagnostics);
        if (!diagnostics.hasErrors() && options.missing != MissingPoints::Refuse)
            for (NeutralTable& table : reading.tables)
                complete(table, options.missing, diagnostics);
        if (!diagnostics.hasErrors())
            for (const NeutralTable& table : reading.tables)
                checkComputed(table, diagnostics);
    }
    reading.cancelled = options.stop.stop_requested();
    if (diagnostics.hasErrors() || reading.cancelled)
        reading.tables.clear();
    reading.suppressed = diagnostics.suppressed();
    reading.diagnostics = diagnostics.take();
    return reading;
}

} // namespace axiscomp
