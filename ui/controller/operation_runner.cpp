// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "ui/controller/wizard_controller_p.h"
#include "ui/session/axis_list.h"
#include "ui/text/message_text.h"

#include <algorithm>
#include <utility>

namespace axiscomp::ui {

namespace {

/// All sources, so that those of dimensions that are no longer chosen are taken away.
WriteRequest requestFor(const EditedSetup& edited, const CompensationSetup& baseline)
{
    WriteRequest request;
    request.dimensionality = edited.dimensionality;
    for (std::size_t n = 0; n < static_cast<std::size_t>(edited.dimensionality); ++n)
        request.sources.push_back(requestedSource(edited.sources[n]));
    request.persistency = edited.persistency;
    request.expected = baseline;
    return request;
}

/// Copies the table on the session's thread: it may be large.
WriteRequest withTable(WriteRequest request, const std::shared_ptr<const CompensationTable>& table)
{
    if (table)
        request.table = *table;
    return request;
}

} // namespace

template <typename T>
void WizardController::Private::begin(
    Task started, DriveSession::Operation<T> operation, std::function<void(const Result<T>&)> end)
{
    DriveConnection* drive = connection();
    startTask(started);
    taskConnection = drive;
    taskStop = std::stop_source();
    whenDone(drive->session().run<T>(std::move(operation), taskStop.get_token()), &q,
        [this, drive, end = std::move(end)](const Result<T>& result) {
            if (taskConnection != drive)
                return; // its drive has been removed meanwhile
            endTask();
            end(result);
            update();
        });
    update();
}

void WizardController::Private::startTask(Task started)
{
    task = started;
    // What was read before would arrive as if it were read afterwards.
    ++reading;
    live.pause();
    driveTable.interrupt();
    taskStep.clear();
    busy = {true, busyText(), 0.0, true};
    log(LogLine::Kind::Information,
        [started, entry = axes.at(static_cast<std::size_t>(currentIndex))] {
            return started == Task::WriteSeveral
                ? tr("Begin: %1, %2.", "task and drive").arg(taskText(started), entry.driveName)
                : tr("Begin: %1 %2.").arg(taskText(started), axisLabel(entry));
        });
    dismissOutcome();
    Q_EMIT q.busyChanged();
}

void WizardController::Private::endTask()
{
    task.reset();
    taskConnection.clear();
    busy = {};
    live.resume();
    Q_EMIT q.busyChanged();
    update();
}

void WizardController::Private::showProgress(
    DriveConnection* of, const QString& step, double fraction)
{
    if (!task || taskConnection != of)
        return;
    taskStep = step;
    busy.step = busyText();
    busy.fraction = fraction;
    Q_EMIT q.busyChanged();
}

QString WizardController::Private::busyText() const
{
    if (!taskStep.isEmpty() && task == Task::WriteSeveral)
        return tr("%1: %2, %3", "task, axis and step")
            .arg(taskText(*task),
                axisNameOnDrive(
                    multiAxis.axes.at(std::min(multiAxis.turn->load(), multiAxis.axes.size() - 1))),
                stepText(taskStep));
    if (!taskStep.isEmpty())
        return tr("%1: %2").arg(taskText(*task), stepText(taskStep));
    const bool isStopping = busy.isBusy && !busy.canCancel;
    return isStopping ? tr("%1: stopping").arg(taskText(*task)) : taskText(*task);
}

/// Who asks for what cannot be done now is told why.
bool WizardController::Private::mayStart(Action action)
{
    update();
    const bool may = decision[action].isEnabled;
    if (!may)
        refuse([now = snapshot(), action] { return decideActions(now)[action].reason; });
    return may;
}

void WizardController::Private::planWrite()
{
    if (!mayStart(Action::Write))
        return;
    plan.reset();
    const EditedSetup& edited = setup.edited();
    plannedSetup = edited;
    request = requestFor(edited, setup.baseline());
    requestTable = edited.table.fileTable ? file.table(*edited.table.fileTable) : LoadedTable{};
    if (!setup.isDirty()) {
        // Only an earlier write is finished: its parameters are saved.
        request.sources.clear();
        request.persistency = Persistency::Persistent;
    }
    begin<WritePlan>(
        Task::Plan,
        [axis = current->axis, asked = request, table = requestTable.table](
            AxisCompensator& compensator, const OperationOptions& operation) {
            return compensator.plan(axis, withTable(asked, table), operation);
        },
        [this](const Result<WritePlan>& result) { planned(result); });
}

void WizardController::Private::planned(const Result<WritePlan>& result)
{
    if (!result) {
        show([error = result.error()] { return errorOutcome(error); });
        if (isLinkFailure(result.error().code))
            axisFailed(result.error());
        else
            readAxisNow();
        return;
    }
    if (!(setup.edited() == plannedSetup)) {
        refuse(
            [] { return tr("The fields were changed while the write was planned: write again."); });
        return;
    }
    plan = *result;
    Q_EMIT q.planReady();
}

void WizardController::Private::write()
{
    if (!mayStart(Action::Write))
        return;
    if (!plan) {
        refuse([] {
            return tr(
                "The drive or the fields have changed since the write was planned: write again.");
        });
        return;
    }
    begin<OperationEnd<WriteReport>>(
        Task::Write,
        [axis = current->axis, asked = request, table = requestTable.table,
            store = connection()->session().storeRoot()](AxisCompensator& compensator,
            const OperationOptions& operation) -> Result<OperationEnd<WriteReport>> {
            return writeAxis(compensator, store, axis, withTable(asked, table), operation);
        },
        [this](const Result<OperationEnd<WriteReport>>& end) { written(end); });
}

void WizardController::Private::written(const Result<OperationEnd<WriteReport>>& end)
{
    plan.reset();
    if (!end) {
        show([error = end.error()] { return writeOutcome(fail(error)); });
        axisFailed(end.error());
        return;
    }
    if (end->outcome) {
        proof.reset();
        driveTable.expect(requestTable);
        if (!end->now)
            takeStatus(end->outcome->now, false); // that was read back too
    }
    takeEnd(*end);
    if (end->outcome)
        setup.setTable({}); // the drive has it now
    requestTable = {};
    show([result = end->outcome] { return writeOutcome(result); });
}

void WizardController::Private::writeMultiAxis()
{
    if (!mayStart(Action::WriteSeveral))
        return;
    if (multiAxis.tables.empty() || !multiAxis.plans || !*multiAxis.plans) {
        refuse([] { return tr("The writes are not planned yet."); });
        return;
    }
    multiAxis.axes = multiAxisAxes();
    multiAxis.turn = std::make_shared<std::atomic<std::size_t>>(0);
    multiAxis.isPersistent =
        multiAxis.tables.front().request.persistency == Persistency::Persistent;
    begin<OperationEnd<MultiAxisReport>>(
        Task::WriteSeveral,
        [shown = current->axis, tables = multiAxis.tables, turn = multiAxis.turn,
            store = connection()->session().storeRoot()](AxisCompensator& compensator,
            const OperationOptions& operation) -> Result<OperationEnd<MultiAxisReport>> {
            return writeTables(compensator, store, shown, tables, *turn, operation);
        },
        [this](const Result<OperationEnd<MultiAxisReport>>& end) {
            if (!end) {
                axisFailed(end.error());
                multiAxisWritten(fail(end.error()));
                return;
            }
            const auto written = writtenToShownAxis(end->outcome);
            if (written) {
                proof.reset();
                driveTable.expect(*written);
            }
            takeEnd(*end);
            if (written)
                setup.setTable({}); // the drive has it now
            multiAxisWritten(end->outcome);
        });
}

/// Whatever happened: what the drive says afterwards is what is shown.
template <typename T> void WizardController::Private::takeEnd(const OperationEnd<T>& end)
{
    if (end.now)
        takeReading(*end.now);
    else
        axisFailed(end.now.error());
}

void WizardController::Private::switchTo(Task wantedTask, Action action, Switch wanted)
{
    if (!mayStart(action))
        return;
    begin<OperationEnd<Activation>>(
        wantedTask,
        [axis = current->axis, wanted, store = connection()->session().storeRoot()](
            AxisCompensator& compensator,
            const OperationOptions& operation) -> Result<OperationEnd<Activation>> {
            return switchAxis(compensator, store, axis, wanted, operation);
        },
        [this, wanted](const Result<OperationEnd<Activation>>& end) {
            if (!end) {
                show([error = end.error()] { return errorOutcome(error); });
                axisFailed(end.error());
                return;
            }
            proof.reset();
            if (end->outcome && end->outcome->proof && *end->outcome->proof)
                proof = **end->outcome->proof;
            takeEnd(*end);
            show([wanted, result = end->outcome] { return activationOutcome(wanted, result); });
        });
}

void WizardController::Private::restorePrevious()
{
    if (!mayStart(Action::RestorePrevious))
        return;
    begin<OperationEnd<Restoration>>(
        Task::Restore,
        [axis = current->axis, store = connection()->session().storeRoot(), &drive = profile](
            AxisCompensator& compensator,
            const OperationOptions& operation) -> Result<OperationEnd<Restoration>> {
            return restoreAxis(compensator, drive, store, axis, operation);
        },
        [this](const Result<OperationEnd<Restoration>>& end) {
            if (!end) {
                show([error = end.error()] { return restorationOutcome(fail(error)); });
                axisFailed(end.error());
                return;
            }
            if (end->outcome)
                setup.revert(); // going back means the changes too
            takeEnd(*end);
            show([result = end->outcome] { return restorationOutcome(result); });
        });
}

void WizardController::Private::recover(bool finishes)
{
    if (!mayStart(finishes ? Action::FinishWrite : Action::UndoWrite))
        return;
    begin<OperationEnd<WriteReport>>(
        finishes ? Task::Finish : Task::Undo,
        [entry = unfinished->entry, finishes, store = connection()->session().storeRoot()](
            AxisCompensator& compensator,
            const OperationOptions& operation) -> Result<OperationEnd<WriteReport>> {
            return recoverAxis(compensator, store, entry, finishes, operation);
        },
        [this, finishes](const Result<OperationEnd<WriteReport>>& end) {
            if (!end) {
                show([finishes, error = end.error()] {
                    return recoveryOutcome(finishes, fail(error));
                });
                axisFailed(end.error());
                return;
            }
            takeEnd(*end);
            show([finishes, result = end->outcome] { return recoveryOutcome(finishes, result); });
        });
}

void WizardController::Private::cancel()
{
    if (!task) {
        file.cancelReading();
        return;
    }
    taskStop.request_stop();
    busy.canCancel = false;
    taskStep.clear();
    busy.step = busyText();
    log(LogLine::Kind::Information, [] { return tr("Stopped by the user."); });
    Q_EMIT q.busyChanged();
    update();
}

} // namespace axiscomp::ui
