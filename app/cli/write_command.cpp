// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"
#include "app/cli/table_input.h"
#include "app/cli/write_run.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"

#include <algorithm>
#include <array>

namespace axiscomp::app {

namespace {

struct WriteOptions {
    DriveOptions drive;
    TableInputOptions input;
    std::array<std::string, 3> sources;
    std::string slot;
    bool persistent = false;
    bool isVolatile = false;
    bool isDryRun = false;
};

bool sameLetters(const std::string& a, const std::string& b)
{
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

/// "small1" and "tables/small1.TAMtbl" are the slot Small1; the rest is judged by the compensator.
std::string slotName(const DriveProfile& profile, const std::string& text)
{
    const auto slot = std::ranges::find_if(profile.tableSlots, [&](const TableSlot& candidate) {
        return sameLetters(candidate.name, text) || candidate.file == text;
    });
    return slot == profile.tableSlots.end() ? text : slot->name;
}

/// Those that were given, from dimension 1 on. Errors: SourceMissing for a gap.
Result<std::vector<std::string>> givenSources(const WriteOptions& options)
{
    std::vector<std::string> sources;
    for (std::size_t n = 0; n < options.sources.size(); ++n) {
        if (options.sources[n].empty())
            continue;
        if (sources.size() < n)
            return fail(
                ErrorCode::SourceMissing, {{"dimension", std::to_string(sources.size() + 1)}});
        sources.push_back(options.sources[n]);
    }
    return sources;
}

Result<WriteRequest> requestOf(Environment& environment, const WriteOptions& options)
{
    WriteRequest request;
    auto sources = givenSources(options);
    if (!sources)
        return fail(sources.error());
    request.sources = std::move(*sources);
    if (options.persistent || options.isVolatile)
        request.persistency = options.persistent ? Persistency::Persistent : Persistency::Volatile;
    if (options.input.file.empty()) {
        if (request.sources.empty() && !request.persistency)
            return wrongUsage("there is nothing to write: give --data FILE, or a new --source1",
                options.drive.command);
        request.dimensionality = options.input.dimensions;
        return request;
    }
    TableInputOptions inputOptions = options.input;
    inputOptions.profile = options.drive.profile;
    auto input = readInput(environment, inputOptions);
    if (!input)
        return fail(input.error());
    const auto index = chooseTable(*input->data, inputOptions);
    if (!index)
        return fail(index.error());
    request.table = std::move(input->data->tables[*index]);
    request.dimensionality = request.table->grid.dimensions();
    return request;
}

Result<ExitCode> runWriteCommand(Environment& environment, const WriteOptions& options)
{
    // The file first: a bad one is said even when no drive is there.
    auto request = requestOf(environment, options);
    if (!request)
        return fail(request.error());
    return withAxis(environment, options.drive,
        [&](Environment& sameEnvironment, DriveSession& session, int axis) -> Result<ExitCode> {
            if (!options.slot.empty())
                request->slot = slotName(session.profile(), options.slot);
            if (request->dimensionality == 0) {
                const auto now = session.compensator().status(axis, session.operation());
                if (!now)
                    return fail(now.error());
                request->dimensionality = now->setup.dimensionality;
            }
            return runWrite(sameEnvironment, session, axis, *request, options.isDryRun);
        });
}

void addSourceOptions(CLI::App& command, WriteOptions& options)
{
    for (std::size_t n = 0; n < options.sources.size(); ++n) {
        const std::string number = std::to_string(n + 1);
        command
            .add_option("--source" + number, options.sources[n],
                "Register that looks up dimension " + number
                    + ": path, tam:// URI or address (0x1234)")
            ->option_text("REG");
    }
}

} // namespace

void addWriteCommand(CommandLine& line)
{
    auto options = std::make_shared<WriteOptions>();
    options->drive.command = commandName("write");
    options->input.command = options->drive.command;
    CLI::App* command = line.add("write", driveCommands,
        "Write a compensation table to an axis in the safe order, and verify it",
        [options](Environment& environment) { return runWriteCommand(environment, *options); });
    addDriveOptions(*command, options->drive);
    addAxisOption(*command, options->drive);
    command
        ->add_option("--data", options->input.file,
            "Calibration file (.csv) or table (.TAMtbl); without it the axis keeps its table")
        ->option_text("FILE");
    addDimensionsOption(*command, options->input);
    addTableOption(*command, options->input);
    addFromOption(*command, options->input);
    addSourceOptions(*command, *options);
    CLI::Option* persistent = command->add_flag("--persistent", options->persistent,
        "Keep the table in the drive's flash: it survives a reboot");
    command
        ->add_flag("--volatile", options->isVolatile,
            "Keep the table in memory until the next reboot (the default for a new table)")
        ->excludes(persistent);
    command
        ->add_option("--slot", options->slot,
            "Slot to use, small1 to small8, large1 or large2; chosen unless given")
        ->option_text("SLOT");
    command->add_flag("--dry-run", options->isDryRun, "Show what would be written, write nothing");
    command->footer(
        "Without --source1 the axis keeps its sources. The compensation stays off:\n"
        "`axiscomp activate` switches it on.\n\n"
        "Example:\n"
        "  axiscomp write --drive http://192.168.1.20 --axis X --data x.csv --dims 1 \\\n"
        "      --source1 'Axes[0]/Signals/PathPlanner/Position' --persistent");
}

void addPersistencyCommands(CommandLine& line)
{
    struct Row {
        const char* name;
        const char* description;
        Persistency persistency;
    };
    for (const Row& row :
        {Row{"persist", "Store the axis's table in the drive's flash: it survives a reboot",
             Persistency::Persistent},
            Row{"unpersist", "Make the axis's table volatile: gone after the next reboot",
                Persistency::Volatile}}) {
        auto options = std::make_shared<DriveOptions>();
        options->command = commandName(row.name);
        const Persistency persistency = row.persistency;
        CLI::App* command = line.add(row.name, driveCommands, row.description,
            [options, persistency](Environment& environment) {
                return withAxis(environment, *options,
                    [persistency](Environment& sameEnvironment, DriveSession& session,
                        int axis) -> Result<ExitCode> {
                        const auto now = session.compensator().status(axis, session.operation());
                        if (!now)
                            return fail(now.error());
                        if (!now->table)
                            return fail(ErrorCode::NoTable, {{"axis", std::to_string(axis)}});
                        WriteRequest request;
                        request.dimensionality = now->setup.dimensionality;
                        request.persistency = persistency;
                        return runWrite(sameEnvironment, session, axis, request, false);
                    });
            });
        addDriveOptions(*command, *options);
        addAxisOption(*command, *options);
    }
}

} // namespace axiscomp::app
