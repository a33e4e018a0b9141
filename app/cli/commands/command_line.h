// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "app/common/arguments.h"
#include "app/common/exit_codes.h"
#include "core/base/result.h"

#include <CLI/App.hpp>

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp::app {

/// One command, its options already read. The code is Done unless the command has reported a
/// failure itself.
using Command = std::function<Result<ExitCode>(Environment&)>;

/// The command line of axiscomp: collects the commands, and holds the one that was chosen.
class CommandLine {
public:
    /// only: the name of the command that alone is wanted, or --version for none; the options of
    /// the others then are not made, which is half of what a start takes. Anything else: all of
    /// them.
    explicit CommandLine(std::string_view only = {});

    /// A command with its --json. run is called after parsing, if this command was chosen; it keeps
    /// its options alive.
    CLI::App* add(const std::string& name, const std::string& group, const std::string& description,
        Command run);

    [[nodiscard]] CLI::App& parser() { return m_parser; }
    [[nodiscard]] const Command& chosen() const { return m_chosen; }
    [[nodiscard]] bool json() const { return m_json; }

private:
    CLI::App m_parser;
    Command m_chosen;
    bool m_json = false;
};

/// "axiscomp write", for hints to --help.
[[nodiscard]] std::string commandName(const std::string& command);

inline constexpr const char* fileCommands = AXISCOMP_HELP("Help", "Files on this computer");
inline constexpr const char* driveCommands = AXISCOMP_HELP("Help", "Drives");
inline constexpr const char* computerCommands = AXISCOMP_HELP("Help", "This computer");

/// What one function adds.
struct CommandGroup {
    std::array<std::string_view, 3> names;
    void (*add)(CommandLine& line);
};

/// The commands of this program, in the order of --help, and what stands above and below them:
/// all_commands.cpp; in a program that is built without drives, cli/without_drives/commands.cpp.
[[nodiscard]] std::span<const CommandGroup> commandGroups();
[[nodiscard]] const char* programDescription();
[[nodiscard]] const char* programFooter();

void addExampleCommand(CommandLine& line);
void addInspectCommand(CommandLine& line);
void addConvertCommand(CommandLine& line);
void addLookupCommand(CommandLine& line);
void addFormatsCommand(CommandLine& line);
void addTargetsCommand(CommandLine& line);
void addCaptureCommand(CommandLine& line);
void addRunsCommand(CommandLine& line);
void addJudgeCommand(CommandLine& line);
void addFitCommand(CommandLine& line);
void addCompareCommand(CommandLine& line);
void addReportCommand(CommandLine& line);
void addAxesCommand(CommandLine& line);
void addStatusCommand(CommandLine& line);
void addWriteCommand(CommandLine& line);
void addPersistencyCommands(CommandLine& line);
void addDeleteCommand(CommandLine& line);
void addActivationCommands(CommandLine& line);
void addReadCommand(CommandLine& line);
void addTransferCommands(CommandLine& line);
void addMonitorCommand(CommandLine& line);
void addBackupCommands(CommandLine& line);
void addRecoverCommand(CommandLine& line);
void addConfigCommand(CommandLine& line);
void addMachineCommands(CommandLine& line);
void addSnapshotCommand(CommandLine& line);
void addMetricsCommand(CommandLine& line);
void addDoctorCommand(CommandLine& line);

} // namespace axiscomp::app
