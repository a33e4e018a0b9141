// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_operations.h"
#include "core/drive/flash_wear.h"
#include "ui/controller/drive_list.h"
#include "ui/controller/setup_model.h"
#include "ui/session/live_monitor.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::ui {

/// What the drive says about the current axis, read when something has happened to it and, for the
/// live values, again and again. What the drive did without being asked goes to the log; what it
/// has becomes the baseline of the setup.
class AxisState : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive the state.
    AxisState(const WizardOptions& options, const DriveList& drives, SetupModel& setup,
        WizardLog& log, LastOutcome& outcome);

    /// None: not read yet.
    [[nodiscard]] const std::optional<AxisStatus>& status() const { return m_status; }
    /// A write that did not end, as last settled.
    [[nodiscard]] const std::optional<SettledWrite>& unfinished() const { return m_unfinished; }
    [[nodiscard]] bool hasBackup() const { return m_hasBackup; }
    [[nodiscard]] bool hasCompensation() const { return m_hasCompensation; }
    /// False: whether a write did not end is not known; readProblem says why.
    [[nodiscard]] bool isJournalKnown() const { return m_isJournalKnown; }
    /// Why it cannot be read.
    [[nodiscard]] const std::optional<Error>& readProblem() const { return m_readProblem; }
    /// Of the axis's drive, as last read.
    [[nodiscard]] const std::optional<FlashUse>& flashUse() const { return m_flashUse; }
    [[nodiscard]] FlashBudget flashBudget() const;

    /// Registers that are read with the live values.
    void watch(std::vector<std::string> registers);
    /// Of one that is watched, or of a source that the axis has; none: not read yet.
    [[nodiscard]] std::optional<double> valueOf(const DimSource& source) const;
    /// Reads the current axis. isAnother: nothing is known about it yet.
    void begin(bool isAnother);
    /// There is no current axis.
    void forget();
    void readNow();
    void readLiveNow() { m_live.readNow(); }
    /// Nothing is read while something runs: what was read before it would arrive as if it were
    /// read afterwards.
    void pause();
    void resume();
    /// What the next status has is this window's doing.
    void expectChange() { m_isChangeExpected = true; }
    /// What somebody else has read, or why it could not be read.
    void take(const Result<AxisReading>& reading);
    /// As far as the drive alone knows. isComplete: what this computer knows about the drive has
    /// been read too.
    void take(const AxisStatus& status, bool isComplete);
    /// Live values, or a table, could not be read; said once.
    void takeLiveFailure(const Error& error);

Q_SIGNALS:
    /// status() is new. isComplete: as for take().
    void taken(bool isComplete);
    void statusChanged(); ///< something that is not live
    void liveChanged();
    void failed();

private:
    void takeFailure(const Error& error);
    void takeReadProblem(const Error& error);
    void noteChanges(const AxisStatus& now);
    void noteUnfinished(const AxisReading& now);
    void readAgainLater();

    const DriveProfile& m_profile;
    const DriveList& m_drives;
    SetupModel& m_setup;
    WizardLog& m_log;
    LastOutcome& m_outcome;
    std::optional<AxisStatus> m_status;
    std::optional<SettledWrite> m_unfinished;
    std::optional<FlashUse> m_flashUse;
    FlashWearGuard m_flash;
    bool m_hasBackup = false;
    bool m_hasCompensation = true;
    bool m_isJournalKnown = true;
    std::optional<Error> m_readProblem;
    std::optional<Error> m_liveProblem; ///< as last logged
    LiveMonitor m_live;
    std::map<std::string, double> m_watched; ///< as last read
    QTimer m_readAgain;
    int m_lastNumber = 0; ///< of a reading
    int m_underWay = 0; ///< the reading that counts; 0: none
    bool m_isPaused = false;
    bool m_isChangeExpected = false;
};

} // namespace axiscomp::ui
