// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/conversion_options.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/output_file.h"
#include "app/cli/output/status_text.h"
#include "app/cli/session/command_session.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "core/compensator/table_of_axis.h"
#include "core/csv/calibration_csv.h"
#include "core/drive/axis_target.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/io/local_file.h"
#include "core/write/lookup_side.h"

#include <filesystem>

namespace axiscomp::app {

namespace {

struct ReadOptions {
    DriveOptions drive;
    std::string output;
    std::string to;
    ConversionOptions conversion;
};

struct ReadTable {
    CompensationTable table;
    Bytes file; ///< in the format that was asked for
};

/// A table file is handed out byte by byte as the drive has it.
Result<ReadTable> readAsTamTable(Environment& environment, CommandSession& session,
    const AxisStatus& status, const std::string& output)
{
    AXISCOMP_TRY(auto held, session.compensator().readHeldTable(status, session.operation()));
    AXISCOMP_CHECK(noteUnheld(environment, output, lookupNotes(status, session.profile())));
    return ReadTable{std::move(held.table), std::move(held.file)};
}

Result<ReadTable> readAsCsv(CommandSession& session, const AxisStatus& status)
{
    AXISCOMP_TRY(auto table, session.compensator().readDescribedTable(status, session.operation()));
    nameParts(table);
    CalibrationData data{table.grid, {table}, lookupNotes(status, session.profile())};
    data.notes.insert(data.notes.begin(),
        "read from " + driveWords(status.drive) + ", " + axisWords(status.axis) + ", slot "
            + status.setup.slot);
    const std::string text = writeCalibrationCsv(data);
    const ByteView view = asBytes(text);
    return ReadTable{std::move(table), Bytes(view.begin(), view.end())};
}

/// For another controller: what the axis uses, converted; the report goes to standard error.
Result<ReadTable> readAsOther(Environment& environment, CommandSession& session,
    const AxisStatus& status, const ReadOptions& options, const TableFormat& to)
{
    AXISCOMP_TRY(auto table, session.compensator().readDescribedTable(status, session.operation()));
    const NeutralTable tables[] = {neutralTable({table.grid, {table}, {}})};
    AXISCOMP_TRY(auto request,
        conversionRequest(options.conversion, tam_table::format(), to, table.grid.axes.size()));
    if (request.targets.empty() && !table.target.empty())
        request.targets = {table.target};
    request.lookupAt =
        lookupAtSources(session.profile(), status.axis.index, sourcePaths(status.setup));
    request.writing.layout = &session.profile().layout;
    request.writing.fileName = pathFromText(options.output).filename().string();
    AXISCOMP_TRY(const auto conversion, convertTables(tables, request));
    for (const Text& line : conversionReport(conversion, request))
        environment.console().note(options.output + ": " + line.english());
    const ByteView view = asBytes(conversion.written.bytes);
    return ReadTable{std::move(table), Bytes(view.begin(), view.end())};
}

Result<ExitCode> runRead(Environment& environment, const ReadOptions& options)
{
    const Output output{options.output, options.drive.command};
    const bool isUnnamed = output.isStandardOutput() && options.to.empty();
    const auto format = isUnnamed ? Result<const TableFormat*>(&calibration_csv::format())
                                  : outputFormat(options.output, options.to);
    if (!format)
        return fail(format.error());
    const FormatFacts& info = (*format)->facts;
    AXISCOMP_CHECK(checkOutput(environment, output, info.isText));
    const bool isOther = !isTriamec(**format);
    if (!isOther && options.conversion.isAnything())
        return wrongUsage("the table is handed out as the drive has it: convert it afterwards",
            options.drive.command);
    const auto read = [&](Environment& same, CommandSession& session,
                          int axis) -> Result<ExitCode> {
        AXISCOMP_TRY(
            const auto watched, session.compensator().watch(axis, {}, session.operation()));
        if (watched.journalProblem)
            warnOfJournal(same, *watched.journalProblem);
        const AxisStatus& status = watched.status;
        AXISCOMP_TRY(auto table,
            isOther ? readAsOther(same, session, status, options, **format)
                : *format == &tam_table::format()
                ? readAsTamTable(same, session, status, options.output)
                : readAsCsv(session, status));
        AXISCOMP_CHECK(writeOutput(environment, output, table.file));
        environment.document({{"output", options.output}, {"format", info.name},
            {"bytes", table.file.size()}, {"axes", toJson(table.table.grid)},
            {"table", toJson(table.table)}, {"status", toJson(status)}});
        if (!output.isStandardOutput())
            environment.print("Wrote " + options.output + ": the table of " + axisWords(status.axis)
                + " in " + status.setup.slot + ", "
                + plural(table.table.values.size(), "value", "values") + ".\n");
        return ExitCode::Done;
    };
    return withAxis(environment, options.drive, read);
}

} // namespace

void addReadCommand(CommandLine& line)
{
    auto options = std::make_shared<ReadOptions>();
    options->drive.command = commandName("read");
    CLI::App* command = line.add("read", driveCommands,
        AXISCOMP_HELP("Help", "Download the table that an axis uses"),
        [options](Environment& environment) { return runRead(environment, *options); });
    addDriveOptions(*command, options->drive);
    addAxisOption(*command, options->drive);
    command
        ->add_option("-o,--output", options->output,
            AXISCOMP_HELP("Help",
                "File to write, .csv, .TAMtbl or that of another controller; CSV on standard "
                "output "
                "without it"))
        ->option_text("FILE");
    command
        ->add_option("--to", options->to,
            AXISCOMP_HELP("Help", "Format of the output, if its name leaves it open"))
        ->option_text("FORMAT");
    options->conversion.command = options->drive.command;
    addTargetOption(*command, options->conversion);
    addResamplingOptions(*command, options->conversion);
    addOutputOptions(*command, options->conversion);
}

} // namespace axiscomp::app
