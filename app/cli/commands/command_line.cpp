// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"

#include "app/common/arguments.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

constexpr const char* versionFlag = "--version";

} // namespace

CommandLine::CommandLine(std::string_view only) : m_parser(programDescription(), "axiscomp")
{
    setHelpStyle(m_parser);
    m_parser.set_version_flag(
        versionFlag, "axiscomp " AXISCOMP_VERSION, AXISCOMP_HELP("Help", "Show the version"));
    m_parser.require_subcommand(1);
    const auto isWanted = [only](const CommandGroup& group) {
        return !only.empty() && std::ranges::find(group.names, only) != group.names.end();
    };
    const auto groups = commandGroups();
    const bool wantsAll = only != versionFlag && std::ranges::none_of(groups, isWanted);
    for (const CommandGroup& group : groups)
        if (wantsAll || isWanted(group))
            group.add(*this);
    // Last, as commands take over what is there when they are added.
    m_parser.footer(programFooter());
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
