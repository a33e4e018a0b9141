// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/machine/machine_plan.h"
#include "ui/async/background_job.h"
#include "ui/controller/axis_overview.h"
#include "ui/controller/machine_application.h"
#include "ui/controller/machine_saving.h"

#include <QDateTime>
#include <QObject>
#include <QString>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

/// A machine file as it was read last, with the files of its tables.
struct OpenMachine {
    QString path;
    std::optional<Error> refusal; ///< why there is no machine
    MachineReading reading; ///< empty where the file could not even be read
    std::vector<std::vector<MachineTable>> tables; ///< by drive and axis

    [[nodiscard]] std::filesystem::path folder() const;
};

/// A drive of the machine file that is open.
struct MachineDriveState {
    MachineDrive wanted;
    QString endpoint; ///< without a password
    std::shared_ptr<const DriveLook> look; ///< null: not asked yet
    QDateTime looked; ///< when look was made
    bool isBeingAsked = false;
    bool isConnected = false; ///< it is among the connections
};

/// How an axis stands to what the machine file says of it.
struct AxisDrift {
    enum class State {
        NotInFile,
        NotConnected, ///< its drive was taken out of the connections
        Waiting, ///< nothing is known yet
        Unreachable, ///< the drive does not answer
        Problem, ///< it cannot be compared
        Differs,
        AsFile,
    } state = State::NotInFile;
    QDateTime looked; ///< when it was compared; none: not yet
    bool isBeingAsked = false; ///< what is known is being looked at again
    std::shared_ptr<const DriveLook> look; ///< that plan is part of; may be null
    const AxisPlan* plan = nullptr; ///< null: there is none
    std::optional<std::size_t> axis = {}; ///< of the plan and of MachineDrive::axes
    /// Null: of none in the file. Only until the next driftChanged().
    const MachineDriveState* drive = nullptr;
};

/// The machine file that is open: its drives, asked at the same time on their sessions' threads,
/// and how they differ from it. A drive is compared when the file is opened,
/// when it answers again, after an operation of this window, and when the overview sees that an
/// axis has become another one; an operation does not wait for that. Nothing but apply() changes a
/// drive.
class MachineController : public QObject {
    Q_OBJECT

public:
    using Drive = MachineDriveState;

    /// All of these must outlive the controller.
    MachineController(const DriveProfile& profile, DriveList& drives, AxisState& axis,
        const AxisOverview& overview, OperationRunner& runner, WizardLog& log,
        LastOutcome& outcome);
    ~MachineController() override;

    /// Reads the file and its tables, connects to its drives as far as the window is not, and
    /// compares them.
    void open(const QString& path);
    /// The same for the file that is open, which may have changed.
    void planAgain();
    void close();

    /// Null: none is open.
    [[nodiscard]] const std::shared_ptr<const OpenMachine>& file() const { return m_file; }
    [[nodiscard]] bool isReading() const { return !m_reading.isEmpty(); }
    /// Of the file that is open or being read; empty: none.
    [[nodiscard]] QString path() const;
    /// Those of the file, in its order; none where it is no machine file.
    [[nodiscard]] const std::vector<Drive>& drives() const { return m_machine; }
    [[nodiscard]] bool isAsking() const;
    /// Of an axis of the file, or of one that is not in it.
    [[nodiscard]] static AxisDrift driftOf(const Drive& drive, std::optional<std::size_t> axis);
    /// Of an axis of any drive. endpoint: without a password; axis: none: of the drive.
    [[nodiscard]] AxisDrift driftOf(const QString& endpoint, std::optional<int> axis) const;
    /// When the first of what is known was looked at; none: nothing is known.
    [[nodiscard]] QDateTime oldestLook() const;

    /// Compensations are to be switched as the file says (active): plans are made with that.
    void setActivates(bool activates);
    [[nodiscard]] bool activates() const { return m_activates; }
    /// Everything that stands in the way of apply(), drive by drive. allowsMissing: drives that do
    /// not answer may be left out.
    struct Obstacle {
        const MachineDriveState* drive = nullptr; ///< until the next driftChanged()
        PlanProblem problem;
    };
    [[nodiscard]] std::vector<Obstacle> obstacles(bool allowsMissing) const;
    /// Whether an axis would be written or switched.
    [[nodiscard]] bool isToBeChanged(const AxisPlan& plan) const;
    /// Why apply() is not possible now, a translated sentence; empty: it is.
    [[nodiscard]] QString applyObstacle(bool allowsMissing) const;
    /// Carries out what drives() say. application().ended() follows.
    void apply();
    [[nodiscard]] MachineApplication& application() { return m_application; }
    [[nodiscard]] const MachineApplication& application() const { return m_application; }
    /// Running drives to a machine file.
    [[nodiscard]] MachineSaving& saving() { return m_saving; }

Q_SIGNALS:
    void fileChanged(); ///< another one, read again, or being read
    void driftChanged();

private:
    using Opening = std::shared_ptr<const OpenMachine>;
    using Look = std::shared_ptr<const DriveLook>;
    struct Asking {
        std::stop_source stop;
        int number = 0; ///< the newest question counts
        bool mustAsk = false; ///< as soon as nothing runs on the drive any more
        std::int32_t serialNumber = 0; ///< of the drive that was asked
    };

    void read(const QString& path);
    void take(const Opening& opening);
    void connectDrives();
    [[nodiscard]] DriveConnection* connectionOf(const Drive& drive) const;
    void follow();
    void followOperation();
    void followRow(int row);
    void ask(std::size_t index);
    void take(std::size_t index, int number, const Look& look);
    void put(std::size_t index, const Look& look);
    void askAll();
    void stopAsking();

    const DriveProfile& m_profile;
    DriveList& m_drives;
    const AxisOverview& m_overview;
    const OperationRunner& m_runner;
    MachineApplication m_application;
    MachineSaving m_saving;
    NewestJob<Opening> m_job;
    QString m_reading; ///< path of the file that is being read
    Opening m_file;
    std::vector<Drive> m_machine;
    std::vector<Asking> m_asking; ///< one for each of m_machine
    int m_number = 0;
    /// What the overview last said of an axis, by endpoint and index.
    std::map<std::pair<QString, int>, std::pair<CompensationSetup, bool>> m_seen;
    bool m_wasRunning = false;
    bool m_activates = false;
};

} // namespace axiscomp::ui
