// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/multi_axis_write.h"
#include "core/drive/flash_wear.h"
#include "ui/async/background_job.h"
#include "ui/controller/action_rules.h"
#include "ui/controller/outcome_text.h"
#include "ui/controller/wizard_controller.h"
#include "ui/controller/wizard_log.h"
#include "ui/data/data_file_model.h"
#include "ui/data/drive_table.h"
#include "ui/session/drive_connection.h"
#include "ui/session/live_monitor.h"
#include "ui/text/language.h"

#include <QCoreApplication>
#include <QPointer>
#include <QTimer>

#include <atomic>
#include <functional>
#include <stop_token>

namespace axiscomp::ui {

struct WizardController::Private {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::WizardController)

public:
    Private(WizardController& controller, WizardOptions wizardOptions);
    ~Private();

    // Drives and axes (drive_list.cpp)
    void setEndpoints(const QStringList& wanted);
    DriveConnection* addConnection(const QString& endpoint);
    void removeConnection(DriveConnection* connection);
    void listDrives();
    void listAxes();
    void nameAxes();
    void select(const AxisEntry& entry);
    void leaveAxis();
    [[nodiscard]] DriveConnection* connectionOf(const QString& endpoint) const;
    [[nodiscard]] DriveConnection* connection() const; ///< of the current axis, may be null
    void driveFound(DriveConnection* found, bool wasAnother);
    void driveLost(DriveConnection* lost, const Error& error);

    // The current axis (axis_state.cpp)
    void readAxisNow();
    void takeReading(const AxisReading& reading);
    void takeStatus(const AxisStatus& now, bool isComplete);
    void noteUnfinished(const AxisReading& reading);
    void noteChanges(const AxisStatus& before, const AxisStatus& now);
    void axisFailed(const Error& error);
    void liveFailed(const Error& error);
    [[nodiscard]] FlashBudget flashBudget() const;
    void takeFlash(const AxisReading& reading);

    // Sources (source_check.cpp)
    struct SourceField {
        Wording problem; ///< none: nothing is wrong with it
        bool isBeingChecked = false;
        int check = 0; ///< the newest check counts
    };
    [[nodiscard]] SourceField& sourceField(int dimension);
    void chooseSource(int dimension, const QString& text);
    void acceptSource(int dimension, const DimSource& source);
    void refuseSource(int dimension, const Wording& problem);
    void forgetSourceProblems();

    // The file and the tables (table_selection.cpp)
    void fileReplaced(const std::shared_ptr<const CalibrationData>& before, bool isSameFile);
    void fileFailed(const LoadedFile& file);
    [[nodiscard]] LoadedTable selectedTable() const;
    [[nodiscard]] std::size_t selectedTableBytes() const;
    void noteSelectedTable();
    void fieldChanged(Field field);

    // Operations (operation_runner.cpp)
    template <typename T>
    void begin(
        Task task, DriveSession::Operation<T> operation, std::function<void(const Result<T>&)> end);
    void startTask(Task task);
    void endTask();
    void showProgress(DriveConnection* of, const QString& step, double fraction);
    [[nodiscard]] QString busyText() const;
    [[nodiscard]] bool mayStart(Action action);
    void planWrite();
    void write();
    void switchTo(Task task, Action action, Switch wanted);
    void restorePrevious();
    void recover(bool finishes);
    void cancel();
    void planned(const Result<WritePlan>& result);
    void written(const Result<OperationEnd<WriteReport>>& end);
    template <typename T> void takeEnd(const OperationEnd<T>& end);

    // Several axes (multi_axis_controller.cpp; writeMultiAxis is in operation_runner.cpp)
    struct MultiAxis {
        std::vector<AxisTable> tables; ///< that the drive was asked about
        std::optional<Result<std::vector<WritePlan>>> plans;
        int number = 0; ///< the newest question counts
        std::stop_source stop;
        bool isPersistent = false;
        std::vector<AxisEntry> axes; ///< that are being written
        std::shared_ptr<std::atomic<std::size_t>> turn; ///< which of them now
    };
    [[nodiscard]] std::vector<AxisEntry> usableAxes() const;
    void planMultiAxis(const std::vector<ColumnForAxis>& columns, bool keepsSources);
    void multiAxisPlanned(const Result<std::vector<WritePlan>>& plans);
    void writeMultiAxis();
    void multiAxisWritten(const Result<MultiAxisReport>& report);
    [[nodiscard]] std::vector<AxisEntry> multiAxisAxes() const;
    [[nodiscard]] std::optional<LoadedTable> writtenToShownAxis(
        const Result<MultiAxisReport>& report) const;

    // What is shown (action_snapshot.cpp)
    [[nodiscard]] ActionSnapshot snapshot() const;
    void snapshotDrive(ActionSnapshot& now) const;
    void snapshotUnfinished(ActionSnapshot& now) const;
    void snapshotSetup(ActionSnapshot& now) const;
    void update(); ///< actions and hint
    void show(const std::function<Outcome()>& makeOutcome);
    void refuse(const Wording& reason);
    void dismissOutcome();
    void log(LogLine::Kind kind, const Wording& wording, const QString& detail = {});
    void logError(const Error& error);
    void retranslate();

    WizardController& q;
    WizardOptions options;
    const DriveProfile& profile;

    std::vector<DriveConnection*> connections; ///< children of q
    std::vector<DriveState> drives;
    std::vector<AxisEntry> axes;
    struct AxisKey {
        QString endpoint;
        int axis = 0;
        friend bool operator==(const AxisKey&, const AxisKey&) = default;
    };
    std::optional<AxisKey> current;
    int currentIndex = -1;

    SetupModel setup;
    std::optional<AxisStatus> status;
    std::optional<SettledWrite> unfinished; ///< a write that did not end, as last settled
    std::optional<FlashUse> flashUse; ///< of the drive, as last read
    bool hasBackup = false;
    bool hasCompensation = true;
    std::optional<Error> readProblem;
    int reading = 0; ///< the newest reading of the axis counts
    bool isLeaving = false; ///< the fields are emptied: that is not a choice
    std::optional<Error> liveProblem; ///< as last logged
    FlashWearGuard flash;
    std::array<SourceField, 3> sourceFields;

    LiveMonitor live;
    DriveTable driveTable;
    DataFileModel file;
    bool isOpening = false; ///< somebody wants a table of the file that is being read
    std::shared_ptr<const CompensationTable> shownTable;

    BusyState busy;
    std::optional<Task> task;
    QString taskStep; ///< of core, as last reported; empty: none yet
    QPointer<DriveConnection> taskConnection;
    std::stop_source taskStop;
    std::optional<WritePlan> plan;
    EditedSetup plannedSetup; ///< that the plan is of
    WriteRequest request; ///< the same as a request, without its table
    LoadedTable requestTable;
    MultiAxis multiAxis;
    std::optional<Proof> proof;
    Outcome outcome;
    std::function<Outcome()> makeOutcome; ///< none: there is no outcome

    ActionStates decision;
    WizardLog logLines;
    QTimer countdown; ///< while flash wear makes the user wait
    QTimer readAgain; ///< after a reading that failed
};

} // namespace axiscomp::ui
