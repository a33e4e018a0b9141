// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/wizard_task.h"

#include "ui/controller/wizard_controller.h"

namespace axiscomp::ui {

QString taskText(Task task)
{
    switch (task) {
    case Task::Plan:
        return WizardController::tr("planning");
    case Task::Write:
        return WizardController::tr("writing");
    case Task::WriteSeveral:
        return WizardController::tr("writing several axes");
    case Task::Activate:
        return WizardController::tr("activating");
    case Task::Evaluate:
        return WizardController::tr("evaluating");
    case Task::Deactivate:
        return WizardController::tr("deactivating");
    case Task::Finish:
        return WizardController::tr("finishing the write");
    case Task::Undo:
        return WizardController::tr("undoing the write");
    case Task::Restore:
        break;
    }
    return WizardController::tr("restoring");
}

} // namespace axiscomp::ui
