// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/table_input.h"
#include "app/cli/output/json_output.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/formats/formats.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

Json diagnosticsJson(const std::vector<Diagnostic>& diagnostics, Severity severity)
{
    Json list = Json::array();
    for (const Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.severity == severity)
            list.push_back(toJson(diagnostic));
    }
    return list;
}

Json inspectJson(const TableInput& input, int dimensions)
{
    Json tables = Json::array();
    if (input.data) {
        for (const CompensationTable& table : input.data->tables)
            tables.push_back(toJson(table));
    }
    return {{"format", input.format->facts.name},
        {"dimensions", input.data ? input.data->grid.dimensions() : dimensions},
        {"axes", input.data ? toJson(input.data->grid) : Json::array()},
        {"tables", std::move(tables)},
        {"notes", input.data ? Json(input.data->notes) : Json::array()},
        {"warnings", diagnosticsJson(input.diagnostics, Severity::Warning)},
        {"errors", diagnosticsJson(input.diagnostics, Severity::Error)}};
}

std::string targetText(const std::string& target)
{
    return target.empty() ? "not stated" : target;
}

std::string headline(const TableInput& input, const TableInputOptions& options)
{
    const CalibrationData& data = *input.data;
    const bool isTamTable = input.format->facts.holdsPersistency;
    std::string text = displayName(options.file) + ": " + std::string(input.format->facts.name)
        + ", "
        + plural(static_cast<std::uint64_t>(data.grid.dimensions()), "dimension", "dimensions")
        + ", " + plural(data.grid.pointCount(), "point", "points") + ", "
        + plural(data.tables.size(), "table", "tables");
    if (isTamTable)
        text += std::string(", ") + (input.persistent ? "persistent" : "volatile") + ", "
            + plural(input.bytes, "byte", "bytes");
    return text + "\n";
}

std::string gridText(const Grid& grid)
{
    TextTable table({">dimension", "name", "unit", ">start", ">distance", ">size", ">last"});
    for (std::size_t n = 0; n < grid.axes.size(); ++n) {
        const GridAxis& axis = grid.axes[n];
        table.add({std::to_string(n + 1), axis.name, axis.unit, shortText(axis.start),
            shortText(axis.distance), countText(axis.size), shortText(axis.last())});
    }
    return table.text();
}

std::string tablesText(const CalibrationData& data)
{
    const bool hasFilled = std::ranges::any_of(
        data.tables, [](const CompensationTable& table) { return !table.filled.empty(); });
    std::vector<std::string> header{">table", "name", "target", "unit", ">min", ">max", ">rms"};
    if (hasFilled)
        header.emplace_back(">filled");
    TextTable table(header);
    for (std::size_t i = 0; i < data.tables.size(); ++i) {
        const TableStatistics figures = statistics(data.tables[i]);
        const std::string& target = data.tables[i].target;
        std::vector<std::string> row{std::to_string(i + 1), data.tables[i].name, targetText(target),
            data.tables[i].unit, shortText(figures.minimum), shortText(figures.maximum),
            shortText(figures.rms)};
        if (hasFilled)
            row.push_back(countText(data.tables[i].filled.size()));
        table.add(row);
    }
    return table.text();
}

Json neutralJson(const NeutralTable& table, const FormatFacts& facts)
{
    Json axes = Json::array();
    for (const SourceAxis& axis : table.axes)
        axes.push_back({{"name", axis.name}, {"unit", axis.unit}, {"first", axis.knots.front()},
            {"last", axis.knots.back()}, {"size", axis.knots.size()}, {"even", isEven(axis)},
            {"wrap", axis.wrap ? Json(*axis.wrap) : Json(nullptr)}});
    std::vector<std::size_t> sizes;
    for (const SourceAxis& axis : table.axes)
        sizes.push_back(axis.knots.size());
    Json columns = Json::array();
    for (const CompensationColumn& column : table.columns) {
        const TableStatistics figures = statisticsOf(column.values);
        columns.push_back({{"name", column.name},
            {"target", column.target.empty() ? Json(nullptr) : Json(column.target)},
            {"unit", column.unit}, {"direction", directionName(column.direction)},
            {"min", figures.minimum}, {"max", figures.maximum}, {"rms", figures.rms},
            {"filled", filledJson(column.filled, sizes)}});
    }
    return {{"name", table.name}, {"dimensions", table.axes.size()}, {"axes", std::move(axes)},
        {"columns", std::move(columns)}, {"sign", signName(table.sign)},
        {"signEvidence", evidenceName(facts.signEvidence)}, {"notes", table.notes}};
}

std::string neutralText(const NeutralTable& table)
{
    TextTable axes({">source", "name", "unit", ">first", ">last", ">points", "positions"});
    for (std::size_t n = 0; n < table.axes.size(); ++n) {
        const SourceAxis& axis = table.axes[n];
        axes.add({std::to_string(n + 1), axis.name, axis.unit, shortText(axis.knots.front()),
            shortText(axis.knots.back()), countText(axis.knots.size()),
            std::string(isEven(axis) ? "even" : "uneven")
                + (axis.wrap ? ", modulo " + shortText(*axis.wrap) : "")});
    }
    TextTable columns({"column", "target", "direction", "unit", ">min", ">max", ">rms"});
    for (const CompensationColumn& column : table.columns) {
        const TableStatistics figures = statisticsOf(column.values);
        columns.add({column.name, targetText(column.target),
            std::string(directionName(column.direction)), column.unit, shortText(figures.minimum),
            shortText(figures.maximum), shortText(figures.rms)});
    }
    std::string text = "\n";
    if (!table.name.empty())
        text += "Table " + singleLine(table.name) + "\n";
    return text + axes.text() + "\n" + columns.text();
}

/// A file of another controller.
ExitCode reportOther(
    Environment& environment, const TableInput& input, const TableInputOptions& options)
{
    Json tables = Json::array();
    for (const NeutralTable& table : input.tables)
        tables.push_back(neutralJson(table, input.format->facts));
    environment.document({{"format", input.format->facts.name}, {"tables", std::move(tables)},
        {"warnings", diagnosticsJson(input.diagnostics, Severity::Warning)},
        {"errors", diagnosticsJson(input.diagnostics, Severity::Error)}});
    if (input.tables.empty())
        return ExitCode::InputFile;
    const NeutralTable& first = input.tables.front();
    environment.print(displayName(options.file) + ": " + std::string(input.format->facts.name)
        + " (" + std::string(input.format->facts.controller) + "), "
        + plural(input.tables.size(), "table", "tables") + ", sign "
        + std::string(signName(first.sign)) + (input.format->facts.needsSign() ? " (assumed)" : "")
        + "\n");
    for (const NeutralTable& table : input.tables) {
        environment.print(neutralText(table));
        for (const std::string& note : table.notes)
            environment.print("  note: " + singleLine(note) + "\n");
    }
    return ExitCode::Done;
}

Result<ExitCode> runInspect(Environment& environment, const TableInputOptions& options)
{
    auto input = inspectInput(environment, options);
    if (!input)
        return fail(input.error());
    if (!isTriamec(*input->format))
        return reportOther(environment, *input, options);
    environment.document(inspectJson(*input, options.dimensions));
    if (!input->data)
        return ExitCode::InputFile;
    environment.print(headline(*input, options) + "\n" + gridText(input->data->grid) + "\n"
        + tablesText(*input->data));
    if (!input->data->notes.empty())
        environment.print("\nNotes\n");
    for (const std::string& note : input->data->notes)
        environment.print("  " + singleLine(note) + "\n");
    return ExitCode::Done;
}

} // namespace

void addInspectCommand(CommandLine& line)
{
    auto options = std::make_shared<TableInputOptions>();
    options->command = commandName("inspect");
    CLI::App* command = line.add("inspect", fileCommands,
        AXISCOMP_HELP("Help", "Check a file and report its format, grid, tables and problems"),
        [options](Environment& environment) { return runInspect(environment, *options); });
    command
        ->add_option("FILE", options->file,
            AXISCOMP_HELP("Help", "Calibration file or table; - for standard input"))
        ->required();
    addDimensionsOption(*command, *options);
    addFromOption(*command, *options);
    addIncompleteGridOptions(*command, *options);
    addProfileOption(*command, options->profile);
}

} // namespace axiscomp::app
