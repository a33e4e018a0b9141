// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace axiscomp::ui {

/// What a busy controller is doing.
enum class Task {
    Plan,
    Write,
    WriteSeveral,
    Activate,
    Evaluate,
    Deactivate,
    Restore,
    Finish,
    Undo,
};

/// "writing", translated.
[[nodiscard]] QString taskText(Task task);

/// The drive would be left to a roll-back if the task were stopped.
[[nodiscard]] constexpr bool isWrite(Task task)
{
    return task == Task::Write || task == Task::WriteSeveral || task == Task::Restore
        || task == Task::Finish || task == Task::Undo;
}

} // namespace axiscomp::ui
