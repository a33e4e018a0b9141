// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/program.h"

#include "app/cli/command_line.h"
#include "app/cli/json_output.h"
#include "app/common/arguments.h"

#include <algorithm>
#include <exception>
#include <span>
#include <string_view>

namespace axiscomp::app {

namespace {

void reportError(Console& console, const Error& error, bool json, const Json& diagnostics)
{
    console.clearProgress();
    if (json)
        console.print(dump({{"error", toJson(error, diagnostics)}}));
    console.note("error: " + std::string(errorName(error.code)) + ": " + sentence(error));
}

/// What parsing did not come far enough to see.
bool asksForJson(int argc, char** argv)
{
    return std::ranges::any_of(std::span(argv, static_cast<std::size_t>(argc)),
        [](std::string_view argument) { return argument == "--json"; });
}

ExitCode runCommand(Console& console, const CommandLine& line)
{
    Interrupt interrupt;
    Environment environment(console, interrupt, line.json());
    const Result<ExitCode> outcome = line.chosen()(environment);
    if (outcome)
        return *outcome;
    reportError(console, outcome.error(), line.json(), environment.diagnostics());
    return exitCode(outcome.error().code);
}

ExitCode run(int argc, char** argv, Console& console)
{
    CommandLine line;
    const Result<bool> proceed = parseArguments(line.parser(), argc, argv, console);
    if (!proceed) {
        reportError(console, proceed.error(), asksForJson(argc, argv), Json::array());
        return exitCode(proceed.error().code);
    }
    const ExitCode code = *proceed ? runCommand(console, line) : ExitCode::Done;
    const Result<void> flushed = console.flush();
    if (flushed || code != ExitCode::Done)
        return code;
    reportError(console, flushed.error(), false, Json::array());
    return exitCode(flushed.error().code);
}

} // namespace

int runProgram(int argc, char** argv)
{
    Console console;
    try {
        return static_cast<int>(run(argc, argv, console));
    } catch (const std::exception& exception) {
        // Nothing is expected to throw but a computer without memory.
        console.note("error: Internal: " + std::string(exception.what()));
        return static_cast<int>(ExitCode::OtherFailure);
    }
}

} // namespace axiscomp::app
