// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/input/table_input.h"
#include "app/cli/output/json.h"
#include "app/cli/output/output_file.h"
#include "app/cli/output/status_text.h"
#include "app/cli/session/write_run.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/compensator/configuration_transfer.h"
#include "core/io/local_file.h"

namespace axiscomp::app {

namespace {

struct ConfigOptions {
    DriveOptions drive;
    std::string action; ///< "show", "export", "import"
    std::string file;
    std::string from; ///< another configuration in place of a drive
    std::string output; ///< empty: the file itself
    std::string station;
    bool isDryRun = false;
    bool force = false;
};

std::string addressText(std::uint32_t address)
{
    return address == 0 ? "none" : "0x" + hexText(address);
}

Json parametersJson(const CompensationParameters& parameters)
{
    Json axes = Json::array();
    for (const AxisParameters& axis : parameters.axes)
        axes.push_back({{"axis", axis.axis}, {"unit", axis.unit},
            {"slot", axis.slot.empty() ? Json(nullptr) : Json(axis.slot)},
            {"sources", axis.sources}});
    return {{"name", parameters.name},
        {"serialNumber", parameters.serialNumber ? Json(*parameters.serialNumber) : Json(nullptr)},
        {"axes", std::move(axes)}};
}

std::string parametersText(const CompensationParameters& parameters)
{
    const std::string serial = parameters.serialNumber
        ? ", serial number " + std::to_string(*parameters.serialNumber)
        : "";
    const std::string head =
        (parameters.name.empty() ? "Station without a name" : parameters.name) + serial + "\n";
    if (parameters.axes.empty())
        return head + "  No axis has compensation parameters.\n";
    TextTable table({"axis", "unit", "table", "Dim1Source", "Dim2Source", "Dim3Source"});
    for (const AxisParameters& axis : parameters.axes)
        table.add({std::to_string(axis.axis), axis.unit, axis.slot.empty() ? "none" : axis.slot,
            addressText(axis.sources[0]), addressText(axis.sources[1]),
            addressText(axis.sources[2])});
    return head + table.text();
}

Result<ExitCode> runShow(Environment& environment, const ConfigOptions& options)
{
    AXISCOMP_TRY(const auto profile, profileOf(options.drive.profile));
    AXISCOMP_TRY(
        const auto configuration, loadTamConfiguration(pathFromText(options.file), options.file));
    Json stations = Json::array();
    for (const TamStation& station : configuration.stations) {
        AXISCOMP_TRY(const auto parameters, stationParameters(station, profile, options.file));
        environment.print(parametersText(parameters));
        stations.push_back(parametersJson(parameters));
    }
    environment.document({{"stations", std::move(stations)}});
    return ExitCode::Done;
}

/// Puts parameters into the configuration.
Result<ExitCode> exportParameters(Environment& environment, const ConfigOptions& options,
    const DriveProfile& profile, const CompensationParameters& parameters)
{
    AXISCOMP_TRY(
        const auto configuration, loadTamConfiguration(pathFromText(options.file), options.file));
    AXISCOMP_TRY(const auto index,
        stationFor(configuration.stations, options.file, parameters.serialNumber, options.station,
            options.force));
    const std::string_view before = asText(configuration.bytes);
    AXISCOMP_TRY(const auto after,
        withParameters(before, configuration.stations[index], parameters, profile, options.file));
    const std::string& file = options.output.empty() ? options.file : options.output;
    environment.print(parametersText(parameters));
    const bool isSame = before == after;
    const bool writes = !options.isDryRun && !(isSame && options.output.empty());
    if (writes) {
        AXISCOMP_CHECK(saveFile(pathFromText(file), asBytes(after)));
        environment.print("\nWrote " + file
            + (isSame ? ", the same: the configuration has all of this already.\n"
                      : ": only these registers have changed.\n"));
    } else {
        environment.print(isSame ? "\nThe configuration has all of this already.\n"
                                 : "\nNothing was written (--dry-run).\n");
    }
    environment.document({{"output", file}, {"parameters", parametersJson(parameters)},
        {"changed", !isSame}, {"written", writes}});
    return ExitCode::Done;
}

Result<ExitCode> runExport(Environment& environment, const ConfigOptions& options)
{
    if (options.from.empty())
        return withDrive(environment, options.drive,
            [&](Environment& same, CommandSession& session) -> Result<ExitCode> {
                AXISCOMP_TRY(const auto parameters,
                    driveParameters(
                        session.compensator(), session.storeRoot(), session.operation()));
                same.console().clearProgress();
                return exportParameters(same, options, session.profile(), parameters);
            });
    AXISCOMP_TRY(const auto profile, profileOf(options.drive.profile));
    AXISCOMP_TRY(const auto source, loadTamConfiguration(pathFromText(options.from), options.from));
    AXISCOMP_TRY(const auto target, loadTamConfiguration(pathFromText(options.file), options.file));
    const auto serial =
        target.stations.size() == 1 ? target.stations.front().serialNumber : std::nullopt;
    AXISCOMP_TRY(const auto index,
        stationFor(source.stations, options.from, serial, options.station, options.force));
    AXISCOMP_TRY(
        const auto parameters, stationParameters(source.stations[index], profile, options.from));
    return exportParameters(environment, options, profile, parameters);
}

Result<ExitCode> importParameters(
    Environment& environment, CommandSession& session, const ConfigOptions& options)
{
    AXISCOMP_TRY(
        const auto configuration, loadTamConfiguration(pathFromText(options.file), options.file));
    AXISCOMP_TRY(const auto drive, session.compensator().identify(session.operation()));
    AXISCOMP_TRY(const auto index,
        stationFor(configuration.stations, options.file, drive.serialNumber, options.station,
            options.force));
    AXISCOMP_TRY(const auto parameters,
        stationParameters(configuration.stations[index], session.profile(), options.file));
    AXISCOMP_TRY(const auto writes,
        parameterWrites(session.compensator(), session.profile(), parameters, session.operation()));
    environment.console().clearProgress();
    if (writes.empty())
        environment.print("The drive already has all of this.\n");
    std::vector<std::string> names;
    for (const AxisWrite& write : writes)
        names.push_back(std::to_string(write.axis));
    AXISCOMP_TRY(
        auto documents, writeSeveral(environment, session, writes, names, options.isDryRun));
    environment.document({{"writes", std::move(documents)}});
    return ExitCode::Done;
}

Result<ExitCode> runConfig(Environment& environment, const ConfigOptions& options)
{
    if (options.action == "show")
        return runShow(environment, options);
    if (options.action == "export")
        return runExport(environment, options);
    return withDrive(environment, options.drive, [&](Environment& same, CommandSession& session) {
        return importParameters(same, session, options);
    });
}

} // namespace

void addConfigCommand(CommandLine& line)
{
    auto options = std::make_shared<ConfigOptions>();
    options->drive.command = commandName("config");
    CLI::App* command = line.add("config", driveCommands,
        AXISCOMP_HELP("Help",
            "Compensation parameters of a TAM configuration: show them, take them from a drive, or "
            "bring them to one"),
        [options](Environment& environment) { return runConfig(environment, *options); });
    command
        ->add_option("ACTION", options->action,
            AXISCOMP_HELP("Help", "show, export (to the file) or import (from it)"))
        ->required()
        ->check(CLI::IsMember({"show", "export", "import"}));
    command->add_option("FILE", options->file, AXISCOMP_HELP("Help", "TAM configuration (.TAMcfg)"))
        ->required();
    addDriveOptions(*command, options->drive);
    command
        ->add_option("--from", options->from,
            AXISCOMP_HELP(
                "Help", "export: take the parameters from this configuration in place of a drive"))
        ->option_text("FILE");
    command
        ->add_option("-o,--output", options->output,
            AXISCOMP_HELP(
                "Help", "export: write this file instead, and leave the other one as it is"))
        ->option_text("FILE");
    command
        ->add_option("--station", options->station,
            AXISCOMP_HELP("Help",
                "Name or serial number of the station in the file; without it the one with the "
                "drive's "
                "serial number"))
        ->option_text("STATION");
    command->add_flag("--force", options->force,
        AXISCOMP_HELP("Help", "Accept a station with another serial number than the drive's"));
    command->add_flag("--dry-run", options->isDryRun,
        AXISCOMP_HELP("Help", "Show what would be written without writing it"));
    command->footer(AXISCOMP_HELP("Help",
        "Only the registers Table and Dim1Source to Dim3Source of the axes are read and written. "
        "Everything else in the file stays as it is, and tables stay on the drive. Importing never "
        "switches a compensation on.") "\n\n" AXISCOMP_HELP("Help",
        "Example:") "\n  axiscomp config export machine.TAMcfg --drive http://192.168.1.20"
                    "\n  axiscomp config import machine.TAMcfg --drive http://192.168.1.20 "
                    "--dry-run");
}

} // namespace axiscomp::app
