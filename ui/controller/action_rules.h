// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

#include <array>
#include <cstddef>
#include <optional>

namespace axiscomp::ui {

/// The page's actions. Each says why it cannot be done now.
enum class Action {
    Write,
    Activate,
    Evaluate,
    Deactivate,
    Revert,
    RestorePrevious,
    RestoreBackup, ///< one that the user has chosen
    DeleteTable, ///< that the axis uses
    FinishWrite, ///< one that did not end
    UndoWrite,
    Refresh,
    OpenData,
    WriteSeveral, ///< columns of the file, each to an axis of its own
    ImportConfiguration, ///< parameters of a TAM configuration to the drive
    ExportConfiguration, ///< the drive's parameters to a TAM configuration
    BackUpDrive, ///< all axes of it, to a file
    RestoreDrive,
    Cancel,
};
inline constexpr std::array allActions{Action::Write, Action::Activate, Action::Evaluate,
    Action::Deactivate, Action::Revert, Action::RestorePrevious, Action::RestoreBackup,
    Action::DeleteTable, Action::FinishWrite, Action::UndoWrite, Action::Refresh, Action::OpenData,
    Action::WriteSeveral, Action::ImportConfiguration, Action::ExportConfiguration,
    Action::BackUpDrive, Action::RestoreDrive, Action::Cancel};

struct ActionState {
    bool isEnabled = false;
    QString reason; ///< a translated sentence: why not, or what will happen
    friend bool operator==(const ActionState&, const ActionState&) = default;
};

/// What a busy controller is doing.
enum class Task {
    Plan,
    Write,
    WriteSeveral,
    Import, ///< of a TAM configuration
    BackUpDrive,
    RestoreDrive,
    Activate,
    Evaluate,
    Deactivate,
    Restore,
    Delete,
    Finish,
    Undo,
};

/// What a busy page shows.
struct BusyState {
    bool isBusy = false;
    QString step; ///< translated: "writing: verifying table"
    double fraction = 0.0;
    bool canCancel = false;
};

/// "writing", translated.
[[nodiscard]] QString taskText(Task task);

/// Writes that were planned together, one after the other.
[[nodiscard]] constexpr bool isMultiAxis(Task task)
{
    return task == Task::WriteSeveral || task == Task::Import || task == Task::RestoreDrive;
}

/// The drive would be left to a roll-back if the task were stopped.
[[nodiscard]] constexpr bool isWrite(Task task)
{
    return task == Task::Write || isMultiAxis(task) || task == Task::Restore || task == Task::Delete
        || task == Task::Finish || task == Task::Undo;
}

/// Everything that decides what can be done now, as plain values.
struct ActionSnapshot {
    // The way to the axis
    bool hasDrives = false; ///< at least one connection is set up
    bool isConnecting = false; ///< some drive has not answered yet, and none is known to be lost
    bool hasAxis = false; ///< one is chosen
    bool isConnected = false; ///< its drive answers
    bool hasCompensation = true; ///< the drive has compensation registers for it
    bool isKnown = false; ///< it has been read, and whether a write to it did not end
    std::optional<Error> readProblem; ///< why it, or the journal, cannot be read

    // What the drive says
    bool isActive = false; ///< Active or Ramping
    bool isEvaluating = false;
    std::optional<Error> problem; ///< the compensation's own
    bool isHomed = false;
    bool hasDriveTable = false;
    bool hasBackup = false;
    enum class Unfinished { None, Old, Unsaved, Mixture, Unknown } unfinished = Unfinished::None;
    bool isBackupUnread = false; ///< of the state before it: it can be neither finished nor undone
    std::optional<Error> finishObstacle; ///< why an unfinished write cannot be finished
    std::optional<Error> undoObstacle;
    int flashOperationsLeft = 0;
    int flashWaitSeconds = 0;
    bool isFlashRecordLost = false; ///< no operations are left, however long one waits
    bool isFlashLimitKnown = true;

    // What the user has chosen
    bool isDirty = false;
    int dimensionality = 1;
    int missingSource = 0; ///< the first dimension without one; 0: none is missing
    int repeatedSource = 0; ///< the second dimension with the same one; 0: none
    bool isSourceBeingChecked = false;
    /// The selected table was made for a position on the other side of the compensation, or for
    /// another drive.
    std::optional<Error> noteProblem;
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

struct ActionStates {
    std::array<ActionState, allActions.size()> actions;
    QString hint; ///< the one sentence that matters most

    [[nodiscard]] const ActionState& operator[](Action action) const
    {
        return actions[static_cast<std::size_t>(action)];
    }
    friend bool operator==(const ActionStates&, const ActionStates&) = default;
};

/// What the line under the buttons says (docs/user-guide.md): a pure function. Exactly one reason
/// each, never an empty one.
[[nodiscard]] ActionStates decideActions(const ActionSnapshot& now);

} // namespace axiscomp::ui
