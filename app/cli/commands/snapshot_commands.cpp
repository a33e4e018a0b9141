// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/output_file.h"
#include "app/cli/session/drive_search.h"
#include "app/cli/session/machine_run.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "app/common/standard_streams.h"
#include "core/base/parallel.h"
#include "core/compensator/drive_summary.h"
#include "core/io/local_file.h"
#include "core/machine/open_metrics.h"
#include "core/machine/snapshot.h"

#include <filesystem>
#include <memory>
#include <set>

namespace axiscomp::app {

namespace {

constexpr std::size_t mostAtOnce = 16;

struct SnapshotOptions {
    DriveOptions drive;
    std::string folder;
    std::string name;
};

struct MetricsOptions {
    MachineOptions machine; ///< without a file: drive.endpoints
    std::string output;
    bool proves = false;
};

Result<void> needDrives(const DriveOptions& options)
{
    if (!options.endpoints.empty())
        return {};
    return wrongUsage(
        "the drive is missing: give --drive http://host, or set AXISCOMP_DRIVE", options.command);
}

Result<DriveSnapshot> snapshotOf(
    Environment& environment, const DriveOptions& options, const std::string& endpoint)
{
    AXISCOMP_TRY(const auto session, CommandSession::open(environment, options, endpoint));
    return snapshotDrive(session->compensator(), session->profile(), session->storeRoot(),
        shownEndpoint(endpoint), session->quietOperation());
}

/// Not every error names the drive that it is of.
Error ofDrive(Environment& environment, const DriveOptions& options, std::size_t index, Error error)
{
    const std::string place = shownEndpoint(options.endpoints[index]);
    if (options.endpoints.size() > 1 && !place.empty() && error.code != ErrorCode::Cancelled)
        environment.console().note("note: there is no snapshot because of the drive at " + place);
    if (!place.empty())
        error.context.setIfMissing("endpoint", place);
    return error;
}

/// All of them, or none: a machine file without one of its drives would be another machine.
Result<std::vector<DriveSnapshot>> snapshotsOf(
    Environment& environment, const DriveOptions& options)
{
    std::vector<Result<DriveSnapshot>> taken(options.endpoints.size(), fail(ErrorCode::Cancelled));
    const QtRuntime runtime;
    forEachAtOnce(taken.size(), mostAtOnce, [&](std::size_t index) {
        taken[index] = snapshotOf(environment, options, options.endpoints[index]);
    });
    std::vector<DriveSnapshot> snapshots;
    for (std::size_t index = 0; index < taken.size(); ++index) {
        if (!taken[index])
            return fail(ofDrive(environment, options, index, std::move(taken[index]).error()));
        snapshots.push_back(*std::move(taken[index]));
    }
    return snapshots;
}

Result<ExitCode> runSnapshot(Environment& environment, const SnapshotOptions& options)
{
    AXISCOMP_CHECK(needDrives(options.drive));
    if (options.folder == standardStream)
        return wrongUsage(
            "a snapshot is a folder of several files: name one with -o", options.drive.command);
    AXISCOMP_TRY(auto drives, snapshotsOf(environment, options.drive));
    const std::size_t count = drives.size();
    AXISCOMP_TRY(const auto snapshot, joinSnapshots(options.name, std::move(drives)));
    const std::filesystem::path folder = pathFromText(options.folder);
    AXISCOMP_CHECK(saveSnapshot(snapshot, folder));
    Json files = Json::array();
    for (std::size_t n = 0; n < snapshot.tables(); ++n)
        files.push_back(snapshot.files[n].name);
    environment.document(
        {{"output", (folder / machineFileName).string()}, {"drives", count}, {"tables", files}});
    environment.print("Wrote " + (folder / machineFileName).string() + ": "
        + plural(count, "drive", "drives") + ", " + plural(snapshot.tables(), "table", "tables")
        + ".\n");
    return ExitCode::Done;
}

/// Addresses are labels: one that is there twice would give two samples of one name. One that is
/// none is a problem of its drive alone.
Result<void> checkEndpoints(const MetricsOptions& options, const MachineRun& run)
{
    std::set<std::string> known;
    for (const MachineDriveRun& drive : run.drives)
        if (!drive.endpoint.empty() && !known.insert(drive.endpoint).second)
            return wrongUsage(
                "the drive at " + drive.endpoint + " is named twice; name each drive once",
                options.machine.drive.command);
    return {};
}

/// The drives of the machine file and how they differ, or those of --drive.
Result<MachineRun> metricsRun(Environment& environment, const MetricsOptions& options)
{
    if (!options.machine.file.empty()) {
        AXISCOMP_TRY(auto run, beginMachineRun(environment, options.machine));
        AXISCOMP_CHECK(checkEndpoints(options, run));
        planMachine(environment, options.machine, run);
        return run;
    }
    AXISCOMP_CHECK(needDrives(options.machine.drive));
    MachineRun run;
    for (const std::string& endpoint : options.machine.drive.endpoints) {
        run.drives.emplace_back();
        run.drives.back().wanted.endpoint = endpoint;
        run.drives.back().endpoint = shownEndpoint(endpoint);
    }
    AXISCOMP_CHECK(checkEndpoints(options, run));
    return run;
}

Result<void> collect(Environment& environment, const MetricsOptions& options,
    const MachineDriveRun& drive, DriveMetrics& metrics)
{
    if (drive.problem)
        return fail(*drive.problem);
    AXISCOMP_TRY(const auto session,
        CommandSession::open(environment, options.machine.drive, drive.wanted.endpoint));
    AXISCOMP_TRY(metrics.summary,
        summarizeDrive(session->compensator(), session->storeRoot(), session->quietOperation()));
    for (const AxisSummary& row : metrics.summary->axes)
        if (options.proves && row.status && row.status->isOn())
            metrics.proofs.emplace(row.axis.index,
                session->compensator().prove(
                    row.axis.index, proofSamples, session->quietOperation()));
    if (drive.plan)
        addComparison(*drive.plan, metrics);
    return {};
}

void warnOfAxes(Environment& environment, const MachineDriveRun& drive)
{
    for (const AxisPlan& axis : drive.plan ? drive.plan->axes : std::vector<AxisPlan>())
        if (axis.problem)
            environment.warn(drive.endpoint + ", axis " + axis.name
                + ": cannot be compared with the machine file: "
                + singleLine(sentence(*axis.problem)));
}

/// A drive that does not answer is a metric, not an error.
Result<ExitCode> runMetrics(Environment& environment, const MetricsOptions& options)
{
    const Output output{options.output, options.machine.drive.command};
    AXISCOMP_CHECK(checkOutput(environment, output, true));
    const QtRuntime runtime;
    AXISCOMP_TRY(const auto run, metricsRun(environment, options));
    std::vector<DriveMetrics> metrics(run.drives.size());
    std::vector<Result<void>> collected(run.drives.size());
    forEachAtOnce(metrics.size(), mostAtOnce, [&](std::size_t index) {
        metrics[index].endpoint = run.drives[index].endpoint;
        collected[index] = collect(environment, options, run.drives[index], metrics[index]);
    });
    for (std::size_t index = 0; index < metrics.size(); ++index) {
        if (!collected[index])
            environment.warn(
                metrics[index].endpoint + ": " + singleLine(sentence(collected[index].error())));
        warnOfAxes(environment, run.drives[index]);
    }
    if (environment.stopToken().stop_requested())
        return fail(ErrorCode::Cancelled);
    AXISCOMP_CHECK(writeOutput(environment, output, asBytes(openMetrics(metrics))));
    environment.document({{"output", options.output}, {"drives", metrics.size()}});
    return ExitCode::Done;
}

} // namespace

void addSnapshotCommand(CommandLine& line)
{
    auto options = std::make_shared<SnapshotOptions>();
    options->drive.command = commandName("snapshot");
    CLI::App* command = line.add("snapshot", driveCommands,
        AXISCOMP_HELP("Help", "Write a machine file with all tables from running drives"),
        [options](Environment& environment) { return runSnapshot(environment, *options); });
    addDriveOptions(*command, options->drive, DriveCount::Several);
    command
        ->add_option("-o,--output", options->folder,
            AXISCOMP_HELP("Help",
                "Folder for machine.toml and the tables; files of the same names are replaced"))
        ->option_text("FOLDER")
        ->required();
    command->add_option("--name", options->name, AXISCOMP_HELP("Help", "Name of the machine"))
        ->option_text("TEXT");
    command->footer(AXISCOMP_HELP("Help",
        "Applied to drives with the same serial numbers and without tables, the file gives the "
        "same state, and a snapshot of them the same bytes.") "\n\n" AXISCOMP_HELP("Help",
        "Example:") "\n  axiscomp snapshot -o mill --drive http://192.168.1.20 --drive "
                    "http://192.168.1.21");
}

void addMetricsCommand(CommandLine& line)
{
    auto options = std::make_shared<MetricsOptions>();
    options->machine.drive.command = commandName("metrics");
    CLI::App* command = line.add("metrics", driveCommands,
        AXISCOMP_HELP("Help", "Print the states of drives as OpenMetrics text, for a collector"),
        [options](Environment& environment) { return runMetrics(environment, *options); });
    addDriveOptions(*command, options->machine.drive, DriveCount::Several);
    command
        ->add_option("--machine", options->machine.file,
            AXISCOMP_HELP("Help", "Machine file: its drives, and whether they differ from it"))
        ->option_text("FILE");
    command->add_flag("--prove", options->proves,
        AXISCOMP_HELP("Help", "Compare the outputs of active compensations with their tables now"));
    command
        ->add_option("-o,--output", options->output,
            AXISCOMP_HELP("Help", "File to write, whole or not at all; standard output without it"))
        ->option_text("FILE");
    command->footer(AXISCOMP_HELP(
        "Help", "Example:") "\n  axiscomp metrics --machine machine.toml \\"
                            "\n      -o /var/lib/prometheus/node-exporter/axiscomp.prom");
}

} // namespace axiscomp::app
