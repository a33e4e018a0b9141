// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "core/base/bytes.h"

#include <string>
#include <vector>

namespace axiscomp::app {

/// Where a command's result goes: a file, or standard output when the name is empty or "-".
struct Output {
    std::string file;
    std::string command; ///< "axiscomp read": for hints

    [[nodiscard]] bool isStandardOutput() const;
};

/// Errors: InvalidArgument when standard output cannot take it: it is a terminal and the bytes are
/// no text, or it is needed for --json. Meant to be asked before the work is done.
[[nodiscard]] Result<void> checkOutput(Environment& environment, const Output& output, bool isText);

/// A measurement cannot be taken again. Errors: InvalidArgument when the output is one of the
/// inputs, whatever it is called.
[[nodiscard]] Result<void> checkNoInput(
    const Output& output, const std::vector<std::string>& inputs);

/// Writes a file whole or not at all; an existing one is replaced. Errors: FileNotWritable.
[[nodiscard]] Result<void> writeOutput(
    Environment& environment, const Output& output, ByteView bytes);

} // namespace axiscomp::app
