// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/program.h"
#include "app/common/system_process.h"

int main(int argc, char** argv)
{
    axiscomp::app::ProgramArguments arguments(argc, argv);
    return axiscomp::app::runProgram(arguments.count(), arguments.values());
}
