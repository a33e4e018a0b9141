// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"

namespace axiscomp::app {

namespace {

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

const char* programDescription()
{
    return AXISCOMP_HELP("Help",
        "Writes compensation tables for measured axis errors to a servo drive, "
        "activates them, and checks the drive's output against the table.");
}

const char* programFooter()
{
    return AXISCOMP_HELP("Help",
        "ENDPOINT is http://host[:port], https://host[:port], serial:DEVICE[?baud=N] or demo: (a "
        "virtual drive inside the program). AXISCOMP_DRIVE is the default of --drive. `axiscomp "
        "COMMAND --help` has more.");
}

std::span<const CommandGroup> commandGroups()
{
    return groups;
}

} // namespace axiscomp::app
