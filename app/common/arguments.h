// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/console.h"
#include "core/base/result.h"

#include <CLI/CLI.hpp>

namespace axiscomp::app {

/// Marks the description of a command or an option for translation: context and text. Other parts
/// of a help page are marked likewise (HelpPage).
#define AXISCOMP_HELP(context, text) text

/// The look of --help, in the language of the environment.
void setHelpStyle(CLI::App& app);

/// Reads the command line into the options of app; one that may be repeated takes one word each
/// time. True: go on. False: --help or --version was asked for and printed. Passwords in argv are
/// overwritten. Errors: InvalidArgument with a hint to the right --help.
[[nodiscard]] Result<bool> parseArguments(CLI::App& app, int argc, char** argv, Console& console);

/// InvalidArgument whose sentence ends in the same hint, for what only shows after parsing.
/// command: "axiscomp write"
[[nodiscard]] tl::unexpected<Error> wrongUsage(
    const std::string& reason, const std::string& command);

} // namespace axiscomp::app
