// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/system_process.h"
#include "app/virtualdrive/program.h"

int main(int argc, char** argv)
{
    axiscomp::app::ProgramArguments arguments(argc, argv);
    return axiscomp::app::runVirtualDrive(arguments.count(), arguments.values());
}
