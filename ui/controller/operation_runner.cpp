// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/operation_runner.h"

#include "core/io/local_file.h"
#include "core/store/backup.h"
#include "ui/session/axis_list.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QFileInfo>

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
    request.expected = PlannedState{baseline};
    return request;
}

/// Copies the table on the session's thread: it may be large.
WriteRequest withTable(WriteRequest request, const std::shared_ptr<const CompensationTable>& table)
{
    if (table)
        request.table = *table;
    return request;
}

Task taskOf(Switch wanted)
{
    return wanted == Switch::Activate ? Task::Activate
        : wanted == Switch::Evaluate  ? Task::Evaluate
                                      : Task::Deactivate;
}

} // namespace

OperationRunner::OperationRunner(const DriveProfile& profile, const DriveList& drives,
    AxisState& axis, SetupModel& setup, TableSelection& tables, WizardLog& log,
    LastOutcome& outcome)
    : m_profile(profile)
    , m_drives(drives)
    , m_axis(axis)
    , m_setup(setup)
    , m_tables(tables)
    , m_log(log)
    , m_outcome(outcome)
{
}

void OperationRunner::start(Task task, const Wording& place)
{
    m_task = task;
    m_axis.pause();
    m_tables.driveTable().interrupt();
    m_step.clear();
    m_place = place;
    m_busy = {true, busyText(), 0.0, true};
    m_log.add(LogLine::Kind::Information,
        [task, isOnDrive = static_cast<bool>(place), entry = m_drives.currentEntry()] {
            return isOnDrive
                ? tr("Begin: %1, %2.", "task and drive").arg(taskText(task), entry.driveName)
                : tr("Begin: %1 %2.").arg(taskText(task), axisLabel(entry));
        });
    m_outcome.dismiss();
    Q_EMIT busyChanged();
}

void OperationRunner::end()
{
    m_task.reset();
    m_connection.clear();
    m_busy = {};
    m_axis.resume();
    Q_EMIT busyChanged();
}

void OperationRunner::abandon(const DriveConnection* connection)
{
    if (!m_task || m_connection != connection)
        return;
    m_stop.request_stop();
    end();
}

void OperationRunner::showProgress(const DriveConnection* of, const QString& step, double fraction)
{
    if (!m_task || m_connection != of)
        return;
    m_step = step;
    m_busy.step = busyText();
    m_busy.fraction = fraction;
    Q_EMIT busyChanged();
}

QString OperationRunner::busyText() const
{
    const QString task = taskText(*m_task);
    if (!m_step.isEmpty() && m_place)
        return tr("%1: %2, %3", "task, axis and step").arg(task, m_place(), stepText(m_step));
    if (!m_step.isEmpty())
        return tr("%1: %2").arg(task, stepText(m_step));
    const bool isStopping = m_busy.isBusy && !m_busy.canCancel;
    return isStopping ? tr("%1: stopping").arg(task) : task;
}

void OperationRunner::retranslate()
{
    if (!m_task)
        return;
    m_busy.step = busyText();
    Q_EMIT busyChanged();
}

void OperationRunner::planWrite(std::vector<Text> doubts)
{
    m_plan.reset();
    const EditedSetup& edited = m_setup.edited();
    m_plannedSetup = edited;
    m_request = requestFor(edited, m_setup.baseline());
    m_request.doubts = std::move(doubts);
    m_requestTable = edited.table.fileTable ? m_tables.selected() : LoadedTable{};
    if (m_requestTable.table) {
        m_request.lookupAt = m_tables.file().file().lookupAt;
        m_request.measuredDrive = m_tables.file().file().measuredDrive;
        m_request.isComputed = m_tables.file().file().isComputed;
    }
    m_fileTable = m_tables.selectedOfFile().table;
    if (!m_setup.isDirty()) {
        // Only an earlier write is finished: its parameters are saved.
        m_request.sources.clear();
        m_request.persistency = Persistency::Persistent;
    }
    askForPlan();
}

void OperationRunner::planDeletion()
{
    m_plan.reset();
    m_plannedSetup = m_setup.edited();
    m_request = deletionRequest();
    m_request.expected = PlannedState{m_setup.baseline()};
    m_requestTable = {};
    m_fileTable.reset();
    askForPlan();
}

void OperationRunner::planRestoration()
{
    m_isBackupChosen = false;
    askForRestoration([axis = m_drives.currentAxis(), &profile = m_profile,
                          store = m_drives.connection()->session().storeRoot()](
                          AxisCompensator& compensator, const OperationOptions& options) {
        return axiscomp::planRestoration(compensator, profile, store, axis, options);
    });
}

void OperationRunner::planRestoration(const BackupChoice& choice)
{
    m_isBackupChosen = true;
    askForRestoration(
        [choice, &profile = m_profile, store = m_drives.connection()->session().storeRoot()](
            AxisCompensator& compensator, const OperationOptions& options) {
            return axiscomp::planRestoration(compensator, profile, store, choice, options);
        });
}

void OperationRunner::askForRestoration(DriveSession::Operation<PlannedRestoration> question)
{
    m_plan.reset();
    m_plannedSetup = m_setup.edited();
    m_requestTable = {};
    m_fileTable.reset();
    using Planned = std::shared_ptr<const PlannedRestoration>;
    begin<Planned>(
        Task::Plan,
        [question = std::move(question)](
            AxisCompensator& compensator, const OperationOptions& options) -> Result<Planned> {
            AXISCOMP_TRY(auto answer, question(compensator, options));
            return std::make_shared<const PlannedRestoration>(std::move(answer));
        },
        [this](const Result<Planned>& result) {
            m_restoration.reset();
            if (!result)
                return planned(fail(result.error()));
            m_restoration = *result;
            planned(m_restoration->plan);
        });
}

void OperationRunner::askForPlan()
{
    m_restoration.reset();
    begin<WritePlan>(
        Task::Plan,
        [axis = m_drives.currentAxis(), asked = m_request, table = m_fileTable](
            AxisCompensator& compensator, const OperationOptions& options) {
            return compensator.plan(axis, withTable(asked, table), options);
        },
        [this](const Result<WritePlan>& result) { planned(result); });
}

void OperationRunner::planned(const Result<WritePlan>& result)
{
    if (!result) {
        const auto refusal = [error = result.error()] { return errorOutcome(error); };
        if (isLinkFailure(result.error().code)) {
            m_outcome.showOfConnection(refusal);
            m_axis.take(fail(result.error()));
        } else {
            m_outcome.showOfChoice(refusal);
            m_axis.readNow();
        }
        return;
    }
    if (!(m_setup.edited() == m_plannedSetup)) {
        m_outcome.refuse(
            [] { return tr("The fields were changed while the write was planned: write again."); });
        return;
    }
    m_plan = *result;
    Q_EMIT planReady();
}

void OperationRunner::dropPlan()
{
    if (m_task != Task::Write && m_task != Task::Delete && m_task != Task::Restore)
        m_plan.reset();
}

void OperationRunner::forget()
{
    m_plan.reset();
    m_proof.reset();
}

void OperationRunner::write(bool acceptsLarge)
{
    if (!m_plan)
        return refuseOldPlan();
    m_request.acceptsLarge = acceptsLarge;
    expectAsPlanned(m_request, *m_plan);
    const bool deletes = m_request.deletesTable;
    run<WriteReport>(
        deletes ? Task::Delete : Task::Write,
        [axis = m_drives.currentAxis(), asked = m_request, table = m_fileTable](
            auto& compensator, const auto& store, const auto& options) {
            return writeAxis(compensator, store, axis, withTable(asked, table), options);
        },
        [this, deletes](const OperationEnd<WriteReport>& end) {
            m_plan.reset();
            if (end.outcome) {
                expect(m_requestTable);
                if (!end.now)
                    m_axis.take(end.outcome->now, false); // that was read back too
            }
            m_axis.take(end.now);
            if (end.outcome && !deletes)
                m_setup.setTable({}); // the drive has it now
            m_requestTable = {};
            m_fileTable.reset();
            if (end.outcome && !deletes)
                Q_EMIT tableWritten(end.outcome->now);
        },
        writeOutcome);
}

void OperationRunner::refuseOldPlan()
{
    m_outcome.refuse([] {
        return tr("The drive or the fields have changed since the write was planned: write again.");
    });
}

void OperationRunner::expect(const LoadedTable& written)
{
    m_proof.reset();
    m_tables.driveTable().expect(written);
}

void OperationRunner::switchTo(Switch wanted)
{
    run<Activation>(
        taskOf(wanted),
        [axis = m_drives.currentAxis(), wanted](auto& compensator, const auto& store,
            const auto& options) { return switchAxis(compensator, store, axis, wanted, options); },
        [this](const OperationEnd<Activation>& end) {
            m_proof.reset();
            if (end.outcome && end.outcome->proof && *end.outcome->proof)
                m_proof = **end.outcome->proof;
            m_axis.take(end.now);
        },
        [wanted](const Result<Activation>& result) { return activationOutcome(wanted, result); });
}

void OperationRunner::restore()
{
    run<Restoration>(
        Task::Restore,
        [planned = m_restoration](auto& compensator, const auto& store, const auto& options) {
            return restoreAxis(compensator, store, *planned, options);
        },
        [this](const OperationEnd<Restoration>& end) {
            m_plan.reset();
            if (end.outcome)
                m_setup.revert(); // going back means the changes too
            m_axis.take(end.now);
            if (end.outcome && end.now)
                Q_EMIT tableWritten(end.now->status);
        },
        restorationOutcome);
}

void OperationRunner::recover(bool finishes)
{
    run<WriteReport>(
        finishes ? Task::Finish : Task::Undo,
        [entry = m_axis.unfinished()->entry, finishes](
            auto& compensator, const auto& store, const auto& options) {
            return recoverAxis(compensator, store, entry, finishes, options);
        },
        [this, finishes](const OperationEnd<WriteReport>& end) {
            m_axis.take(end.now);
            if (end.outcome && finishes) // undone: the axis has what it had
                Q_EMIT tableWritten(end.outcome->now);
        },
        [finishes](
            const Result<WriteReport>& result) { return recoveryOutcome(finishes, result); });
}

void OperationRunner::backUpDrive(const QString& path)
{
    struct Written {
        std::size_t axes = 0;
        std::size_t tables = 0;
        std::vector<Error> doubts;
    };
    const auto backUp = [place = QFileInfo(path).filesystemAbsoluteFilePath(),
                            store = m_drives.connection()->session().storeRoot()](
                            AxisCompensator& compensator,
                            const OperationOptions& options) -> Result<Written> {
        AXISCOMP_TRY(auto rescue, axiscomp::backUpDrive(compensator, store, options));
        const DriveBackup& backup = rescue.backup;
        AXISCOMP_CHECK(saveFile(place, asBytes(writeBackup(backup))));
        Written written{backup.axes.size(), backup.otherFiles.size(), std::move(rescue.doubts)};
        for (const AxisBackup& axis : backup.axes)
            written.tables += axis.files.size();
        return written;
    };
    begin<Written>(
        Task::BackUpDrive, backUp,
        [this, name = QFileInfo(path).fileName()](const Result<Written>& result) {
            if (!result && isLinkFailure(result.error().code))
                m_axis.take(fail(result.error()));
            m_outcome.show([name, result] {
                if (!result)
                    return errorOutcome(result.error());
                QStringList said{
                    tr("Wrote %1: axes: %2, tables: %3.")
                        .arg(name, countText(result->axes), countText(result->tables))};
                for (const Error& doubt : result->doubts)
                    said += errorText(doubt);
                return Outcome{said.join(u' '), false, {}, !result->doubts.empty()};
            });
        },
        [entry = m_drives.currentEntry()] { return entry.driveName; });
}

void OperationRunner::cancel()
{
    m_stop.request_stop();
    m_busy.canCancel = false;
    m_step.clear();
    m_busy.step = busyText();
    m_log.add(LogLine::Kind::Information, [] { return tr("Stopped by the user."); });
    Q_EMIT busyChanged();
}

} // namespace axiscomp::ui
