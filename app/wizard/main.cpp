// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/system_process.h"
#include "app/wizard/program.h"

int main(int argc, char** argv)
{
    axiscomp::app::ProgramArguments arguments(argc, argv);
    return axiscomp::app::runWizard(arguments.count(), arguments.values());
}
