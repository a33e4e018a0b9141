// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"

namespace axiscomp::app {

namespace {

constexpr std::array groups{CommandGroup{{"example"}, addExampleCommand},
    CommandGroup{{"inspect"}, addInspectCommand}, CommandGroup{{"convert"}, addConvertCommand},
    CommandGroup{{"lookup"}, addLookupCommand}, CommandGroup{{"formats"}, addFormatsCommand},
    CommandGroup{{"targets"}, addTargetsCommand}, CommandGroup{{"runs"}, addRunsCommand},
    CommandGroup{{"judge"}, addJudgeCommand}, CommandGroup{{"fit"}, addFitCommand},
    CommandGroup{{"compare"}, addCompareCommand}};

} // namespace

// Without translations, which need Qt.

const char* programDescription()
{
    return "Makes, checks and converts compensation tables for measured axis errors. This program "
           "is built without drives.";
}

const char* programFooter()
{
    return "`axiscomp COMMAND --help` has more.";
}

std::span<const CommandGroup> commandGroups()
{
    return groups;
}

} // namespace axiscomp::app
