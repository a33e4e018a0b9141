// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/arguments.h"

#include "app/common/help_page.h"
#include "app/texts/program_texts.h"
#include "core/text/edit_distance.h"

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::app {

namespace {

/// Only when help is asked for are texts looked up.
class HelpFormatter final : public CLI::FormatterBase {
public:
    std::string make_help(
        const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override
    {
        const ProgramTexts texts(languageOfEnvironment());
        return HelpPage(texts).make_help(app, std::move(name), mode);
    }
};

/// The command whose arguments were being read when parsing failed; the program itself where there
/// was none.
const CLI::App& readCommand(const CLI::App& app)
{
    const std::vector<const CLI::App*> commands =
        app.get_subcommands([](const CLI::App* command) { return command->parsed(); });
    return commands.empty() ? app : *commands.front();
}

/// The same by name: "axiscomp write".
std::string commandBeingRead(const CLI::App& app)
{
    const CLI::App& command = readCommand(app);
    return &command == &app ? app.get_name() : app.get_name() + " " + command.get_name();
}

/// The first of the arguments that nothing takes. An option that the command knows is among them
/// only in front of the command, and behind --, where it is none.
std::string unexpectedArgument(const CLI::App& app, const std::vector<std::string>& words)
{
    constexpr std::string_view mark = "--";
    const std::vector<std::string> rest = app.remaining(true);
    const auto first = std::ranges::find_if(rest, [&](const auto& word) { return word != mark; });
    const std::string argument = first == rest.end() ? std::string(mark) : *first;
    const std::string option = argument.substr(0, argument.find('='));
    const CLI::App& command = readCommand(app);
    std::vector<std::string> known;
    for (const CLI::Option* const one : command.get_options())
        for (const std::string& name : one->get_lnames())
            known.push_back("--" + name);
    const bool isKnown = std::ranges::find(known, option) != known.end();
    const auto end = std::ranges::find(words, mark);
    const auto last = isKnown ? std::find(words.begin(), end, command.get_name()) : end;
    if (!argument.starts_with(mark) || std::find(words.begin(), last, argument) == last)
        return "nothing takes the argument " + argument;
    if (isKnown)
        return option + " is an option of " + command.get_name() + ": give it behind "
            + command.get_name();
    const auto nearest = std::ranges::min_element(
        known, {}, [&](const std::string& name) { return editDistance(option, name); });
    return "there is no option " + option
        + (nearest == known.end() ? std::string() : "; the nearest is " + *nearest);
}

std::string readableReason(
    const CLI::App& app, const std::vector<std::string>& words, const CLI::ParseError& error)
{
    if (error.get_name() == "RequiredError" && commandBeingRead(app) == app.get_name()) {
        const std::vector<std::string> rest = app.remaining();
        return rest.empty() ? "the command is missing" : "there is no command " + rest.front();
    }
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
        return unexpectedArgument(app, words);
    std::string text = error.what();
    // "--dims: 7 not in {1,2,3}"
    if (const auto place = text.find(" not in {"); place != std::string::npos)
        text.replace(place, 8, " is not one of ");
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

/// As CLI11 takes them, the last one first. Behind -- are no options: a file may be called as it
/// likes.
std::vector<std::string> reversedWords(std::span<char* const> words)
{
    const auto mark = std::ranges::find(words, std::string_view("--"));
    std::vector<std::string> reversed;
    for (auto word = words.begin(); word != words.end(); ++word)
        reversed.push_back(word < mark ? readableArgument(*word) : std::string(*word));
    std::ranges::reverse(reversed);
    return reversed;
}

/// CLI11 would give an option that may be repeated all the words behind it, a file or a position
/// among them.
void takeOneWordEach(CLI::App& app)
{
    for (CLI::Option* const option : app.get_options())
        if (option->nonpositional())
            option->allow_extra_args(false);
    for (CLI::App* const command : app.get_subcommands([](CLI::App*) { return true; }))
        takeOneWordEach(*command);
}

/// The command that the words name, before they are read: "axiscomp write".
std::string commandNamed(const CLI::App& app, std::span<char* const> words)
{
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        if (std::ranges::find(words, std::string_view(command->get_name())) != words.end())
            return app.get_name() + " " + command->get_name();
    return app.get_name();
}

/// CLI11 would take the word after it for the value of `--output=`: a file to be read was written.
Result<void> checkValues(const CLI::App& app, std::span<char* const> words)
{
    for (const std::string_view word : words) {
        if (word == "--")
            break;
        if (word.starts_with("--") && word.find('=') + 1 == word.size())
            return wrongUsage(
                std::string(word.substr(0, word.size() - 1)) + " has no value after the =",
                commandNamed(app, words));
    }
    return {};
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
    app.option_defaults()->group(AXISCOMP_HELP("Help", "Options"));
    app.set_help_flag("-h,--help", AXISCOMP_HELP("Help", "Show this help"));
}

Result<bool> parseArguments(CLI::App& app, int argc, char** argv, Console& console)
{
    const auto words = std::span<char* const>(argv, static_cast<std::size_t>(argc)).subspan(1);
    std::vector<std::string> reversed = reversedWords(words);
    const std::vector<std::string> asked(reversed.rbegin(), reversed.rend());
    for (char* const word : words)
        hidePassword(word, word);
    AXISCOMP_CHECK(checkValues(app, words));
    takeOneWordEach(app);
    try {
        app.parse(reversed);
    } catch (const CLI::CallForHelp&) {
        console.print(app.help());
        return false;
    } catch (const CLI::CallForVersion& version) {
        console.print(std::string(version.what()) + "\n");
        return false;
    } catch (const CLI::ParseError& error) {
        return wrongUsage(readableReason(app, asked, error), commandBeingRead(app));
    }
    return true;
}

tl::unexpected<Error> wrongUsage(const std::string& reason, const std::string& command)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", reason + " (see " + command + " --help)"}});
}

} // namespace axiscomp::app
