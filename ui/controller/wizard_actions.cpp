// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/wizard_actions.h"

#include "core/axis/activation.h"
#include "core/neutral/drive_note.h"
#include "core/write/lookup_side.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace axiscomp::ui {

WizardActions::WizardActions(const DriveProfile& profile, const DriveList& drives,
    const AxisState& axis, const SetupModel& setup, const SourceCheck& sources,
    const TableSelection& tables, const OperationRunner& runner, LastOutcome& outcome)
    : m_profile(profile)
    , m_drives(drives)
    , m_axis(axis)
    , m_setup(setup)
    , m_sources(sources)
    , m_tables(tables)
    , m_runner(runner)
    , m_outcome(outcome)
{
    m_countdown.setInterval(std::chrono::seconds{1});
    connect(&m_countdown, &QTimer::timeout, this, &WizardActions::update);
}

void WizardActions::update()
{
    const ActionSnapshot now = snapshot();
    if (now.flashWaitSeconds > 0 && !m_countdown.isActive())
        m_countdown.start();
    else if (now.flashWaitSeconds == 0)
        m_countdown.stop();
    ActionStates decided = decideActions(now);
    if (decided == m_states)
        return;
    m_states = std::move(decided);
    Q_EMIT changed();
}

bool WizardActions::mayStart(Action action)
{
    update();
    const bool may = m_states[action].isEnabled;
    if (!may)
        m_outcome.refuse([now = snapshot(), action] { return decideActions(now)[action].reason; });
    return may;
}

ActionSnapshot WizardActions::snapshot() const
{
    ActionSnapshot now;
    lookAtDrive(now);
    lookAtUnfinished(now);
    lookAtSetup(now);
    lookAtTables(now);
    now.task = m_runner.task();
    now.canCancel = m_runner.busy().canCancel;
    return now;
}

void WizardActions::lookAtDrive(ActionSnapshot& now) const
{
    const DriveConnection* drive = m_drives.connection();
    now.hasDrives = !m_drives.drives().empty();
    now.isConnecting = std::ranges::any_of(m_drives.drives(), [](const DriveState& state) {
        return state.connection == DriveState::Connection::Connecting;
    });
    now.hasAxis = m_drives.hasCurrent();
    now.usableAxes = static_cast<int>(m_drives.usableAxes().size());
    now.isConnected = drive && drive->isConnected();
    now.hasCompensation = m_axis.hasCompensation();
    now.readProblem = m_axis.readProblem();
    now.hasBackup = m_axis.hasBackup();
    const FlashBudget budget = m_axis.flashBudget();
    now.flashOperationsLeft = budget.left;
    now.flashWaitSeconds = static_cast<int>(budget.wait.count());
    now.isFlashRecordLost = budget.isRecordLost;
    now.isFlashLimitKnown = budget.left != std::numeric_limits<int>::max();
    const auto& status = m_axis.status();
    now.isKnown = status && m_axis.isJournalKnown();
    if (!status)
        return;
    now.isActive = status->isOn();
    now.isEvaluating = status->axis.state == CompensationState::Evaluating;
    now.isHomed = status->axis.isHomed;
    now.hasDriveTable = status->table.has_value();
    if (status->axis.state == CompensationState::Error)
        now.problem = compensationError(*status);
}

void WizardActions::lookAtUnfinished(ActionSnapshot& now) const
{
    using Held = AxisCompensator::UnfinishedOutcome;
    using Unfinished = ActionSnapshot::Unfinished;
    const auto& unfinished = m_axis.unfinished();
    if (!unfinished || unfinished->outcome == Held::New)
        return;
    now.unfinished = unfinished->outcome == Held::Old ? Unfinished::Old
        : unfinished->outcome == Held::NewUnsaved     ? Unfinished::Unsaved
        : unfinished->outcome == Held::Unknown        ? Unfinished::Unknown
                                                      : Unfinished::Mixture;
    now.isBackupUnread = unfinished->recovery.isBackupUnread;
    now.finishObstacle = unfinished->recovery.finishObstacle;
    now.undoObstacle = unfinished->recovery.undoObstacle;
}

void WizardActions::lookAtSetup(ActionSnapshot& now) const
{
    const EditedSetup& edited = m_setup.edited();
    now.isDirty = m_setup.isDirty();
    now.dimensionality = edited.dimensionality;
    for (int n = edited.dimensionality; n >= 1; --n) {
        const DimSource& source = edited.sources[static_cast<std::size_t>(n - 1)];
        if (!source.isSet())
            now.missingSource = n;
        const auto first = std::ranges::find(edited.sources, source);
        if (source.isSet() && first - edited.sources.begin() < n - 1)
            now.repeatedSource = n;
        if (m_sources.isBeingChecked(n))
            now.isSourceBeingChecked = true;
    }
    now.isPersistent = edited.persistency == Persistency::Persistent;
    now.isNewTable = edited.table.fileTable && m_setup.isDirty(Field::Table);
    const bool storesOrErases =
        now.isNewTable ? now.isPersistent : m_setup.isDirty(Field::Persistency);
    now.flashOperationsNeeded = storesOrErases ? 1 : 0;
}

void WizardActions::lookAtTables(ActionSnapshot& now) const
{
    for (const TableSlot& slot : m_profile.tableSlots)
        now.largestSlotBytes = std::max<std::size_t>(now.largestSlotBytes, slot.maximumSize);
    const auto& status = m_axis.status();
    if (const auto table = now.isNewTable ? m_tables.selected().table : nullptr) {
        now.hasTable = true;
        now.tableDimensions = table->grid.dimensions();
        now.tableBytes = m_tables.selectedBytes();
    } else if (!now.isNewTable && status && status->table) {
        now.hasTable = true;
        now.tableDimensions = status->table->grid.dimensions();
    }
    const DataFile& file = m_tables.file().file();
    now.fileTables = file.data ? static_cast<int>(file.data->tables.size()) : 0;
    now.isReadingFile = file.isReading;
    if (now.isNewTable)
        now.noteProblem = file.noteProblem;
    if (!now.isNewTable || !status || now.noteProblem)
        return;
    auto checked = checkMeasuredDrive(file.measuredDrive, status->drive.serialNumber);
    if (checked && file.lookupAt)
        checked = checkLookupSources(
            *file.lookupAt, m_profile, status->axis.index, sourcePaths(m_setup.edited()));
    if (!checked)
        now.noteProblem = checked.error();
}

} // namespace axiscomp::ui
