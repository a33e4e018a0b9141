// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"
#include "app/cli/json_output.h"
#include "app/cli/output_file.h"
#include "app/cli/table_input.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "core/formats/families.h"
#include "core/tam_table.h"

namespace axiscomp::app {

namespace {

struct ConvertOptions {
    TableInputOptions input;
    std::string output;
    std::string to;
    std::string name;
    bool persistent = false;
    bool isVolatile = false;
};

/// What goes into the output file: all tables where it can hold several and none was named.
Result<CalibrationData> chosenTables(
    CalibrationData data, const ConvertOptions& options, const FamilyFacts& to)
{
    const bool wantsAll =
        to.mostColumns != 1 && options.input.table.empty() && options.name.empty();
    if (!wantsAll) {
        const auto index = chooseTable(data, options.input);
        if (!index)
            return fail(index.error());
        CompensationTable chosen = std::move(data.tables[*index]);
        data.tables.clear();
        data.tables.push_back(std::move(chosen));
    }
    if (!options.name.empty())
        data.tables.front().name = options.name;
    return data;
}

Result<Bytes> encodeTable(Environment& environment, const ConvertOptions& options,
    const CompensationTable& table, bool persistent)
{
    auto profile = profileOf(options.input.profile);
    if (!profile)
        return fail(profile.error());
    const auto& place = profile->layout.place(TableField::Name);
    if (!options.name.empty() && !place)
        environment.warn("the table layout of profile " + profile->name
            + " has no room for a name: it is left out");
    else if (place && table.name.size() > place->byteCount())
        environment.warn("the name of the table is cut to " + std::to_string(place->byteCount())
            + " bytes: " + table.name);
    return encodeTamTable(table, persistent, profile->layout);
}

Result<Bytes> encodeAs(Environment& environment, const ConvertOptions& options,
    const TableFamily& format, const CalibrationData& data, bool persistent)
{
    if (&format == &tamTableFamily())
        return encodeTable(environment, options, data.tables.front(), persistent);
    const std::string text = writeCalibrationCsv(data);
    const ByteView view = asBytes(text);
    return Bytes(view.begin(), view.end());
}

Result<ExitCode> runConvert(Environment& environment, const ConvertOptions& options)
{
    const Output output{options.output, options.input.command};
    const auto to = outputFamily(options.output, options.to);
    if (!to)
        return fail(to.error());
    const FamilyFacts& format = (*to)->facts;
    if (auto possible = checkOutput(environment, output, format.isText); !possible)
        return fail(possible.error());
    if ((options.persistent || options.isVolatile) && !format.holdsPersistency)
        return wrongUsage(std::string(format.name) + " cannot say whether a table is persistent",
            options.input.command);
    auto input = readInput(environment, options.input);
    if (!input)
        return fail(input.error());
    auto data = chosenTables(std::move(*input->data), options, format);
    if (!data)
        return fail(data.error());
    const bool persistent = options.persistent || (input->persistent && !options.isVolatile);
    auto bytes = encodeAs(environment, options, **to, *data, persistent);
    if (!bytes)
        return fail(bytes.error());
    if (auto written = writeOutput(environment, output, *bytes); !written)
        return fail(written.error());

    Json tables = Json::array();
    for (const CompensationTable& table : data->tables)
        tables.push_back(toJson(table));
    environment.document({{"input", options.input.file}, {"output", options.output},
        {"from", input->family->facts.name}, {"to", format.name},
        {"dimensions", data->grid.dimensions()}, {"axes", toJson(data->grid)},
        {"tables", std::move(tables)}, {"persistent", persistent && format.holdsPersistency},
        {"bytes", bytes->size()}});
    if (!output.isStandardOutput())
        environment.print("Wrote " + options.output + ": " + std::string(format.name) + ", "
            + plural(data->tables.size(), "table", "tables") + ", "
            + plural(data->grid.pointCount(), "point", "points") + ", "
            + plural(bytes->size(), "byte", "bytes") + ".\n");
    return ExitCode::Done;
}

} // namespace

void addConvertCommand(CommandLine& line)
{
    auto options = std::make_shared<ConvertOptions>();
    options->input.command = commandName("convert");
    CLI::App* command = line.add("convert", fileCommands, "Turn a table file into another format",
        [options](Environment& environment) { return runConvert(environment, *options); });
    command->add_option("IN", options->input.file, "File to read; - for standard input")
        ->required();
    command
        ->add_option(
            "OUT", options->output, "File to write, replaced if it exists; - for standard output")
        ->required();
    addDimensionsOption(*command, options->input);
    addTableOption(*command, options->input);
    addFromOption(*command, options->input);
    command->add_option("--to", options->to, "Format of the output, if its name does not tell")
        ->option_text("FORMAT");
    CLI::Option* persistent = command->add_flag(
        "--persistent", options->persistent, "Mark the table persistent: the drive stores it");
    command
        ->add_flag("--volatile", options->isVolatile,
            "Mark the table volatile (without either: as the input is)")
        ->excludes(persistent);
    command->add_option("--name", options->name, "Name of the table")->option_text("TEXT");
    addProfileOption(*command, options->input.profile);
    command->footer("Example:\n"
                    "  axiscomp convert x.csv x.TAMtbl --dims 1 --table 2 --persistent");
}

} // namespace axiscomp::app
