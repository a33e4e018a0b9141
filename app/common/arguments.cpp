// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::app {

namespace {

class HelpFormatter final : public CLI::Formatter {
public:
    HelpFormatter()
    {
        column_width(32);
        label("Positionals", "Arguments");
        label("OPTIONS", "options");
        label("SUBCOMMAND", "command");
        label("Usage", "usage");
    }

    std::string make_description(const CLI::App* app) const override
    {
        return app->get_description() + "\n\n";
    }

    /// "-o,--output FILE" reads better as "-o, --output FILE".
    std::string make_option_name(const CLI::Option* option, bool isPositional) const override
    {
        std::string name = CLI::Formatter::make_option_name(option, isPositional);
        if (const auto comma = name.find(','); comma != std::string::npos)
            name.insert(comma + 1, " ");
        return name;
    }
};

/// The command that was being read when parsing failed: "axiscomp write".
std::string commandBeingRead(const CLI::App& app)
{
    std::string name = app.get_name();
    const std::vector<const CLI::App*> commands =
        app.get_subcommands([](const CLI::App* command) { return command->parsed(); });
    return commands.empty() ? name : name + " " + commands.front()->get_name();
}

std::string readableReason(const CLI::App& app, const CLI::ParseError& error)
{
    if (error.get_name() == "RequiredError" && commandBeingRead(app) == app.get_name())
        return "the command is missing";
    std::string text = error.what();
    constexpr std::string_view theFollowing = "The following argument";
    if (text.starts_with(theFollowing))
        text.front() = 't';
    return text;
}

/// CLI11 takes -5 for a number and -.5 for an option.
std::string readableArgument(std::string argument)
{
    const bool isFraction = argument.size() > 2 && argument[0] == '-' && argument[1] == '.'
        && argument[2] >= '0' && argument[2] <= '9';
    if (isFraction)
        argument.insert(1, "0");
    return argument;
}

} // namespace

void setHelpStyle(CLI::App& app)
{
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_help_flag("-h,--help", "Show this help");
}

Result<bool> parseArguments(CLI::App& app, int argc, char** argv, Console& console)
{
    std::vector<std::string> reversed;
    for (int i = argc - 1; i > 0; --i)
        reversed.push_back(readableArgument(argv[i]));
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        console.print(app.help());
        return false;
    } catch (const CLI::CallForVersion& version) {
        console.print(std::string(version.what()) + "\n");
        return false;
    } catch (const CLI::ParseError& error) {
        return wrongUsage(readableReason(app, error), commandBeingRead(app));
    }
    return true;
}

tl::unexpected<Error> wrongUsage(const std::string& reason, const std::string& command)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", reason + " (see " + command + " --help)"}});
}

} // namespace axiscomp::app
