// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/async/background_job.h"
#include "ui/controller/action_rules.h"
#include "ui/controller/axis_state.h"
#include "ui/controller/table_selection.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace axiscomp::ui {

/// Runs one operation at a time on the current axis's drive, and sees to it that afterwards the
/// state that the drive says is what is shown, whatever happened. Who calls has asked before
/// whether the operation is possible now.
class OperationRunner : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive the runner.
    OperationRunner(const DriveProfile& profile, const DriveList& drives, AxisState& axis,
        SetupModel& setup, TableSelection& tables, WizardLog& log, LastOutcome& outcome);

    [[nodiscard]] std::optional<Task> task() const { return m_task; }
    [[nodiscard]] const BusyState& busy() const { return m_busy; }
    /// Of the setup as it is; none: it has to be made.
    [[nodiscard]] const std::optional<WritePlan>& plan() const { return m_plan; }
    /// Of the last activation.
    [[nodiscard]] const std::optional<Proof>& proof() const { return m_proof; }

    /// Asks the drive what a write would change; planReady() follows, or an outcome that says why
    /// not. doubts: as WriteRequest has them.
    void planWrite(std::vector<Text> doubts);
    /// The same for the deletion of the axis's table.
    void planDeletion();
    /// The same for the state before the last write; restore() carries it out.
    void planRestoration();
    /// The same for a backup that was chosen.
    void planRestoration(const BackupChoice& choice);
    /// What plan() is of; null: it is of something else.
    [[nodiscard]] const std::shared_ptr<const PlannedRestoration>& plannedRestoration() const
    {
        return m_restoration;
    }
    /// Carries out plan(). acceptsLarge: as in WriteRequest.
    void write(bool acceptsLarge);
    /// Says that drive or fields have changed since plan() was made.
    void refuseOldPlan();
    /// Ends with the end-to-end proof, but for Deactivate.
    void switchTo(Switch wanted);
    /// plannedRestoration() is of a backup that was chosen, not of the previous state.
    [[nodiscard]] bool isBackupChosen() const { return m_isBackupChosen; }
    /// Carries out plannedRestoration().
    void restore();
    /// Finishes or undoes the write that did not end.
    void recover(bool finishes);
    /// Everything that can be changed on the drive of the current axis, to a file.
    void backUpDrive(const QString& path);
    void cancel();

    /// Runs something that changes the drive. take gets what became of it, and gives it to whom it
    /// concerns; then the outcome is shown and ended() emitted. place: which axis it is at, when it
    /// is about the whole drive.
    template <typename T>
    void run(Task task,
        std::function<OperationEnd<T>(
            AxisCompensator&, const std::filesystem::path& store, const OperationOptions&)>
            operation,
        std::function<void(const OperationEnd<T>&)> take,
        std::function<Outcome(const Result<T>&)> outcome, const Wording& place = {});
    /// The axis has this table now, and nobody has proved it; call it before the state is taken.
    void expect(const LoadedTable& written);

    /// The setup is another one: its plan has no use, unless it is being carried out.
    void dropPlan();
    /// There is no current axis.
    void forget();
    /// The operation on this drive, if there is one, is of no interest any more.
    void abandon(const DriveConnection* connection);
    void showProgress(const DriveConnection* of, const QString& step, double fraction);
    /// Says what runs in another language.
    void retranslate();

Q_SIGNALS:
    void busyChanged();
    void planReady();
    /// The axis has the new state of a write, a restoration or a write that was finished. now: as
    /// read back.
    void tableWritten(const axiscomp::AxisStatus& now);
    void ended(axiscomp::ui::Task task);

private:
    template <typename T>
    void begin(Task task, DriveSession::Operation<T> operation,
        std::function<void(const Result<T>&)> end, const Wording& place = {});
    void start(Task task, const Wording& place);
    void end();
    [[nodiscard]] QString busyText() const;
    void askForPlan();
    void askForRestoration(DriveSession::Operation<PlannedRestoration> question);
    void planned(const Result<WritePlan>& plan);

    const DriveProfile& m_profile;
    const DriveList& m_drives;
    AxisState& m_axis;
    SetupModel& m_setup;
    TableSelection& m_tables;
    WizardLog& m_log;
    LastOutcome& m_outcome;

    std::optional<Task> m_task;
    BusyState m_busy;
    QString m_step; ///< of core, as last reported; empty: none yet
    Wording m_place;
    QPointer<DriveConnection> m_connection; ///< on which the task runs
    std::stop_source m_stop;
    std::optional<WritePlan> m_plan;
    EditedSetup m_plannedSetup; ///< that the plan is of
    WriteRequest m_request; ///< the same as a request, without its table
    LoadedTable m_requestTable; ///< in the units of the drive
    std::shared_ptr<const CompensationTable> m_fileTable; ///< the same as the file has it
    std::shared_ptr<const PlannedRestoration> m_restoration; ///< that m_plan is of
    bool m_isBackupChosen = false; ///< m_restoration was asked for by choice
    std::optional<Proof> m_proof;
};

template <typename T>
void OperationRunner::begin(Task task, DriveSession::Operation<T> operation,
    std::function<void(const Result<T>&)> end, const Wording& place)
{
    DriveConnection* drive = m_drives.connection();
    start(task, place);
    m_connection = drive;
    m_stop = std::stop_source();
    whenDone(drive->session().run<T>(std::move(operation), m_stop.get_token()), this,
        [this, drive, end = std::move(end)](const Result<T>& result) {
            if (m_connection != drive)
                return; // its drive has been removed meanwhile
            this->end();
            end(result);
        });
}

template <typename T>
void OperationRunner::run(Task task,
    std::function<OperationEnd<T>(
        AxisCompensator&, const std::filesystem::path& store, const OperationOptions&)>
        operation,
    std::function<void(const OperationEnd<T>&)> take,
    std::function<Outcome(const Result<T>&)> outcome, const Wording& place)
{
    begin<OperationEnd<T>>(
        task,
        [operation = std::move(operation), store = m_drives.connection()->session().storeRoot()](
            AxisCompensator& compensator, const OperationOptions& options)
            -> Result<OperationEnd<T>> { return operation(compensator, store, options); },
        [this, task, take = std::move(take), outcome = std::move(outcome)](
            const Result<OperationEnd<T>>& result) {
            // An operation that could not even begin has changed nothing, and nothing was read.
            const OperationEnd<T> end =
                result ? *result : OperationEnd<T>{fail(result.error()), fail(result.error())};
            m_axis.expectChange();
            take(end);
            m_outcome.show([outcome, end = end.outcome] { return outcome(end); });
            Q_EMIT ended(task);
        },
        place);
}

} // namespace axiscomp::ui
