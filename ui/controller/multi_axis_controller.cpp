// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/multi_axis_controller.h"

#include "ui/async/background_job.h"
#include "ui/outcome/multi_axis_outcome.h"
#include "ui/session/axis_list.h"

#include <QFileInfo>

#include <algorithm>
#include <atomic>

namespace axiscomp::ui {

MultiAxisController::MultiAxisController(const DriveProfile& profile, const DriveList& drives,
    AxisState& axis, SetupModel& setup, const TableSelection& tables, OperationRunner& runner,
    LastOutcome& outcome)
    : m_profile(profile)
    , m_drives(drives)
    , m_axis(axis)
    , m_setup(setup)
    , m_tables(tables)
    , m_runner(runner)
    , m_outcome(outcome)
{
}

std::vector<DimSource> MultiAxisController::sources() const
{
    const auto& data = m_tables.file().file().data;
    const EditedSetup& edited = m_setup.edited();
    std::vector<DimSource> sources;
    const auto count = data ? static_cast<std::size_t>(data->grid.dimensions()) : 0;
    for (std::size_t n = 0; n < count; ++n) {
        if (!edited.sources.at(n).isSet())
            return {};
        sources.push_back(edited.sources[n]);
    }
    return sources;
}

DimSource MultiAxisController::ownPosition(int axis) const
{
    return positionSource({m_profile, m_drives.sourceShortlist(), {}}, axis);
}

void MultiAxisController::plan(const std::vector<ColumnForAxis>& columns, SourcesForSeveral lookup)
{
    WriteRequest common;
    common.dimensionality = m_tables.file().file().data->grid.dimensions();
    common.persistency = m_setup.edited().persistency;
    common.lookupAt = m_tables.file().file().lookupAt;
    common.measuredDrive = m_tables.file().file().measuredDrive;
    if (lookup == SourcesForSeveral::OfPage) {
        for (const DimSource& source : sources())
            common.sources.push_back(requestedSource(source));
    }
    std::vector<AxisTable> tables;
    for (const ColumnForAxis& column : columns) {
        tables.push_back({column.axis, m_tables.file().table(column.column), common});
        if (lookup == SourcesForSeveral::OwnPosition)
            tables.back().request.sources = {requestedSource(ownPosition(column.axis))};
    }
    ask(Task::WriteSeveral,
        [tables, problem = m_tables.file().file().noteProblem](AxisCompensator& compensator,
            const OperationOptions& options) -> Result<PlannedTables> {
            if (problem)
                return fail(*problem);
            AXISCOMP_TRY(auto plans, planTables(compensator, tables, options));
            return PlannedTables{tables, std::move(plans)};
        });
    m_fileName = QFileInfo(m_tables.file().file().path).fileName();
}

void MultiAxisController::planImport(const std::shared_ptr<const TamConfiguration>& configuration,
    std::size_t station, bool acceptsOther)
{
    ask(Task::Import,
        [&profile = m_profile, configuration, station, acceptsOther](
            AxisCompensator& compensator, const OperationOptions& options) {
            return axiscomp::planImport(
                compensator, profile, *configuration, station, acceptsOther, options);
        });
}

void MultiAxisController::planRestoreDrive(
    const std::shared_ptr<const DriveBackup>& backup, bool acceptsOther)
{
    ask(Task::RestoreDrive,
        [backup, acceptsOther](AxisCompensator& compensator, const OperationOptions& options) {
            return planDriveRestoration(compensator, *backup, acceptsOther, options);
        });
}

void MultiAxisController::ask(Task task, DriveSession::Operation<PlannedTables> operation)
{
    drop();
    m_task = task;
    m_stop = std::stop_source();
    whenDone(m_drives.connection()->session().run<PlannedTables>(
                 std::move(operation), m_stop.get_token()),
        this, [this, number = m_number](const Result<PlannedTables>& planned) {
            if (number == m_number)
                take(planned);
        });
}

void MultiAxisController::drop()
{
    m_stop.request_stop();
    ++m_number;
    m_asked.clear();
    m_fileName.clear();
    m_files.clear();
    m_plans.reset();
}

void MultiAxisController::take(const Result<PlannedTables>& found)
{
    if (!found) {
        m_plans = fail(found.error());
        if (isLinkFailure(found.error().code))
            m_axis.take(fail(found.error()));
    } else {
        m_plans = found->plans;
        m_asked = found->tables;
        m_files = found->files;
        // What has been shown is what is written: a drive that has changed since refuses it.
        for (std::size_t n = 0; n < m_asked.size(); ++n)
            expectAsPlanned(m_asked[n].request, found->plans.at(n));
    }
    Q_EMIT planned();
}

/// In their order.
std::vector<AxisEntry> MultiAxisController::axesOfTables() const
{
    const std::vector<AxisEntry> usable = m_drives.usableAxes();
    std::vector<AxisEntry> asked;
    for (const AxisTable& table : m_asked) {
        const auto entry = std::ranges::find_if(
            usable, [&](const AxisEntry& candidate) { return candidate.axis.index == table.axis; });
        asked.push_back(entry == usable.end() ? AxisEntry() : *entry);
        asked.back().axis.index = table.axis; // also of one that has gone meanwhile
    }
    return asked;
}

void MultiAxisController::write(bool acceptsLarge)
{
    if (m_asked.empty() || !m_plans || !*m_plans) {
        m_outcome.refuse([] { return tr("The writes have not been planned yet."); });
        return;
    }
    for (AxisTable& asked : m_asked)
        asked.request.acceptsLarge = acceptsLarge;
    const std::vector<AxisEntry> axes = axesOfTables();
    const auto turn = std::make_shared<std::atomic<std::size_t>>(0);
    m_runner.run<MultiAxisReport>(
        m_task,
        [shown = m_drives.currentAxis(), tables = m_asked, files = m_files, turn](
            auto& compensator, const auto& store, const auto& options) {
            return writeTables(compensator, store, shown, tables, *turn, options, files);
        },
        [this, tables = m_asked](const OperationEnd<MultiAxisReport>& end) { take(tables, end); },
        [axes](const Result<MultiAxisReport>& report) { return multiAxisOutcome(axes, report); },
        [axes, turn] { return axisNameOnDrive(axes.at(std::min(turn->load(), axes.size() - 1))); });
}

void MultiAxisController::take(
    const std::vector<AxisTable>& tables, const OperationEnd<MultiAxisReport>& end)
{
    bool isShownAxisWritten = false;
    for (std::size_t n = 0; end.outcome && n < end.outcome->writes.size(); ++n) {
        if (tables[n].axis != m_drives.currentAxis() || !holdsNewState(end.outcome->writes[n]))
            continue;
        isShownAxisWritten = true;
        m_runner.expect(tables[n].table);
    }
    m_axis.take(end.now);
    if (isShownAxisWritten && m_task == Task::WriteSeveral)
        m_setup.setTable({}); // the drive has it now
    if (isShownAxisWritten && m_task == Task::RestoreDrive)
        m_setup.revert(); // going back means the changes too
    const QString file = m_fileName;
    drop();
    for (std::size_t n = 0; end.outcome && n < end.outcome->writes.size(); ++n) {
        const auto& write = end.outcome->writes[n];
        if (!write)
            continue;
        if (m_drives.hasCurrent() && !file.isEmpty() && tables[n].table.table)
            Q_EMIT columnWritten(m_drives.currentEntry().endpoint, write->now, file,
                QString::fromStdString(tables[n].table.table->name));
        Q_EMIT tableWritten(write->now);
    }
}

} // namespace axiscomp::ui
