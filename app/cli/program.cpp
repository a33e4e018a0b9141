// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/program.h"

#include "app/cli/commands/command_line.h"
#include "app/cli/output/json_output.h"
#include "app/common/arguments.h"
#include "app/common/guarded_program.h"

#include <algorithm>
#include <span>
#include <string_view>

namespace axiscomp::app {

namespace {

ExitCode reportError(Console& console, const Error& error, bool json, const Json& diagnostics)
{
    console.clearProgress();
    if (json)
        console.print(dump({{"error", toJson(error, diagnostics)}}));
    return noteError(console, error);
}

/// What parsing did not come far enough to see.
bool asksForJson(int argc, char** argv)
{
    return std::ranges::any_of(std::span(argv, static_cast<std::size_t>(argc)),
        [](std::string_view argument) { return argument == "--json"; });
}

/// What decides which command it is; nothing where more follows than that.
std::string_view firstWord(int argc, char** argv)
{
    const std::string_view word = argc > 1 ? argv[1] : "";
    return word.starts_with('-') && argc > 2 ? std::string_view() : word;
}

ExitCode runCommand(Console& console, const CommandLine& line)
{
    Interrupt interrupt;
    Environment environment(console, interrupt, line.json());
    const Result<ExitCode> outcome = line.chosen()(environment);
    if (!console.flush())
        environment.noteReports();
    if (outcome)
        return *outcome;
    return reportError(console, outcome.error(), line.json(), environment.diagnostics());
}

ExitCode run(int argc, char** argv, Console& console)
{
    CommandLine line(firstWord(argc, argv));
    const Result<bool> proceed = parseArguments(line.parser(), argc, argv, console);
    if (!proceed)
        return reportError(console, proceed.error(), asksForJson(argc, argv), Json::array());
    const ExitCode code = *proceed ? runCommand(console, line) : ExitCode::Done;
    const Result<void> flushed = console.flush();
    if (flushed || code != ExitCode::Done)
        return code;
    return reportError(console, flushed.error(), false, Json::array());
}

} // namespace

EmbeddedEnd runEmbedded(const std::vector<std::string>& arguments, Interrupt& interrupt,
    const EmbeddedTakers& takers, const Environment::Names& names)
{
    Console console(takers.output, takers.notes);
    Environment environment(console, interrupt, takers.documents, takers.readings);
    environment.callFiles(names);
    std::vector<std::string> words{"axiscomp"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    const int count = static_cast<int>(pointers.size());
    CommandLine line(firstWord(count, pointers.data()));
    const Result<bool> proceed = parseArguments(line.parser(), count, pointers.data(), console);
    Result<ExitCode> outcome = ExitCode::Done;
    if (!proceed)
        outcome = fail(proceed.error());
    else if (*proceed)
        outcome = line.chosen()(environment);
    static_cast<void>(console.flush()); // to a taker, which cannot fail
    if (outcome)
        return {*outcome, {}, environment.told(), environment.diagnostics()};
    return {exitCode(outcome.error().code), outcome.error(), {}, environment.diagnostics()};
}

int runProgram(int argc, char** argv)
{
    return runGuarded([&](Console& console) { return static_cast<int>(run(argc, argv, console)); });
}

} // namespace axiscomp::app
