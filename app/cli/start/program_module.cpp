// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/start/program_module.h"

#include "app/cli/program.h"

extern "C" __attribute__((visibility("default"))) int axiscompProgram(int argc, char** argv)
{
    return axiscomp::app::runProgram(argc, argv);
}
