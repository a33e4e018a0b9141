// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace axiscomp::app {

// All commands of axiscomp, which the program loads unless the command is a quick one.

inline constexpr const char* programModuleName = "axiscomp-program.so";
/// Its only function, of the type of runProgram().
inline constexpr const char* programModuleFunction = "axiscompProgram";
using ProgramModuleFunction = int (*)(int argc, char** argv);

} // namespace axiscomp::app
