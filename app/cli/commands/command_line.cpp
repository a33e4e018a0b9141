// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"

#include "app/common/arguments.h"

#include <algorithm>
#include <array>

namespace axiscomp::app {

namespace {

constexpr const char* versionFlag = "--version";

/// What one function adds.
struct CommandGroup {
    std::array<std::string_view, 3> names;
    void (*add)(CommandLine& line);
};

/// In the order of the help.
constexpr std::array groups{CommandGroup{{"example"}, addExampleCommand},
    CommandGroup{{"inspect"}, addInspectCommand}, CommandGroup{{"convert"}, addConvertCommand},
    CommandGroup{{"lookup"}, addLookupCommand}, CommandGroup{{"formats"}, addFormatsCommand},
    CommandGroup{{"targets"}, addTargetsCommand}, CommandGroup{{"capture"}, addCaptureCommand},
    CommandGroup{{"runs"}, addRunsCommand}, CommandGroup{{"judge"}, addJudgeCommand},
    CommandGroup{{"fit"}, addFitCommand}, CommandGroup{{"compare"}, addCompareCommand},
    CommandGroup{{"report"}, addReportCommand}, CommandGroup{{"axes"}, addAxesCommand},
    CommandGroup{{"status"}, addStatusCommand}, CommandGroup{{"write"}, addWriteCommand},
    CommandGroup{{"persist", "unpersist"}, addPersistencyCommands},
    CommandGroup{{"delete"}, addDeleteCommand},
    CommandGroup{{"evaluate", "activate", "deactivate"}, addActivationCommands},
    CommandGroup{{"read"}, addReadCommand},
    CommandGroup{{"files", "upload", "download"}, addTransferCommands},
    CommandGroup{{"monitor"}, addMonitorCommand},
    CommandGroup{{"backup", "restore"}, addBackupCommands},
    CommandGroup{{"recover"}, addRecoverCommand}, CommandGroup{{"config"}, addConfigCommand},
    CommandGroup{{"plan", "apply"}, addMachineCommands},
    CommandGroup{{"snapshot"}, addSnapshotCommand}, CommandGroup{{"metrics"}, addMetricsCommand},
    CommandGroup{{"doctor"}, addDoctorCommand}};

} // namespace

CommandLine::CommandLine(std::string_view only)
    : m_parser(AXISCOMP_HELP("Help",
                   "Writes compensation tables for measured axis errors to a servo drive, "
                   "activates them, and checks the drive's output against the table."),
        "axiscomp")
{
    setHelpStyle(m_parser);
    m_parser.set_version_flag(
        versionFlag, "axiscomp " AXISCOMP_VERSION, AXISCOMP_HELP("Help", "Show the version"));
    m_parser.require_subcommand(1);
    const auto isWanted = [only](const CommandGroup& group) {
        return !only.empty() && std::ranges::find(group.names, only) != group.names.end();
    };
    const bool wantsAll = only != versionFlag && std::ranges::none_of(groups, isWanted);
    for (const CommandGroup& group : groups)
        if (wantsAll || isWanted(group))
            group.add(*this);
    // Last, as commands take over what is there when they are added.
    m_parser.footer(AXISCOMP_HELP("Help",
        "ENDPOINT is http://host[:port], https://host[:port] or demo: (a virtual drive inside the "
        "program). AXISCOMP_DRIVE is the default of --drive. `axiscomp COMMAND --help` has more."));
}

CLI::App* CommandLine::add(
    const std::string& name, const std::string& group, const std::string& description, Command run)
{
    CLI::App* command = m_parser.add_subcommand(name, description);
    command->group(group);
    command->add_flag(
        "--json", m_json, AXISCOMP_HELP("Help", "Print one JSON document on standard output"));
    command->callback([this, run = std::move(run)] { m_chosen = run; });
    return command;
}

std::string commandName(const std::string& command)
{
    return "axiscomp " + command;
}

} // namespace axiscomp::app
