// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wizard/program.h"

int main(int argc, char** argv)
{
    return axiscomp::app::runWizard(argc, argv);
}
