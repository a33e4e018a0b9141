// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace axiscomp::app {

/// The program axiscomp-virtualdrive; returns its exit code.
int runVirtualDrive(int argc, char** argv);

} // namespace axiscomp::app
