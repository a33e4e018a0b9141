// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/machine_controller.h"

#include "ui/text/endpoint_text.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QFileInfo>

#include <algorithm>
#include <functional>
#include <utility>

namespace axiscomp::ui {

namespace {

std::shared_ptr<const OpenMachine> openMachine(
    const QString& path, const TableLayout& layout, const std::stop_token& stop)
{
    auto opened = std::make_shared<OpenMachine>();
    opened->path = path;
    const std::string file = path.toStdString();
    auto reading = loadMachine(file);
    if (!reading) {
        opened->refusal = std::move(reading).error();
        return opened;
    }
    opened->reading = *std::move(reading);
    if (!opened->reading.machine)
        opened->refusal = machineError(file, opened->reading);
    else
        opened->tables =
            readMachineTables(*opened->reading.machine, opened->folder(), layout, stop);
    return opened;
}

} // namespace

std::filesystem::path OpenMachine::folder() const
{
    return std::filesystem::path(path.toStdString()).parent_path();
}

MachineController::MachineController(const DriveProfile& profile, DriveList& drives,
    AxisState& axis, const AxisOverview& overview, OperationRunner& runner, WizardLog& log,
    LastOutcome& outcome)
    : m_profile(profile)
    , m_drives(drives)
    , m_overview(overview)
    , m_runner(runner)
    , m_application(drives, axis, runner, log, outcome)
    , m_saving(profile, drives)
    , m_job([this](const Opening& opening) { take(opening); })
{
    for (const auto changed : {&DriveList::drivesChanged, &DriveList::axesChanged})
        connect(&drives, changed, this, &MachineController::follow);
    connect(&overview, &AxisOverview::rowChanged, this, &MachineController::followRow);
    connect(&m_application, &MachineApplication::ended, this, &MachineController::askAll);
    connect(&runner, &OperationRunner::busyChanged, this, &MachineController::followOperation);
}

MachineController::~MachineController()
{
    stopAsking();
}

QString MachineController::path() const
{
    return isReading() ? m_reading : m_file ? m_file->path : QString();
}

void MachineController::open(const QString& path)
{
    if (m_file && m_file->path != path)
        close();
    read(path);
}

void MachineController::planAgain()
{
    if (const QString again = path(); !again.isEmpty())
        read(again);
}

void MachineController::read(const QString& path)
{
    m_reading = path;
    m_job.start([path, &layout = m_profile.layout](
                    const std::stop_token& stop) { return openMachine(path, layout, stop); });
    Q_EMIT fileChanged();
}

void MachineController::close()
{
    m_job.cancel();
    stopAsking();
    m_reading.clear();
    m_file.reset();
    m_machine.clear();
    m_asking.clear();
    m_seen.clear();
    Q_EMIT fileChanged();
    Q_EMIT driftChanged();
}

void MachineController::stopAsking()
{
    for (const Asking& asking : m_asking)
        asking.stop.request_stop();
}

/// What was known of a drive that is still in the file stays until it is known anew.
void MachineController::take(const Opening& opening)
{
    stopAsking();
    m_reading.clear();
    m_file = opening;
    const std::vector<Drive> before = std::exchange(m_machine, {});
    m_asking.clear();
    if (opening->reading.machine)
        for (const MachineDrive& wanted : opening->reading.machine->drives) {
            Drive& drive = m_machine.emplace_back();
            drive.wanted = wanted;
            drive.endpoint = shownEndpoint(QString::fromStdString(wanted.endpoint));
            const auto known = std::ranges::find(before, drive.endpoint, &Drive::endpoint);
            if (known != before.end() && known->wanted == wanted) {
                drive.look = known->look;
                drive.looked = known->looked;
            }
        }
    m_asking.resize(m_machine.size());
    for (Asking& asking : m_asking)
        asking.mustAsk = true;
    connectDrives();
    follow();
    Q_EMIT fileChanged();
    Q_EMIT driftChanged();
}

/// Those that are there stay as they are: the file may lack the password that the user has given.
void MachineController::connectDrives()
{
    QStringList endpoints = m_drives.endpoints();
    const auto before = endpoints.size();
    for (const Drive& drive : m_machine)
        if (!connectionOf(drive))
            endpoints += QString::fromStdString(drive.wanted.endpoint);
    if (endpoints.size() != before)
        m_drives.setEndpoints(endpoints);
}

DriveConnection* MachineController::connectionOf(const Drive& drive) const
{
    return m_drives.connectionTo(drive.endpoint);
}

/// A drive that has not been asked yet, answers again, or is another one now is asked.
void MachineController::follow()
{
    bool isNews = false;
    for (std::size_t n = 0; n < m_machine.size(); ++n) {
        Drive& drive = m_machine[n];
        const DriveConnection* connection = connectionOf(drive);
        isNews = isNews || drive.isConnected != (connection != nullptr);
        drive.isConnected = connection != nullptr;
        if (!connection) {
            m_asking[n].stop.request_stop();
            m_asking[n] = {};
            drive.look.reset();
            drive.isBeingAsked = false;
            continue;
        }
        if (const auto& problem = connection->problem(); problem && !connection->isConnected()) {
            const bool isKnown =
                drive.look && drive.look->problem && saysTheSame(*drive.look->problem, *problem);
            if (!isKnown)
                put(n, std::make_shared<const DriveLook>(DriveLook{{}, problem}));
            isNews = isNews || !isKnown;
        } else if (connection->isConnected() && connection->findings()) {
            const bool isOther =
                m_asking[n].serialNumber != connection->findings()->drive.serialNumber;
            const bool wasMissing = !drive.look || drive.look->isMissing();
            if (m_asking[n].mustAsk || isOther || (wasMissing && !drive.isBeingAsked))
                ask(n);
        }
    }
    if (isNews)
        Q_EMIT driftChanged();
}

/// The current drive is left alone while something runs on it, and compared when that has ended.
void MachineController::followOperation()
{
    const bool isRunning = m_runner.task().has_value();
    for (std::size_t n = 0; n < m_machine.size(); ++n) {
        if (connectionOf(m_machine[n]) != m_drives.connection())
            continue;
        if (isRunning && !m_wasRunning) {
            m_asking[n].stop.request_stop();
            m_asking[n].mustAsk = true;
        } else if (!isRunning && m_asking[n].mustAsk) {
            ask(n);
        }
    }
    m_wasRunning = isRunning;
}

/// What somebody else has changed ends what was known.
void MachineController::followRow(int row)
{
    const OverviewRow& now = m_overview.rows().at(static_cast<std::size_t>(row));
    if (!now.axis || !now.status || m_machine.empty())
        return;
    const auto seenIn = [](const AxisStatus& status) {
        return std::pair(status.setup, status.isOn());
    };
    const auto seen = seenIn(*now.status);
    const auto [known, isFirst] = m_seen.try_emplace(std::pair(now.endpoint, *now.axis), seen);
    if (isFirst) {
        // What was compared may be older than the first that the overview says.
        const AxisDrift drift = driftOf(now.endpoint, now.axis);
        if (!drift.plan || drift.plan->problem || seenIn(drift.plan->before) == seen)
            return;
    } else if (known->second == seen) {
        return;
    }
    known->second = seen;
    const auto drive = std::ranges::find(m_machine, now.endpoint, &Drive::endpoint);
    if (drive != m_machine.end())
        ask(static_cast<std::size_t>(drive - m_machine.begin()));
}

bool MachineController::isAsking() const
{
    return std::ranges::any_of(m_machine, &Drive::isBeingAsked);
}

void MachineController::ask(std::size_t index)
{
    Drive& drive = m_machine[index];
    Asking& asking = m_asking[index];
    DriveConnection* connection = connectionOf(drive);
    asking.mustAsk = true;
    if (!connection || !connection->isConnected()
        || (m_runner.task() && connection == m_drives.connection()))
        return;
    asking.stop.request_stop();
    asking = {std::stop_source(), ++m_number, false, connection->findings()->drive.serialNumber};
    drive.isBeingAsked = true;
    const auto look = [file = m_file, index, &profile = m_profile, activates = m_activates,
                          store = connection->session().storeRoot()](AxisCompensator& compensator,
                          const OperationOptions& options) -> Result<Look> {
        auto made = std::make_shared<DriveLook>();
        auto plan = planDrive(compensator, profile, file->reading.machine->drives[index],
            file->tables[index], {file->folder(), store, activates}, options);
        if (plan)
            made->plan = *std::move(plan);
        else
            made->problem = std::move(plan).error();
        return Look(std::move(made));
    };
    whenDone(connection->session().run<Look>(look, asking.stop.get_token()), this,
        [this, index, number = asking.number](const Result<Look>& made) {
            take(index, number,
                made ? *made : std::make_shared<const DriveLook>(DriveLook{{}, made.error()}));
        });
    Q_EMIT driftChanged();
}

void MachineController::take(std::size_t index, int number, const Look& look)
{
    if (index >= m_asking.size() || m_asking[index].number != number)
        return;
    Drive& drive = m_machine[index];
    drive.isBeingAsked = false;
    if (!look->problem || look->problem->code != ErrorCode::Cancelled)
        put(index, look);
    DriveConnection* connection = connectionOf(drive);
    if (connection && look->problem && isLinkFailure(look->problem->code))
        connection->lose(*look->problem);
    Q_EMIT driftChanged();
}

void MachineController::put(std::size_t index, const Look& look)
{
    m_machine[index].look = look;
    m_machine[index].looked = QDateTime::currentDateTime();
}

AxisDrift MachineController::driftOf(const Drive& drive, std::optional<std::size_t> axis)
{
    using State = AxisDrift::State;
    AxisDrift drift{State::Waiting, drive.looked, drive.isBeingAsked, drive.look};
    if (!drive.isConnected) {
        drift.state = State::NotConnected;
    } else if (drive.look && drive.look->problem) {
        drift.state = drive.look->isMissing() ? State::Unreachable : State::Problem;
    } else if (drive.look && drive.look->plan) {
        if (!axis) {
            drift.state = State::NotInFile;
            return drift;
        }
        drift.axis = axis;
        drift.plan = &drive.look->plan->axes.at(*axis);
        drift.state = drift.plan->problem ? State::Problem
            : drift.plan->differs()       ? State::Differs
                                          : State::AsFile;
    }
    return drift;
}

AxisDrift MachineController::driftOf(const QString& endpoint, std::optional<int> axis) const
{
    const auto drive = std::ranges::find(m_machine, endpoint, &Drive::endpoint);
    if (drive == m_machine.end())
        return {};
    std::optional<std::size_t> index;
    if (axis && drive->look && drive->look->plan) {
        const auto& plans = drive->look->plan->axes;
        const auto plan = std::ranges::find(plans, *axis, &AxisPlan::axis);
        if (plan != plans.end())
            index = static_cast<std::size_t>(plan - plans.begin());
    }
    AxisDrift drift = driftOf(*drive, index);
    drift.drive = &*drive;
    return drift;
}

QDateTime MachineController::oldestLook() const
{
    QDateTime oldest;
    for (const Drive& drive : m_machine)
        if (drive.looked.isValid() && (!oldest.isValid() || drive.looked < oldest))
            oldest = drive.looked;
    return oldest;
}

void MachineController::askAll()
{
    for (std::size_t n = 0; n < m_machine.size(); ++n)
        ask(n);
}

void MachineController::setActivates(bool activates)
{
    if (std::exchange(m_activates, activates) != activates)
        askAll();
}

std::vector<MachineController::Obstacle> MachineController::obstacles(bool allowsMissing) const
{
    std::vector<Obstacle> obstacles;
    for (const Drive& drive : m_machine)
        for (const PlanProblem& problem :
            drive.look ? drive.look->problems(allowsMissing) : std::vector<PlanProblem>())
            obstacles.push_back({&drive, problem});
    return obstacles;
}

bool MachineController::isToBeChanged(const AxisPlan& plan) const
{
    return !plan.problem && (plan.writes() || (m_activates && plan.switches.has_value()));
}

QString MachineController::applyObstacle(bool allowsMissing) const
{
    if (!m_file && !isReading())
        return tr("No machine file is open.");
    if (isReading())
        return tr("The machine file is being read.");
    if (m_file->refusal)
        return errorText(*m_file->refusal);
    if (m_application.isRunning())
        return tr("The machine file is being applied.");
    if (m_runner.task())
        return tr("Wait for the end of the current operation.");
    const auto isUnknown = [](const Drive& drive) {
        return drive.isBeingAsked || (!drive.look && drive.isConnected);
    };
    if (std::ranges::any_of(m_machine, isUnknown))
        return tr("The drives are being compared.");
    const bool isLeftOut = std::ranges::any_of(m_machine, std::not_fn(&Drive::isConnected));
    if (isLeftOut && !allowsMissing)
        return tr("Not all drives of the file are among the connections.");
    if (!obstacles(allowsMissing).empty())
        return tr("Nothing is written while something stands in the way of a part of it.");
    std::vector<const DriveLook*> looks;
    for (const Drive& drive : m_machine)
        looks.push_back(drive.look.get());
    if (!doesAnyAnswer(looks))
        return tr("No drive of the file answers.");
    const bool isAnyChanged = std::ranges::any_of(m_machine, [this](const Drive& drive) {
        return drive.look && drive.look->plan
            && std::ranges::any_of(drive.look->plan->axes,
                [this](const AxisPlan& plan) { return isToBeChanged(plan); });
    });
    return isAnyChanged ? QString() : tr("All drives have what the file says.");
}

void MachineController::apply()
{
    std::vector<MachineApplication::Planned> planned;
    for (const Drive& drive : m_machine) {
        if (!drive.isConnected || !drive.look || !drive.look->plan)
            continue;
        QStringList files;
        for (const MachineAxis& axis : drive.wanted.axes)
            files += QFileInfo(QString::fromStdString(axis.file)).fileName();
        planned.push_back(
            {drive.endpoint, qString(drive.look->plan->drive.name), drive.look, files});
    }
    m_application.start(QFileInfo(m_file->path).fileName(), std::move(planned),
        {m_file->folder(), {}, m_activates});
}

} // namespace axiscomp::ui
