// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace axiscomp::app {

/// What a program returns to the shell (docs/cli.md, "Exit codes"). OtherFailure:
/// something on this computer failed, such as a full disk.
enum class ExitCode : int {
    Done = 0,
    OtherFailure = 1,
    Usage = 2,
    InputFile = 3,
    DriveRefused = 4,
    NoConnection = 5,
    ReadBackDiffers = 6,
    FlashWear = 7,
    ToleranceNotMet = 8, ///< failed, undecided or not defined (judge)
    Differs = 9, ///< the drives have something else than the machine file says (plan)
    ProblemsFound = 10, ///< on this computer, or with a drive (doctor)
    Stopped = 130,
};

/// The one place that says which error ends a program with which code.
[[nodiscard]] ExitCode exitCode(ErrorCode code);

} // namespace axiscomp::app
