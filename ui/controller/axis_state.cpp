// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "ui/controller/wizard_controller_p.h"
#include "ui/text/message_text.h"

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

void WizardController::Private::readAxisNow()
{
    DriveConnection* drive = connection();
    if (!drive || !drive->isConnected() || !hasCompensation || task)
        return;
    readAgain.stop();
    const auto read = [axis = current->axis, store = drive->session().storeRoot()](
                          AxisCompensator& compensator, const OperationOptions& operation) {
        OperationOptions quiet = operation;
        quiet.progress = {};
        return readAxis(compensator, store, axis, quiet);
    };
    whenDone(drive->session().run<AxisReading>(read), &q,
        [this, number = ++reading](const Result<AxisReading>& result) {
            if (number != reading)
                return;
            if (result)
                takeReading(*result);
            else
                axisFailed(result.error());
        });
}

void WizardController::Private::takeReading(const AxisReading& now)
{
    readProblem.reset();
    hasBackup = now.hasBackup;
    takeFlash(now);
    noteUnfinished(now);
    takeStatus(now.status, true);
}

/// isComplete: beside the drive, what this computer knows about it has been read too.
void WizardController::Private::takeStatus(const AxisStatus& now, bool isComplete)
{
    DriveConnection* drive = connection();
    if (!drive || !drive->findings() || now.axis.index != current->axis)
        return;
    if (now.drive.serialNumber != drive->findings()->drive.serialNumber) {
        drive->explore(); // another drive answers: it is looked at from the beginning
        return;
    }
    const bool isFirst = !status;
    const bool isSame = status && sameButLive(*status, now);
    if (!isFirst)
        noteChanges(*status, now);
    status = now;
    if (!now.unfinishedWrite)
        unfinished.reset();
    if (isFirst) {
        // A table that was chosen while the drive was not there yet stays chosen.
        setup.reset(now.setup, setup.edited().table);
    } else if (!(setup.baseline() == now.setup)) {
        setup.setBaseline(now.setup);
    }
    driveTable.follow(*drive, now, isComplete);
    noteSelectedTable();
    if (!isSame)
        Q_EMIT q.statusChanged();
    Q_EMIT q.liveChanged();
    update();
    // A write of another program that has ended in between, or is going on.
    if (now.unfinishedWrite && !unfinished && !readAgain.isActive())
        readAgain.start();
}

/// What the drive did without being asked by this window.
void WizardController::Private::noteChanges(const AxisStatus& before, const AxisStatus& now)
{
    const auto text = [](const std::string& name) { return QString::fromStdString(name); };
    if (before.axis.stateWord != now.axis.stateWord)
        log(
            LogLine::Kind::Information,
            [state = text(now.axis.stateWord)] { return tr("Compensation: %1.").arg(state); },
            text(before.axis.stateWord + " -> " + now.axis.stateWord));
    if (before.axis.homingWord != now.axis.homingWord)
        log(
            LogLine::Kind::Information,
            [homing = text(now.axis.homingWord)] { return tr("Homing: %1.").arg(homing); },
            text(before.axis.homingWord + " -> " + now.axis.homingWord));
    if (before.error != now.error && now.fault != CompensationFault::None)
        log(LogLine::Kind::Error, [error = text(now.error)] {
            return tr("The compensation is in error: %1.").arg(error);
        });
    if (before.driveError != now.driveError && now.hasDriveError)
        log(LogLine::Kind::Error,
            [error = text(now.driveError)] { return tr("The drive is in error: %1.").arg(error); });
    if (!task && !(before.setup == now.setup))
        log(LogLine::Kind::Warning,
            [] { return tr("Another program changed the settings of this axis on the drive."); });
}

void WizardController::Private::noteUnfinished(const AxisReading& now)
{
    if (!now.settled) {
        if (!now.status.unfinishedWrite)
            unfinished.reset();
        return;
    }
    const bool isNews = !unfinished || unfinished->outcome != now.settled->outcome;
    unfinished = now.settled;
    if (isNews)
        show([settled = *now.settled] { return settledOutcome(settled); });
}

void WizardController::Private::axisFailed(const Error& error)
{
    if (isLinkFailure(error.code)) {
        if (DriveConnection* drive = connection())
            drive->lose(error);
        return;
    }
    if (error.code == ErrorCode::NoCompensation || error.code == ErrorCode::AxisNotFound)
        hasCompensation = false;
    else
        readAgain.start();
    if (!readProblem || !saysTheSame(*readProblem, error)) {
        readProblem = error;
        logError(error);
    }
    update();
}

void WizardController::Private::liveFailed(const Error& error)
{
    if (error.code == ErrorCode::Cancelled)
        return;
    if (isLinkFailure(error.code)) {
        if (DriveConnection* drive = connection())
            drive->lose(error);
        return;
    }
    if (liveProblem && saysTheSame(*liveProblem, error))
        return;
    liveProblem = error;
    logError(error);
}

/// A refusal by the drive is in the store too, whichever program it was that ran into it.
void WizardController::Private::takeFlash(const AxisReading& now)
{
    flash = wearGuard(profile.flashWear, now.flashHistory);
    if (now.flashUse)
        flashUse = now.flashUse;
}

FlashBudget WizardController::Private::flashBudget() const
{
    return flash.budget(std::chrono::system_clock::now());
}

} // namespace axiscomp::ui
