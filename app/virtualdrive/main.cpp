// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/virtualdrive/program.h"

int main(int argc, char** argv)
{
    return axiscomp::app::runVirtualDrive(argc, argv);
}
