// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/wizard_options.h"
#include "ui/controller/wizard_task.h"

#include <array>
#include <cstddef>
#include <optional>

namespace axiscomp::ui {

/// Everything that decides what can be done now, as plain values.
struct WizardSnapshot {
    // The way to the axis
    bool hasDrives = false; ///< at least one connection is set up
    bool isConnecting = false; ///< some drive has not answered yet, and none is known to be lost
    bool hasAxis = false; ///< one is chosen
    bool isConnected = false; ///< its drive answers
    bool hasCompensation = true; ///< the drive has compensation registers for it
    bool isKnown = false; ///< it has been read
    std::optional<Error> readProblem; ///< why it cannot be read

    // What the drive says
    bool isActive = false; ///< Active or Ramping
    bool isEvaluating = false;
    std::optional<Error> problem; ///< the compensation's own
    bool isHomed = false;
    bool hasDriveTable = false;
    bool hasBackup = false;
    enum class Unfinished { None, Old, Unsaved, Mixture } unfinished = Unfinished::None;
    std::optional<Error> finishObstacle; ///< why an unfinished write cannot be finished
    std::optional<Error> undoObstacle;
    int flashOperationsLeft = 0;
    int flashWaitSeconds = 0;
    bool isFlashLimitKnown = true;

    // What the user has chosen
    bool isChanged = false;
    int dimensionality = 1;
    int missingSource = 0; ///< the first dimension without one; 0: none is missing
    int repeatedSource = 0; ///< the second dimension with the same one; 0: none
    bool isSourceBeingChecked = false;
    bool hasTable = false;
    int tableDimensions = 0;
    std::size_t tableBytes = 0;
    std::size_t largestSlotBytes = 0;
    bool isNewTable = false; ///< of the file, not the one on the drive
    bool isPersistent = false;
    int flashOperationsNeeded = 0;
    int fileTables = 0; ///< columns of the open file
    int usableAxes = 0; ///< of the current axis's drive

    // What runs
    bool isReadingFile = false;
    std::optional<Task> task;
    bool canCancel = false;
};

struct WizardDecision {
    std::array<ActionState, allActions.size()> actions;
    QString hint; ///< the one sentence that matters most

    [[nodiscard]] const ActionState& operator[](Action action) const
    {
        return actions[static_cast<std::size_t>(action)];
    }
    friend bool operator==(const WizardDecision&, const WizardDecision&) = default;
};

/// spec/wizard.md, "Buttons and their reasons": a pure function. Exactly one reason each, never an
/// empty one.
[[nodiscard]] WizardDecision decide(const WizardSnapshot& now);

} // namespace axiscomp::ui
