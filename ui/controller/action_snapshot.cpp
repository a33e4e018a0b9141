// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/activation.h"
#include "ui/controller/wizard_controller_p.h"
#include "ui/text/message_text.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace axiscomp::ui {

void WizardController::Private::snapshotDrive(ActionSnapshot& now) const
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
    snapshotUnfinished(now);
    const FlashBudget budget = flashBudget();
    now.flashOperationsLeft = budget.left;
    now.flashWaitSeconds = static_cast<int>(budget.wait.count());
    now.isFlashRecordLost = budget.isRecordLost;
    now.isFlashLimitKnown = budget.left != std::numeric_limits<int>::max();
    if (!status)
        return;
    now.isActive = status->isOn();
    now.isEvaluating = status->axis.state == CompensationState::Evaluating;
    now.isHomed = status->axis.isHomed;
    now.hasDriveTable = status->table.has_value();
    if (status->axis.state == CompensationState::Error)
        now.problem = compensationError(*status);
}

void WizardController::Private::snapshotUnfinished(ActionSnapshot& now) const
{
    using Held = AxisCompensator::UnfinishedOutcome;
    using Unfinished = ActionSnapshot::Unfinished;
    if (!unfinished || unfinished->outcome == Held::New)
        return;
    now.unfinished = unfinished->outcome == Held::Old ? Unfinished::Old
        : unfinished->outcome == Held::NewUnsaved     ? Unfinished::Unsaved
                                                      : Unfinished::Mixture;
    now.finishObstacle = unfinished->recovery.finishObstacle;
    now.undoObstacle = unfinished->recovery.undoObstacle;
}

void WizardController::Private::snapshotSetup(ActionSnapshot& now) const
{
    const EditedSetup& edited = setup.edited();
    now.isDirty = setup.isDirty();
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
    if (const auto table = now.isNewTable ? selectedTable().table : nullptr) {
        now.hasTable = true;
        now.tableDimensions = table->grid.dimensions();
        now.tableBytes = selectedTableBytes();
    } else if (!now.isNewTable && status && status->table) {
        now.hasTable = true;
        now.tableDimensions = status->table->grid.dimensions();
    }
    const bool storesOrErases =
        now.isNewTable ? now.isPersistent : setup.isDirty(Field::Persistency);
    now.flashOperationsNeeded = storesOrErases ? 1 : 0;
    const auto& data = file.file().data;
    now.fileTables = data ? static_cast<int>(data->tables.size()) : 0;
    now.usableAxes = static_cast<int>(usableAxes().size());
}

ActionSnapshot WizardController::Private::snapshot() const
{
    ActionSnapshot now;
    snapshotDrive(now);
    snapshotSetup(now);
    now.isReadingFile = file.file().isReading;
    now.task = task;
    now.canCancel = busy.canCancel;
    return now;
}

void WizardController::Private::update()
{
    const ActionSnapshot now = snapshot();
    if (now.flashWaitSeconds > 0 && !countdown.isActive())
        countdown.start();
    else if (now.flashWaitSeconds == 0)
        countdown.stop();
    ActionStates decided = decideActions(now);
    if (decided == decision)
        return;
    decision = std::move(decided);
    Q_EMIT q.actionsChanged();
}

void WizardController::Private::show(const std::function<Outcome()>& made)
{
    const Outcome shown = made();
    log(
        shown.isError ? LogLine::Kind::Error : LogLine::Kind::Information,
        [made] { return made().text; }, shown.detail);
    makeOutcome = made;
    if (shown.text == outcome.text && shown.isError == outcome.isError)
        return;
    outcome = shown;
    Q_EMIT q.outcomeChanged();
}

void WizardController::Private::refuse(const Wording& reason)
{
    show([reason] { return Outcome{reason(), true, {}}; });
}

void WizardController::Private::dismissOutcome()
{
    if (!std::exchange(makeOutcome, nullptr))
        return;
    outcome = {};
    Q_EMIT q.outcomeChanged();
}

void WizardController::Private::log(
    LogLine::Kind kind, const Wording& wording, const QString& detail)
{
    logLines.add(kind, wording, detail);
    Q_EMIT q.logged();
}

void WizardController::Private::logError(const Error& error)
{
    log(
        LogLine::Kind::Error, [error] { return errorText(error); }, errorOutcome(error).detail);
}

void WizardController::Private::retranslate()
{
    if (makeOutcome)
        outcome = makeOutcome();
    listDrives();
    nameAxes();
    Q_EMIT q.axesChanged();
    for (int dimension = 1; dimension <= 3; ++dimension) {
        if (sourceField(dimension).problem)
            Q_EMIT q.sourceChecked(dimension);
    }
    if (task) {
        busy.step = busyText();
        Q_EMIT q.busyChanged();
    }
    update();
}

} // namespace axiscomp::ui
