// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link_failure.h"
#include "ui/wizard_controller_p.h"

#include <utility>

namespace axiscomp::ui {

namespace {

/// All sources, so that those of dimensions that are no longer chosen are taken away.
WriteRequest requestFor(const EditedSetup& edited, const CompensationSetup& baseline)
{
    WriteRequest request;
    request.dimensionality = edited.dimensionality;
    for (std::size_t n = 0; n < static_cast<std::size_t>(edited.dimensionality); ++n) {
        const DimSource& source = edited.sources[n];
        request.sources.push_back(source.path.empty()
                ? QStringLiteral("0x%1").arg(source.address, 8, 16, QChar(u'0')).toStdString()
                : source.path);
    }
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

QString taskText(Task task)
{
    switch (task) {
    case Task::Plan:
        return WizardController::tr("planning");
    case Task::Write:
        return WizardController::tr("writing");
    case Task::Activate:
        return WizardController::tr("activating");
    case Task::Evaluate:
        return WizardController::tr("evaluating");
    case Task::Deactivate:
        return WizardController::tr("deactivating");
    case Task::Restore:
        break;
    }
    return WizardController::tr("restoring");
}

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
    busy = {true, taskText(started), 0.0, true};
    log(LogLine::Kind::Information,
        tr("Begin: %1 %2.")
            .arg(taskText(started), axes.at(static_cast<std::size_t>(currentIndex)).label));
    show({});
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
    busy.step = tr("%1: %2").arg(taskText(*task), stepText(step));
    busy.fraction = fraction;
    Q_EMIT q.busyChanged();
}

/// Who asks for what cannot be done now is told why.
bool WizardController::Private::mayStart(Action action)
{
    update();
    const ActionState& state = decision[action];
    if (!state.isEnabled)
        show({state.reason, true, {}});
    return state.isEnabled;
}

void WizardController::Private::planWrite()
{
    if (!mayStart(Action::Write))
        return;
    plan.reset();
    const EditedSetup& edited = setup.edited();
    plannedSetup = edited;
    request = requestFor(edited, setup.baseline());
    requestTable = edited.table.fileTable ? file.table(*edited.table.fileTable) : nullptr;
    if (!setup.isChanged()) {
        // Only an earlier write is finished: its parameters are saved.
        request.sources.clear();
        request.persistency = Persistency::Persistent;
    }
    begin<WritePlan>(
        Task::Plan,
        [axis = current->axis, asked = request, table = requestTable](
            AxisCompensator& compensator, const OperationOptions& operation) {
            return compensator.plan(axis, withTable(asked, table), operation);
        },
        [this](const Result<WritePlan>& result) { planned(result); });
}

void WizardController::Private::planned(const Result<WritePlan>& result)
{
    if (!result) {
        noteFlashRefusal(result.error());
        show(errorOutcome(result.error()));
        if (isLinkFailure(result.error().code))
            axisFailed(result.error());
        else
            readAxisNow();
        return;
    }
    if (!(setup.edited() == plannedSetup)) {
        show({tr("The fields were changed while the write was planned: write again."), true, {}});
        return;
    }
    plan = *result;
    for (std::string& warning : plan->warnings)
        warning = phraseText(warning).toStdString();
    if (unfinished == AxisCompensator::UnfinishedOutcome::NewUnsaved && plan->changes.empty())
        plan->changes.push_back(
            {"Parameters", tr("perhaps not saved").toStdString(), tr("saved").toStdString()});
    Q_EMIT q.planReady();
}

void WizardController::Private::write()
{
    if (!mayStart(Action::Write))
        return;
    if (!plan) {
        show({tr("The drive or the fields have changed since the write was planned: write again."),
            true, {}});
        return;
    }
    begin<OperationEnd<WriteReport>>(
        Task::Write,
        [axis = current->axis, asked = request, table = requestTable,
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
        show(writeOutcome(fail(end.error())));
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
    else
        noteFlashRefusal(end->outcome.error());
    requestTable.reset();
    show(writeOutcome(end->outcome));
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
                show(errorOutcome(end.error()));
                axisFailed(end.error());
                return;
            }
            proof.reset();
            if (end->outcome && end->outcome->proof && *end->outcome->proof)
                proof = **end->outcome->proof;
            takeEnd(*end);
            show(activationOutcome(wanted, end->outcome));
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
                show(restorationOutcome(fail(end.error())));
                axisFailed(end.error());
                return;
            }
            if (end->outcome)
                setup.revert(); // going back means the changes too
            else
                noteFlashRefusal(end->outcome.error());
            takeEnd(*end);
            show(restorationOutcome(end->outcome));
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
    busy.step = tr("%1: stopping").arg(taskText(*task));
    log(LogLine::Kind::Information, tr("Stopped by the user."));
    Q_EMIT q.busyChanged();
    update();
}

} // namespace axiscomp::ui
