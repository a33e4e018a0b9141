// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/machine/machine_plan.h"
#include "ui/controller/operation_runner.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace axiscomp::ui {

/// Brings drives to what a machine file says, by plans that were looked at: several drives at the
/// same time, the axes of each one after the other, each write as any other write of the window. A
/// drive that fails holds up no other. The axis that is shown knows that it was this window.
class MachineApplication : public QObject {
    Q_OBJECT

public:
    /// One drive and its plan.
    struct Planned {
        QString endpoint; ///< without a password
        QString name; ///< of the drive
        std::shared_ptr<const DriveLook> look; ///< with a plan
        /// Of the table of each axis of the plan, without folder; empty: it shall have none.
        QStringList files;
    };
    /// What becomes of it.
    struct Written {
        Planned planned;
        bool isUnderWay = false;
        QString step; ///< of core, the newest; empty: none yet
        double fraction = 0.0; ///< of that axis's write
        std::vector<AxisOutcome> outcomes; ///< one for each axis of the plan, in the end
        std::optional<Error> problem; ///< why there are none
    };

    /// All of these must outlive this.
    MachineApplication(DriveList& drives, AxisState& axis, OperationRunner& runner, WizardLog& log,
        LastOutcome& outcome);
    ~MachineApplication() override;

    [[nodiscard]] bool isRunning() const;
    /// Nothing runs; no plan has a problem. context: of the machine file, its store is that of each
    /// drive. fileName: for what is said.
    void start(const QString& fileName, std::vector<Planned> drives, const MachineContext& context);
    /// Each drive ends where it is safe: the write that is under way is put back.
    void stop();
    [[nodiscard]] bool isStopping() const { return isRunning() && m_stop.stop_requested(); }
    /// Of the last start.
    [[nodiscard]] const std::vector<Written>& drives() const { return m_written; }
    /// 0 to 1
    [[nodiscard]] double fraction() const;
    /// What it has come to, as a sentence.
    [[nodiscard]] Outcome outcome() const;

Q_SIGNALS:
    void started(); ///< isRunning(), unless all of it is at its end already
    void progressed();
    /// An axis has the table of a file. endpoint: without a password; now: as read back.
    void columnWritten(const QString& endpoint, const axiscomp::AxisStatus& now,
        const QString& file, const QString& column);
    void ended();

private:
    using Outcomes = std::shared_ptr<const std::vector<AxisOutcome>>;

    [[nodiscard]] static Result<Outcomes> applied(AxisCompensator& compensator,
        const DrivePlan& plan, const MachineContext& context, const OperationOptions& options);
    void begin(std::size_t index, const MachineContext& context);
    void beginCurrent(std::size_t index, const MachineContext& context);
    void take(std::size_t index, const Result<Outcomes>& outcomes);
    void note(const Written& written);
    void tellColumns(const Written& written);
    void endWhenDone();
    void showProgress(const DriveConnection* of, const QString& step, double fraction);
    void abandon(const DriveConnection* connection);

    DriveList& m_drives;
    AxisState& m_axis;
    OperationRunner& m_runner;
    WizardLog& m_log;
    LastOutcome& m_outcome;
    QString m_fileName;
    std::vector<Written> m_written;
    std::stop_source m_stop;
    bool m_isEnded = true; ///< its end has been told
    int m_run = 0; ///< answers of an earlier one come too late
};

/// "X · Stage-7"
[[nodiscard]] QString axisOfDriveText(const QString& drive, const std::string& axis);

} // namespace axiscomp::ui
