// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/start/quick_commands.h"

#include "app/cli/commands/command_line.h"
#include "core/text/wanted_languages.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

constexpr std::array groups{CommandGroup{{"example"}, addExampleCommand},
    CommandGroup{{"inspect"}, addInspectCommand}, CommandGroup{{"convert"}, addConvertCommand},
    CommandGroup{{"lookup"}, addLookupCommand}, CommandGroup{{"formats"}, addFormatsCommand},
    CommandGroup{{"targets"}, addTargetsCommand}, CommandGroup{{"runs"}, addRunsCommand},
    CommandGroup{{"judge"}, addJudgeCommand}};

} // namespace

bool isQuick(std::span<char* const> arguments)
{
    const std::string_view word = arguments.size() > 1 ? arguments[1] : "";
    const bool isKnown = std::ranges::any_of(groups, [word](const CommandGroup& group) {
        return std::ranges::find(group.names, word) != group.names.end();
    });
    return ((isKnown && !word.empty()) || (word == "--version" && arguments.size() == 2))
        && wantedLanguages().front() == "en";
}

// What is said of all commands is never asked of these.

const char* programDescription()
{
    return "";
}

const char* programFooter()
{
    return "";
}

std::span<const CommandGroup> commandGroups()
{
    return groups;
}

} // namespace axiscomp::app
