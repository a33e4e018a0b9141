// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace axiscomp::app {

/// The command line program axiscomp; returns its exit code.
int runProgram(int argc, char** argv);

} // namespace axiscomp::app
