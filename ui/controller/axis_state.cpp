// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/axis_state.h"

#include "ui/async/background_job.h"
#include "ui/outcome/foreign_change.h"
#include "ui/text/message_text.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// What is shown beside the live values.
bool sameButLive(const AxisStatus& a, const AxisStatus& b)
{
    const bool sameTable = a.table.has_value() == b.table.has_value()
        && (!a.table
            || (a.table->crc == b.table->crc && a.table->grid == b.table->grid
                && a.table->persistent == b.table->persistent));
    return sameTable && a.setup == b.setup && a.axis.stateWord == b.axis.stateWord
        && a.axis.homingWord == b.axis.homingWord && a.axis.unit == b.axis.unit
        && a.axis.name == b.axis.name && a.activation == b.activation && a.error == b.error
        && a.driveError == b.driveError && a.unfinishedWrite == b.unfinishedWrite;
}

} // namespace

AxisState::AxisState(const WizardOptions& options, const DriveList& drives, SetupModel& setup,
    WizardLog& log, LastOutcome& outcome)
    : m_profile(*options.profile)
    , m_drives(drives)
    , m_setup(setup)
    , m_log(log)
    , m_outcome(outcome)
    , m_flash(m_profile.flashWear)
    , m_live(options.liveInterval)
{
    connect(&m_live, &LiveMonitor::read, this, [this](const WatchedStatus& now) {
        m_watched = now.values;
        if (now.journalProblem) {
            takeReadProblem(*now.journalProblem);
            readAgainLater(); // as far as that goes
            return;
        }
        m_liveProblem.reset();
        take(now.status, false);
    });
    connect(&m_live, &LiveMonitor::failed, this, &AxisState::takeLiveFailure);
    m_readAgain.setSingleShot(true);
    m_readAgain.setInterval(options.reconnectInterval);
    connect(&m_readAgain, &QTimer::timeout, this, &AxisState::readNow);
}

FlashBudget AxisState::flashBudget() const
{
    return m_flash.budget(std::chrono::system_clock::now());
}

void AxisState::watch(std::vector<std::string> registers)
{
    m_live.alsoRead(std::move(registers));
}

std::optional<double> AxisState::valueOf(const DimSource& source) const
{
    if (const auto watched = m_watched.find(source.path); watched != m_watched.end())
        return watched->second;
    if (!m_status || !source.isSet())
        return std::nullopt;
    const auto& sources = m_status->setup.sources;
    const auto known = std::ranges::find(sources, source);
    if (known == sources.end())
        return std::nullopt;
    return m_status->sourceValues[static_cast<std::size_t>(known - sources.begin())];
}

void AxisState::begin(bool isAnother)
{
    if (isAnother) {
        m_hasCompensation = m_drives.currentEntry().axis.hasCompensation();
        m_live.watch(m_drives.connection(), m_drives.currentAxis());
        Q_EMIT statusChanged();
    }
    readNow();
}

void AxisState::forget()
{
    m_underWay = 0;
    m_status.reset();
    m_watched.clear();
    m_unfinished.reset();
    m_flashUse.reset();
    m_hasBackup = false;
    m_hasCompensation = true;
    m_isJournalKnown = true;
    m_readProblem.reset();
    m_liveProblem.reset();
    m_isChangeExpected = false;
    m_readAgain.stop();
    m_live.watch(nullptr, 0);
}

void AxisState::readNow()
{
    DriveConnection* drive = m_drives.connection();
    if (!drive || !drive->isConnected() || !m_hasCompensation || m_isPaused)
        return;
    m_readAgain.stop();
    const auto read = [axis = m_drives.currentAxis(), store = drive->session().storeRoot()](
                          AxisCompensator& compensator, const OperationOptions& operation) {
        OperationOptions quiet = operation;
        quiet.progress = {};
        return readAxis(compensator, store, axis, quiet);
    };
    m_underWay = ++m_lastNumber;
    whenDone(drive->session().run<AxisReading>(read), this,
        [this, number = m_underWay](const Result<AxisReading>& reading) {
            if (number != m_underWay)
                return;
            m_underWay = 0;
            take(reading);
        });
}

void AxisState::pause()
{
    m_isPaused = true;
    m_underWay = 0;
    m_live.pause();
}

void AxisState::resume()
{
    m_isPaused = false;
    m_live.resume();
}

void AxisState::take(const Result<AxisReading>& reading)
{
    if (!reading) {
        takeFailure(reading.error());
        return;
    }
    m_isJournalKnown = reading->isJournalKnown();
    if (m_isJournalKnown)
        m_readProblem.reset();
    else
        takeReadProblem(*reading->settlingProblem);
    m_hasBackup = reading->hasBackup;
    // A refusal by the drive is in the store too, whichever program it was that ran into it.
    m_flash = wearGuard(m_profile.flashWear, reading->flashHistory);
    if (reading->flashUse)
        m_flashUse = reading->flashUse;
    noteUnfinished(*reading);
    take(reading->status, true);
}

void AxisState::take(const AxisStatus& now, bool isComplete)
{
    DriveConnection* drive = m_drives.connection();
    if (!drive || !drive->findings() || now.axis.index != m_drives.currentAxis())
        return;
    if (now.drive.serialNumber != drive->findings()->drive.serialNumber) {
        drive->explore(); // another drive answers: it is looked at from the beginning
        return;
    }
    const bool isFirst = !m_status;
    const bool isSame = m_status && sameButLive(*m_status, now);
    if (!isFirst)
        noteChanges(now);
    m_isChangeExpected = false;
    m_status = now;
    if (!now.unfinishedWrite)
        m_unfinished.reset();
    if (isFirst) {
        // A table that was chosen while the drive was not there yet stays chosen.
        m_setup.reset(now.setup, m_setup.edited().table);
    } else if (!(m_setup.baseline() == now.setup)) {
        m_setup.setBaseline(now.setup);
    }
    Q_EMIT taken(isComplete);
    if (!isSame)
        Q_EMIT statusChanged();
    Q_EMIT liveChanged();
    // A write of another program that has ended in between, or is going on.
    if ((now.unfinishedWrite && !m_unfinished) || !m_isJournalKnown)
        readAgainLater();
}

/// Not beside a reading that is under way, which would not count any more: where readings take
/// longer than the interval, none ever would.
void AxisState::readAgainLater()
{
    if (m_underWay == 0 && !m_readAgain.isActive())
        m_readAgain.start();
}

/// What the drive did without being asked by this window.
void AxisState::noteChanges(const AxisStatus& now)
{
    const AxisStatus& before = *m_status;
    const auto text = [](const std::string& name) { return QString::fromStdString(name); };
    if (before.axis.stateWord != now.axis.stateWord)
        m_log.add(
            LogLine::Kind::Information,
            [state = text(now.axis.stateWord)] { return tr("Compensation: %1.").arg(state); },
            text(before.axis.stateWord + " -> " + now.axis.stateWord));
    if (before.axis.homingWord != now.axis.homingWord)
        m_log.add(
            LogLine::Kind::Information,
            [homing = text(now.axis.homingWord)] { return tr("Homing: %1.").arg(homing); },
            text(before.axis.homingWord + " -> " + now.axis.homingWord));
    if (before.error != now.error && now.fault != CompensationFault::None)
        m_log.add(LogLine::Kind::Error, [error = text(now.error)] {
            return tr("The compensation is in error: %1.").arg(error);
        });
    if (before.driveError != now.driveError && now.hasDriveError)
        m_log.add(LogLine::Kind::Error,
            [error = text(now.driveError)] { return tr("The drive is in error: %1.").arg(error); });
    if (!m_isChangeExpected && !foreignChange(before, now).text.isEmpty())
        m_outcome.show([before, now] { return foreignChange(before, now); });
}

void AxisState::noteUnfinished(const AxisReading& now)
{
    if (!now.settled) {
        if (!now.status.unfinishedWrite)
            m_unfinished.reset();
        return;
    }
    const bool isNews = !m_unfinished || m_unfinished->outcome != now.settled->outcome;
    m_unfinished = now.settled;
    if (isNews)
        m_outcome.show([settled = *now.settled] { return settledOutcome(settled); });
}

void AxisState::takeFailure(const Error& error)
{
    if (isLinkFailure(error.code)) {
        m_outcome.dismissSuccess();
        if (DriveConnection* drive = m_drives.connection())
            drive->lose(error);
        return;
    }
    if (error.code == ErrorCode::NoCompensation || error.code == ErrorCode::AxisNotFound)
        m_hasCompensation = false;
    else
        m_readAgain.start();
    takeReadProblem(error);
    Q_EMIT failed();
}

void AxisState::takeReadProblem(const Error& error)
{
    if (m_readProblem && saysTheSame(*m_readProblem, error))
        return;
    m_readProblem = error;
    m_log.add(error);
}

void AxisState::takeLiveFailure(const Error& error)
{
    if (error.code == ErrorCode::Cancelled)
        return;
    if (isLinkFailure(error.code)) {
        m_outcome.dismissSuccess();
        if (DriveConnection* drive = m_drives.connection())
            drive->lose(error);
        return;
    }
    if (m_liveProblem && saysTheSame(*m_liveProblem, error))
        return;
    m_liveProblem = error;
    m_log.add(error);
}

} // namespace axiscomp::ui
