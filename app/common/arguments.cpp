// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::app {

namespace {

constexpr std::size_t helpWidth = 100;
constexpr std::size_t helpIndent = 2;
constexpr std::size_t nameWidth = 24;

/// Breaks text at blanks so that no line goes beyond the width; lines after the first are indented.
std::string wrapped(std::string_view text, std::size_t indent)
{
    std::string result;
    std::size_t column = indent;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        if (column > indent && column + 1 + end > helpWidth) {
            result += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            result += ' ';
            ++column;
        }
        result += text.substr(0, end);
        column += end;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

std::string helpLine(const std::string& name, const std::string& description)
{
    const std::size_t column = helpIndent + nameWidth;
    std::string line = std::string(helpIndent, ' ') + name;
    if (line.size() + 2 > column)
        line += "\n" + std::string(column, ' ');
    else
        line.resize(column, ' ');
    return line + wrapped(description, column) + "\n";
}

class HelpFormatter final : public CLI::Formatter {
public:
    HelpFormatter()
    {
        label("Positionals", "Arguments");
        label("OPTIONS", "options");
        label("SUBCOMMAND", "COMMAND");
        label("Usage", "usage");
    }

    std::string make_description(const CLI::App* app) const override
    {
        return wrapped(app->get_description(), 0) + "\n\n";
    }

    std::string make_option(const CLI::Option* option, bool isPositional) const override
    {
        std::string name = make_option_name(option, isPositional);
        // "-o,--output FILE" reads better as "-o, --output FILE".
        if (const auto comma = name.find(','); comma != std::string::npos)
            name.insert(comma + 1, " ");
        if (!isPositional && !option->get_option_text().empty())
            name += " " + option->get_option_text();
        return helpLine(name, option->get_description());
    }

    /// The text of an argument is how it looks in the usage line, where that is not its name.
    std::string make_option_usage(const CLI::Option* option) const override
    {
        return option->get_option_text().empty() ? option->get_name(true)
                                                 : option->get_option_text();
    }

    std::string make_subcommand(const CLI::App* command) const override
    {
        return helpLine(command->get_name(), command->get_description());
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
    if (error.get_name() == "RequiredError" && commandBeingRead(app) == app.get_name()) {
        const std::vector<std::string> rest = app.remaining();
        return rest.empty() ? "the command is missing" : "there is no command " + rest.front();
    }
    std::string text = error.what();
    // "--dims: 7 not in {1,2,3}"
    if (const auto place = text.find(" not in {"); place != std::string::npos)
        text.replace(place, 8, " is not one of ");
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

/// Every user of the computer can read the arguments of a running program.
void hidePassword(std::string_view argument, char* place)
{
    const std::size_t scheme = argument.find("://");
    const std::size_t at = argument.rfind('@');
    if (scheme == std::string_view::npos || at == std::string_view::npos)
        return;
    const std::size_t colon = argument.find(':', scheme + 3);
    if (colon < at)
        std::fill(place + colon + 1, place + at, '*');
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
    for (int i = 1; i < argc; ++i)
        hidePassword(argv[i], argv[i]);
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
