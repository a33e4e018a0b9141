// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "app/common/exit_codes.h"
#include "core/base/error.h"

#include <optional>
#include <string>
#include <vector>

namespace axiscomp::app {

/// The command line program axiscomp; returns its exit code.
int runProgram(int argc, char** argv);

/// Who takes what a command says inside of another program. May be called on any thread.
struct EmbeddedTakers {
    Console::Taker output; ///< text for people, or the file whose name is "-"
    Console::Taker notes; ///< "warning: ...", one line each
    Environment::Taker documents; ///< that of --json
    Environment::Taker readings; ///< of monitor
};

/// How a command has ended.
struct EmbeddedEnd {
    ExitCode code = ExitCode::Done;
    std::optional<Error> error;
    std::optional<Error> told; ///< the first of those beside which there is a document
    Json diagnostics = Json::array(); ///< the places in files that are wrong
};

/// A command of axiscomp inside of another program, with the same rules. arguments: as on the
/// command line, from the name of the command on, without --json. Blocks. names: of files.
/// interrupt: leaves signals alone, and is used for one command only. Throws what runs out, such as
/// memory.
[[nodiscard]] EmbeddedEnd runEmbedded(const std::vector<std::string>& arguments,
    Interrupt& interrupt, const EmbeddedTakers& takers, const Environment::Names& names = {});

} // namespace axiscomp::app
