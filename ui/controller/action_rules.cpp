// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/action_rules.h"

#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QCoreApplication>

#include <initializer_list>
#include <optional>

namespace axiscomp::ui {

namespace {

using Unfinished = ActionSnapshot::Unfinished;

/// A sentence; nothing: it can be done.
using Obstacle = std::optional<QString>;

/// Each check knows one obstacle. What stands against an action is a list of checks, the most
/// important first: the first that finds something is the reason.
class Rules {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::ActionRules)

public:
    explicit Rules(const ActionSnapshot& now) : m_now(now) { }

    [[nodiscard]] ActionState state(Action action) const;
    [[nodiscard]] QString hint() const;

private:
    using Check = Obstacle (Rules::*)() const;
    [[nodiscard]] Obstacle first(std::initializer_list<Check> checks) const;
    [[nodiscard]] Obstacle obstacle(Action action) const;
    [[nodiscard]] QString consequence(Action action) const;
    [[nodiscard]] QString writeConsequence() const;

    // The way to the axis
    [[nodiscard]] Obstacle noDrive() const;
    [[nodiscard]] Obstacle noChoice() const;
    [[nodiscard]] Obstacle unreachable() const;
    [[nodiscard]] Obstacle unknown() const;
    // What runs
    [[nodiscard]] Obstacle busy() const;
    [[nodiscard]] Obstacle reading() const;
    [[nodiscard]] Obstacle nothingToStop() const;
    // What the drive says
    [[nodiscard]] Obstacle active() const;
    [[nodiscard]] Obstacle activeAlready() const;
    [[nodiscard]] Obstacle evaluatingAlready() const;
    [[nodiscard]] Obstacle offAlready() const;
    [[nodiscard]] Obstacle noDriveTable() const;
    [[nodiscard]] Obstacle nothingToDelete() const;
    [[nodiscard]] Obstacle mixture() const;
    [[nodiscard]] Obstacle notHomed() const;
    [[nodiscard]] Obstacle noBackup() const;
    [[nodiscard]] Obstacle noFlash() const;
    [[nodiscard]] bool removesFromFlash() const;
    [[nodiscard]] Obstacle nothingUnfinished() const;
    [[nodiscard]] Obstacle interrupted() const;
    [[nodiscard]] Obstacle notFinishable() const;
    [[nodiscard]] Obstacle notUndoable() const;
    // What the user has chosen
    [[nodiscard]] Obstacle unchanged() const;
    [[nodiscard]] Obstacle nothingToWrite() const;
    [[nodiscard]] Obstacle unwritten() const;
    [[nodiscard]] Obstacle unfit() const;
    [[nodiscard]] Obstacle notSeveral() const;

    const ActionSnapshot& m_now;
};

Obstacle Rules::first(std::initializer_list<Check> checks) const
{
    for (const Check check : checks) {
        if (Obstacle found = (this->*check)())
            return found;
    }
    return {};
}

Obstacle Rules::obstacle(Action action) const
{
    using R = Rules;
    switch (action) {
    case Action::Write:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::active,
            &R::nothingToWrite, &R::reading, &R::unfit, &R::noFlash});
    case Action::Activate:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::activeAlready,
            &R::unwritten, &R::noDriveTable, &R::unfit, &R::mixture, &R::notHomed});
    case Action::Evaluate:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::active,
            &R::evaluatingAlready, &R::unwritten, &R::noDriveTable, &R::unfit, &R::mixture});
    case Action::Deactivate:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::offAlready});
    case Action::Revert:
        return first({&R::noChoice, &R::busy, &R::unchanged});
    case Action::RestorePrevious:
        return first(
            {&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::active, &R::noBackup});
    case Action::RestoreBackup:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::active});
    case Action::DeleteTable:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::active,
            &R::nothingToDelete});
    case Action::FinishWrite:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::nothingUnfinished,
            &R::active, &R::notFinishable});
    case Action::UndoWrite:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::nothingUnfinished,
            &R::active, &R::notUndoable});
    case Action::Refresh:
        return first({&R::noDrive, &R::busy});
    case Action::OpenData:
        return first({&R::busy});
    case Action::WriteSeveral:
        return first(
            {&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::reading, &R::notSeveral});
    case Action::ImportConfiguration:
    case Action::ExportConfiguration:
        return first(
            {&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::reading, &R::interrupted});
    case Action::BackUpDrive:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown});
    case Action::RestoreDrive:
        return first({&R::noChoice, &R::unreachable, &R::busy, &R::unknown, &R::interrupted});
    case Action::Cancel:
        break;
    }
    return first({&R::nothingToStop});
}

Obstacle Rules::noDrive() const
{
    if (!m_now.hasDrives)
        return tr("No drive is connected: add a connection first.");
    return {};
}

Obstacle Rules::noChoice() const
{
    if (Obstacle found = noDrive())
        return found;
    if (!m_now.hasAxis)
        return m_now.isConnecting ? tr("Reading the axes of the drives.")
                                  : tr("Choose an axis first.");
    return {};
}

Obstacle Rules::unreachable() const
{
    if (!m_now.isConnected)
        return tr("The drive is not connected.");
    if (!m_now.hasCompensation)
        return tr("This axis has no compensation registers.");
    return {};
}

Obstacle Rules::unknown() const
{
    if (m_now.isKnown)
        return {};
    return m_now.readProblem ? errorText(*m_now.readProblem) : tr("The axis is being read.");
}

Obstacle Rules::busy() const
{
    if (m_now.task)
        return tr("Please wait: %1.").arg(taskText(*m_now.task));
    return {};
}

Obstacle Rules::reading() const
{
    if (m_now.isReadingFile)
        return tr("The file is being read.");
    return {};
}

Obstacle Rules::nothingToStop() const
{
    if (m_now.isReadingFile)
        return {};
    if (!m_now.task)
        return tr("Nothing is running.");
    if (!m_now.canCancel)
        return tr("It is already being stopped.");
    return {};
}

Obstacle Rules::active() const
{
    if (m_now.isActive)
        return tr("The compensation is active: deactivate it first.");
    return {};
}

Obstacle Rules::activeAlready() const
{
    if (m_now.isActive)
        return tr("The compensation is already active.");
    return {};
}

Obstacle Rules::evaluatingAlready() const
{
    if (m_now.isEvaluating)
        return tr("The compensation is already being evaluated.");
    return {};
}

Obstacle Rules::offAlready() const
{
    if (!m_now.isActive && !m_now.isEvaluating && !m_now.problem)
        return tr("The compensation is not active.");
    return {};
}

Obstacle Rules::noDriveTable() const
{
    if (!m_now.hasDriveTable)
        return tr("The axis has no table on the drive: write one first.");
    return {};
}

Obstacle Rules::nothingToDelete() const
{
    if (!m_now.hasDriveTable)
        return tr("The axis has no table on the drive.");
    return {};
}

Obstacle Rules::mixture() const
{
    if (m_now.unfinished == Unfinished::Unknown)
        return tr("What an earlier write left is not known: write again or restore another "
                  "backup.");
    if (m_now.unfinished == Unfinished::Mixture)
        return tr("An earlier write left the axis in neither the old nor the new state: write "
                  "again or restore the previous state.");
    return {};
}

Obstacle Rules::notHomed() const
{
    if (!m_now.isHomed)
        return tr("The axis must be homed first.");
    return {};
}

Obstacle Rules::noBackup() const
{
    if (!m_now.hasBackup)
        return tr("This axis has no backup yet; every write makes one.");
    return {};
}

Obstacle Rules::noFlash() const
{
    if (m_now.flashOperationsNeeded <= m_now.flashOperationsLeft)
        return {};
    if (removesFromFlash() && m_now.isFlashRecordLost)
        return tr("Removing the table from flash is a flash operation too, and the record of this "
                  "drive's flash operations was damaged, so all of them count as used up. Keep the "
                  "table persistent, or run \"axiscomp status --reset-flash-count\".");
    if (removesFromFlash())
        return tr("Removing the table from flash is a flash operation too: wait %1, or keep the "
                  "table persistent.")
            .arg(durationText(m_now.flashWaitSeconds));
    if (m_now.isFlashRecordLost)
        return tr("The record of this drive's flash operations was damaged, so all of them count "
                  "as used up. Write volatile, or run \"axiscomp status --reset-flash-count\".");
    return tr("To spare the flash, wait %1 or write volatile.")
        .arg(durationText(m_now.flashWaitSeconds));
}

/// A volatile write costs flash only where the table is in flash and stays the axis's.
bool Rules::removesFromFlash() const
{
    return m_now.flashOperationsNeeded > 0 && !m_now.isPersistent;
}

Obstacle Rules::nothingUnfinished() const
{
    if (m_now.unfinished == Unfinished::None)
        return tr("This axis has no unfinished write.");
    return {};
}

Obstacle Rules::interrupted() const
{
    if (m_now.unfinished != Unfinished::None && m_now.isBackupUnread)
        return tr("An earlier write was interrupted, and the backup of the state before it cannot "
                  "be read: write again or restore another backup first.");
    if (m_now.unfinished != Unfinished::None)
        return tr("An earlier write was interrupted: finish or undo it first.");
    return {};
}

Obstacle Rules::notFinishable() const
{
    return m_now.finishObstacle ? Obstacle(errorText(*m_now.finishObstacle)) : Obstacle();
}

Obstacle Rules::notUndoable() const
{
    return m_now.undoObstacle ? Obstacle(errorText(*m_now.undoObstacle)) : Obstacle();
}

Obstacle Rules::unchanged() const
{
    if (!m_now.isDirty)
        return tr("Nothing has changed.");
    return {};
}

Obstacle Rules::nothingToWrite() const
{
    return m_now.unfinished == Unfinished::Unsaved ? Obstacle() : unchanged();
}

Obstacle Rules::unwritten() const
{
    if (m_now.isDirty)
        return tr("The parameters still have to be saved.");
    return {};
}

/// Whether table and sources belong together and to this drive.
Obstacle Rules::unfit() const
{
    if (!m_now.hasTable)
        return tr("No table is chosen: open compensation data.");
    if (m_now.tableDimensions != m_now.dimensionality)
        return m_now.tableDimensions == 1
            ? tr("The table has 1 dimension, but %1D is chosen.").arg(m_now.dimensionality)
            : tr("The table has %1 dimensions, but %2D is chosen.")
                  .arg(m_now.tableDimensions)
                  .arg(m_now.dimensionality);
    if (m_now.isSourceBeingChecked)
        return tr("A source is being checked.");
    if (m_now.missingSource > 0)
        return tr("Dim%1 Source is missing.").arg(m_now.missingSource);
    if (m_now.repeatedSource > 0)
        return tr("Dim%1 Source is the same as another source.").arg(m_now.repeatedSource);
    if (m_now.noteProblem)
        return errorText(*m_now.noteProblem);
    if (m_now.isNewTable && m_now.tableBytes > m_now.largestSlotBytes)
        return tr("The table needs %1 bytes, but the largest slot has %2.")
            .arg(m_now.tableBytes)
            .arg(m_now.largestSlotBytes);
    return {};
}

Obstacle Rules::notSeveral() const
{
    if (m_now.fileTables < 2)
        return tr("Open a file with several columns of values first.");
    if (m_now.usableAxes < 2)
        return tr("The drive has no second axis with compensation registers.");
    return {};
}

QString Rules::writeConsequence() const
{
    if (!m_now.isDirty)
        return tr("Finishes an earlier write: saves the parameters of the drive.");
    if (removesFromFlash() && m_now.isFlashLimitKnown)
        return tr(
            "Removes the table from flash, which uses %1 of the %2 flash operations available "
            "now.")
            .arg(m_now.flashOperationsNeeded)
            .arg(m_now.flashOperationsLeft);
    if (removesFromFlash())
        return tr("Writes to the drive and removes the table from flash.");
    if (m_now.flashOperationsNeeded > 0 && m_now.isFlashLimitKnown)
        return tr("Writes to the drive and stores in flash; uses %1 of the %2 flash operations "
                  "available now.")
            .arg(m_now.flashOperationsNeeded)
            .arg(m_now.flashOperationsLeft);
    if (m_now.flashOperationsNeeded > 0)
        return tr("Writes to the drive and stores in flash.");
    if (m_now.isPersistent)
        return tr("Writes to the drive and saves its parameters; the table in flash stays.");
    return tr("Writes to the drive; a reboot of the drive restores the stored state.");
}

QString Rules::consequence(Action action) const
{
    switch (action) {
    case Action::Write:
        return writeConsequence();
    case Action::Activate:
        return tr("Adds the table to the encoder position and proves that the drive's output "
                  "matches the table.");
    case Action::Evaluate:
        return tr("The drive looks up the table without adding anything.");
    case Action::Deactivate:
        return tr("Switches the compensation off; table and settings stay on the drive.");
    case Action::Revert:
        return tr("Resets the fields to the drive's values.");
    case Action::RestorePrevious:
        return tr("Writes back the previous table and sources.");
    case Action::RestoreBackup:
        return tr("Writes back a backup that you choose.");
    case Action::DeleteTable:
        return tr("Deletes the axis's table from the drive; a backup is kept.");
    case Action::FinishWrite:
        return tr("Completes the interrupted write.");
    case Action::UndoWrite:
        return tr("Restores the state before the interrupted write.");
    case Action::Refresh:
        return tr("Searches for drives and axes again and reads the axis.");
    case Action::OpenData:
        return tr("Opens a file of compensation data, .csv or .TAMtbl.");
    case Action::WriteSeveral:
        return tr("Writes several columns of the open file, each to its own axis.");
    case Action::ImportConfiguration:
        return tr("Writes the table and source parameters of a TAM configuration to the drive.");
    case Action::ExportConfiguration:
        return tr("Puts the drive's table and source parameters into a TAM configuration.");
    case Action::BackUpDrive:
        return tr("Saves the tables and sources of all axes of the drive to a file.");
    case Action::RestoreDrive:
        return tr("Writes a backup of the whole drive back to it, axis by axis.");
    case Action::Cancel:
        break;
    }
    if (m_now.isReadingFile && !m_now.task)
        return tr("Stops reading the file.");
    return m_now.task && isWrite(*m_now.task) ? tr("Stops the write and rolls back.")
                                              : tr("Stops what is running.");
}

ActionState Rules::state(Action action) const
{
    if (Obstacle found = obstacle(action))
        return {false, *found};
    return {true, consequence(action)};
}

QString Rules::hint() const
{
    if (m_now.task)
        return asSentence(tr("%1 ...").arg(taskText(*m_now.task)));
    using R = Rules;
    if (Obstacle found =
            first({&R::noChoice, &R::unreachable, &R::unknown, &R::reading, &R::mixture}))
        return *found;
    if (Obstacle found = unwritten())
        return obstacle(Action::Write).value_or(*found);
    if (m_now.unfinished == Unfinished::Unsaved)
        return obstacle(Action::Write)
            .value_or(tr("An earlier write was interrupted: its parameters may not be saved. Write "
                         "to finish it."));
    if (m_now.problem)
        return errorText(*m_now.problem);
    if (m_now.isActive)
        return tr("The compensation is active.");
    if (Obstacle found = noDriveTable())
        return unfit().value_or(*found);
    if (m_now.isEvaluating)
        return tr("The compensation is being evaluated: the drive adds nothing.");
    return obstacle(Action::Activate).value_or(consequence(Action::Activate));
}

} // namespace

QString taskText(Task task)
{
    switch (task) {
    case Task::Plan:
        return Rules::tr("planning");
    case Task::Write:
        return Rules::tr("writing");
    case Task::WriteSeveral:
        return Rules::tr("writing several axes");
    case Task::Import:
        return Rules::tr("importing parameters");
    case Task::BackUpDrive:
        return Rules::tr("backing up the drive");
    case Task::RestoreDrive:
        return Rules::tr("restoring the drive");
    case Task::Activate:
        return Rules::tr("activating");
    case Task::Evaluate:
        return Rules::tr("evaluating");
    case Task::Deactivate:
        return Rules::tr("deactivating");
    case Task::Delete:
        return Rules::tr("deleting the table");
    case Task::Finish:
        return Rules::tr("finishing the write");
    case Task::Undo:
        return Rules::tr("undoing the write");
    case Task::Restore:
        break;
    }
    return Rules::tr("restoring");
}

ActionStates decideActions(const ActionSnapshot& now)
{
    const Rules rules(now);
    ActionStates decision;
    for (const Action action : allActions)
        decision.actions[static_cast<std::size_t>(action)] = rules.state(action);
    decision.hint = rules.hint();
    return decision;
}

} // namespace axiscomp::ui
