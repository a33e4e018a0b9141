// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reliability/faultmatrix/write_trial.h"

namespace axiscomp::test {

/// `axiscomp write` that is killed when the drive sees its N-th request.
struct KilledProgram {
    const WriteScenario* scenario = nullptr;
    AttachmentKind kind; ///< one that another program can use
    bool isRequestLost = false; ///< the request is the last one, or does not count any more
};

/// What the program does when it is left alone.
struct RecordedProgram {
    int requests = 0;
    HeldStates states;
    std::string wrong;
};
[[nodiscard]] RecordedProgram recordProgram(const KilledProgram& program);

/// Kills it, asks `axiscomp status`, and writes again. Gives what is wrong.
[[nodiscard]] std::string runKilled(
    const KilledProgram& program, const RecordedProgram& recorded, int request);

} // namespace axiscomp::test
