// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/axis_overview.h"

#include "core/compensator/axis_compensator.h"
#include "core/table/table_identity.h"
#include "ui/async/background_job.h"
#include "ui/session/axis_list.h"

#include <QFileInfo>
#include <QPointer>

#include <algorithm>

namespace axiscomp::ui {

namespace {

bool isSameAxis(const OverviewRow& a, const OverviewRow& b)
{
    return a.endpoint == b.endpoint && a.serialNumber == b.serialNumber && a.axis == b.axis;
}

OverviewRow rowOf(const DriveState& drive)
{
    OverviewRow row;
    row.endpoint = drive.endpoint;
    row.driveName = drive.name;
    row.connection = drive.connection;
    row.lostSince = drive.lostSince;
    row.driveProblem = drive.problem;
    return row;
}

/// With sources that tell where it is looked up: elsewhere nothing is proved of it.
bool hasSameTable(const AxisStatus& a, const AxisStatus& b)
{
    if (!a.table || !b.table)
        return !a.table && !b.table;
    return isSameTable(identityOf(*a.table), identityOf(*b.table))
        && a.setup.sources == b.setup.sources;
}

} // namespace

AxisOverview::AxisOverview(DriveList& drives, const AxisState& axis, const ProofFollower& proof,
    const TableSelection& tables, const OperationRunner& runner, std::chrono::milliseconds interval)
    : m_drives(drives)
    , m_axis(axis)
    , m_proof(proof)
    , m_tables(tables)
    , m_runner(runner)
{
    m_timer.setInterval(interval);
    connect(&m_timer, &QTimer::timeout, this, &AxisOverview::readNow);
    for (const auto changed : {&DriveList::drivesChanged, &DriveList::axesChanged})
        connect(&drives, changed, this, &AxisOverview::list);
    connect(&drives, &DriveList::removed, this,
        [this](const DriveConnection* removed) { m_underWay.erase(removed); });
    for (const auto changed : {&AxisState::statusChanged, &AxisState::liveChanged})
        connect(&axis, changed, this, &AxisOverview::takeCurrent);
    connect(&tables.driveTable(), &DriveTable::changed, this, &AxisOverview::takeCurrent);
    connect(&tables, &TableSelection::changed, this, &AxisOverview::noteSelected);
    connect(&runner, &OperationRunner::busyChanged, this, &AxisOverview::makeWay);
}

AxisOverview::~AxisOverview()
{
    for (auto& [drive, stop] : m_underWay)
        stop.request_stop();
}

void AxisOverview::follow(bool isFollowed)
{
    if (m_isFollowed == isFollowed)
        return;
    m_isFollowed = isFollowed;
    if (!isFollowed) {
        m_timer.stop();
        return;
    }
    if (m_timer.interval() > 0)
        m_timer.start();
    readNow();
}

void AxisOverview::readNow()
{
    for (DriveConnection* drive : m_drives.connections()) {
        const bool isInUse = m_runner.task() && drive == m_drives.connection();
        if (drive->isConnected() && !isInUse && !m_underWay.contains(drive))
            read(*drive);
    }
}

void AxisOverview::read(DriveConnection& drive)
{
    std::stop_source stop;
    m_underWay[&drive] = stop;
    const auto look = [store = drive.session().storeRoot()](
                          AxisCompensator& compensator, const OperationOptions& options) {
        return summarizeDrive(compensator, store, options);
    };
    whenDone(drive.session().run<DriveSummary>(look, stop.get_token()), this,
        [this, asked = QPointer(&drive)](const Result<DriveSummary>& summary) {
            if (asked && m_underWay.erase(asked) > 0)
                take(*asked, summary);
        });
}

void AxisOverview::take(DriveConnection& drive, const Result<DriveSummary>& summary)
{
    if (!summary) {
        if (isLinkFailure(summary.error().code))
            drive.lose(summary.error());
        return;
    }
    if (!drive.findings() || drive.findings()->drive.serialNumber != summary->drive.serialNumber) {
        drive.explore(); // another drive answers: it is looked at from the beginning
        return;
    }
    for (OverviewRow& row : m_rows) {
        if (row.endpoint != drive.endpoint() || !row.axis)
            continue;
        const auto found = std::ranges::find_if(
            summary->axes, [&](const AxisSummary& axis) { return axis.axis.index == *row.axis; });
        if (found == summary->axes.end())
            continue;
        row.flashUse = summary->flashUse;
        row.lastWrite = found->lastWrite;
        row.problem = found->problem;
        if (found->status)
            put(row, *found->status);
        row.measured = found->measured; // of the table that the axis has now
        announce(row);
    }
}

/// What is known of a table ends with it.
void AxisOverview::put(OverviewRow& row, const AxisStatus& status) const
{
    if (row.status && !hasSameTable(*row.status, status)) {
        row.file.clear();
        row.column.clear();
        row.measured.reset();
        row.proof.reset();
    }
    row.status = status;
    row.read = QDateTime::currentDateTime();
}

OverviewRow* AxisOverview::currentRow()
{
    if (m_drives.currentIndex() < 0)
        return nullptr;
    const AxisEntry& current = m_drives.currentEntry();
    const auto found = std::ranges::find_if(m_rows, [&](const OverviewRow& row) {
        return row.endpoint == current.endpoint && row.axis == current.axis.index;
    });
    return found == m_rows.end() ? nullptr : &*found;
}

/// The page reads its axis more often than the overview does, and knows more of its table.
void AxisOverview::takeCurrent()
{
    OverviewRow* row = currentRow();
    const auto& status = m_axis.status();
    if (!row || !status || !row->isConnected())
        return;
    put(*row, *status);
    row->problem.reset();
    const auto& table = m_tables.driveTable().table().table;
    if (table && !table->name.empty())
        row->column = QString::fromStdString(table->name);
    if (table && table == m_selected)
        row->file = m_selectedFile;
    // While the table changes the proof is still that of the one before.
    if (const auto& proof = m_proof.proof();
        proof && proof->table() == table && (proof->failure() || proof->hasContent()))
        row->proof =
            OverviewRow::Proof{proof->part().share(), proof->failure().has_value(), row->read};
    announce(*row);
}

void AxisOverview::noteSelected()
{
    if (!m_tables.selectedOfFile().table)
        return;
    m_selected = m_tables.selected().table;
    m_selectedFile = QFileInfo(m_tables.file().file().path).fileName();
}

void AxisOverview::noteWritten(
    const QString& endpoint, const AxisStatus& now, const QString& file, const QString& column)
{
    const auto row = std::ranges::find_if(m_rows, [&](const OverviewRow& candidate) {
        return candidate.endpoint == endpoint && candidate.axis == now.axis.index
            && candidate.serialNumber == now.drive.serialNumber;
    });
    if (row == m_rows.end())
        return;
    put(*row, now);
    row->file = file;
    row->column = column;
    announce(*row);
}

/// An operation does not wait for the overview.
void AxisOverview::makeWay()
{
    const auto found = m_underWay.find(m_drives.connection());
    if (m_runner.task() && found != m_underWay.end())
        found->second.request_stop();
}

/// The rows of now, with what is known of those that were there before.
void AxisOverview::list()
{
    std::vector<OverviewRow> now;
    for (const DriveConnection* drive : m_drives.connections()) {
        const OverviewRow ofDrive = rowOf(drive->state());
        const std::size_t before = now.size();
        for (const AxisEntry& entry : m_drives.axes()) {
            if (entry.endpoint != ofDrive.endpoint)
                continue;
            OverviewRow& row = now.emplace_back(ofDrive);
            row.serialNumber = entry.serialNumber;
            row.axis = entry.axis.index;
            row.axisName = axisNameOnDrive(entry);
            row.hasCompensation = entry.axis.hasCompensation();
        }
        if (now.size() == before)
            now.push_back(ofDrive);
    }
    for (OverviewRow& row : now) {
        const auto known = std::ranges::find_if(
            m_rows, [&](const OverviewRow& other) { return isSameAxis(row, other); });
        if (known == m_rows.end())
            continue;
        row.status = known->status;
        row.read = known->read;
        row.problem = known->problem;
        row.lastWrite = known->lastWrite;
        row.measured = known->measured;
        row.flashUse = known->flashUse;
        row.file = known->file;
        row.column = known->column;
        row.proof = known->proof;
    }
    const bool isSame = std::ranges::equal(now, m_rows, isSameAxis);
    m_rows = std::move(now);
    if (!isSame)
        Q_EMIT rowsReset();
    else
        for (const OverviewRow& row : m_rows)
            announce(row);
    if (m_isFollowed && !isSame)
        readNow();
}

void AxisOverview::announce(const OverviewRow& row)
{
    Q_EMIT rowChanged(static_cast<int>(&row - m_rows.data()));
}

} // namespace axiscomp::ui
