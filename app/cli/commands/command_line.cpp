// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"

#include "app/common/arguments.h"

namespace axiscomp::app {

CommandLine::CommandLine()
    : m_parser(AXISCOMP_HELP("Help",
                   "Writes compensation tables for measured axis errors to a servo drive, "
                   "activates them, and checks the drive's output against the table."),
        "axiscomp")
{
    setHelpStyle(m_parser);
    m_parser.set_version_flag(
        "--version", "axiscomp " AXISCOMP_VERSION, AXISCOMP_HELP("Help", "Show the version"));
    m_parser.require_subcommand(1);
    addExampleCommand(*this);
    addInspectCommand(*this);
    addConvertCommand(*this);
    addLookupCommand(*this);
    addFormatsCommand(*this);
    addTargetsCommand(*this);
    addCaptureCommand(*this);
    addRunsCommand(*this);
    addJudgeCommand(*this);
    addFitCommand(*this);
    addCompareCommand(*this);
    addReportCommand(*this);
    addAxesCommand(*this);
    addStatusCommand(*this);
    addWriteCommand(*this);
    addPersistencyCommands(*this);
    addDeleteCommand(*this);
    addActivationCommands(*this);
    addReadCommand(*this);
    addTransferCommands(*this);
    addMonitorCommand(*this);
    addBackupCommands(*this);
    addRecoverCommand(*this);
    addConfigCommand(*this);
    addMachineCommands(*this);
    addSnapshotCommand(*this);
    addMetricsCommand(*this);
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
