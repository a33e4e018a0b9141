// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/wizard_controller_p.h"

#include <algorithm>
#include <limits>

namespace axiscomp::ui {

void WizardController::Private::snapshotDrive(WizardSnapshot& now) const
{
    const DriveConnection* drive = connection();
    now.hasDrives = !connections.empty();
    now.isConnecting = std::ranges::any_of(drives, [](const DriveState& state) {
        return state.connection == DriveState::Connection::Connecting;
    });
    now.hasAxis = current.has_value();
    now.isConnected = drive && drive->isConnected();
    now.hasCompensation = hasCompensation;
    now.isKnown = status.has_value();
    now.readProblem = readProblem;
    now.hasBackup = hasBackup;
    if (unfinished == AxisCompensator::UnfinishedOutcome::NewUnsaved)
        now.unfinished = WizardSnapshot::Unfinished::Unsaved;
    if (unfinished == AxisCompensator::UnfinishedOutcome::Neither)
        now.unfinished = WizardSnapshot::Unfinished::Mixture;
    const FlashBudget budget = flashBudget();
    now.flashOperationsLeft = budget.left;
    now.flashWaitSeconds = static_cast<int>(budget.wait.count());
    now.isFlashLimitKnown = budget.left != std::numeric_limits<int>::max();
    if (!status)
        return;
    const RegisterEnums& names = profile.enums;
    const std::string& state = status->axis.state;
    now.isActive = state == names.stateActive || state == names.stateRamping;
    now.isEvaluating = state == names.stateEvaluating;
    now.isHomed = status->axis.homing == names.homingDone;
    now.hasDriveTable = status->table.has_value();
    if (state == names.stateError)
        now.problem = compensationProblem(*status);
}

void WizardController::Private::snapshotSetup(WizardSnapshot& now) const
{
    const EditedSetup& edited = setup.edited();
    now.isChanged = setup.isChanged();
    now.dimensionality = edited.dimensionality;
    for (int n = edited.dimensionality; n >= 1; --n) {
        const DimSource& source = edited.sources[static_cast<std::size_t>(n - 1)];
        if (!source.isSet())
            now.missingSource = n;
        const auto first = std::ranges::find(edited.sources, source);
        if (source.isSet() && first - edited.sources.begin() < n - 1)
            now.repeatedSource = n;
        if (sourceFields[static_cast<std::size_t>(n - 1)].isBeingChecked)
            now.isSourceBeingChecked = true;
    }
    for (const TableSlot& slot : profile.tableSlots)
        now.largestSlotBytes = std::max<std::size_t>(now.largestSlotBytes, slot.maximumSize);
    now.isPersistent = edited.persistency == Persistency::Persistent;
    now.isNewTable = edited.table.fileTable.has_value();
    if (const auto table = now.isNewTable ? selectedTable() : nullptr) {
        now.hasTable = true;
        now.tableDimensions = table->grid.dimensions();
        now.tableBytes = selectedTableBytes();
    } else if (!now.isNewTable && status && status->table) {
        now.hasTable = true;
        now.tableDimensions = status->table->grid.dimensions();
    }
    const bool storesOrErases =
        now.isNewTable ? now.isPersistent : setup.isChanged(Field::Persistency);
    now.flashOperationsNeeded = storesOrErases ? 1 : 0;
}

WizardSnapshot WizardController::Private::snapshot() const
{
    WizardSnapshot now;
    snapshotDrive(now);
    snapshotSetup(now);
    now.isReadingFile = file.file().isReading;
    now.isBusy = busy.isBusy;
    now.isWriting = task == Task::Write || task == Task::Restore;
    now.canCancel = busy.canCancel;
    if (task)
        now.operation = taskText(*task);
    return now;
}

void WizardController::Private::update()
{
    const WizardSnapshot now = snapshot();
    if (now.flashWaitSeconds > 0 && !countdown.isActive())
        countdown.start();
    else if (now.flashWaitSeconds == 0)
        countdown.stop();
    WizardDecision decided = decide(now);
    if (decided == decision)
        return;
    decision = std::move(decided);
    Q_EMIT q.actionsChanged();
}

void WizardController::Private::show(const Outcome& shown)
{
    if (!shown.text.isEmpty())
        log(shown.isError ? LogLine::Kind::Error : LogLine::Kind::Information, shown.text,
            shown.detail);
    if (shown.text == outcome.text && shown.isError == outcome.isError)
        return;
    outcome = shown;
    Q_EMIT q.outcomeChanged();
}

void WizardController::Private::log(LogLine::Kind kind, const QString& text, const QString& detail)
{
    logLines.add(kind, text, detail);
    Q_EMIT q.logged();
}

} // namespace axiscomp::ui
