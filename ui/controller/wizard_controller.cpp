// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/wizard_controller.h"

#include "ui/controller/wizard_controller_p.h"

namespace axiscomp::ui {

WizardController::Private::Private(WizardController& controller, WizardOptions wizardOptions)
    : q(controller)
    , options(std::move(wizardOptions))
    , profile(*options.profile)
    , flash(profile.flashWear)
    , live(options.liveInterval)
    , file(profile.layout)
{
    connect(&setup, &SetupModel::fieldChanged, &q, [this](Field field) { fieldChanged(field); });
    connect(&live, &LiveMonitor::read, &q, [this](const AxisStatus& now) {
        liveProblem.reset();
        takeStatus(now, false);
    });
    connect(&live, &LiveMonitor::failed, &q, [this](const Error& error) { liveFailed(error); });
    connect(&driveTable, &DriveTable::changed, &q, [this] {
        noteSelectedTable();
        Q_EMIT q.statusChanged();
    });
    connect(
        &driveTable, &DriveTable::failed, &q, [this](const Error& error) { liveFailed(error); });
    connect(&file, &DataFileModel::dataReplaced, &q,
        [this](const std::shared_ptr<const CalibrationData>& before, bool isSameFile) {
            fileReplaced(before, isSameFile);
        });
    connect(&file, &DataFileModel::failed, &q,
        [this](const LoadedFile& failed) { fileFailed(failed); });
    connect(&file, &DataFileModel::choiceNeeded, &q, &WizardController::importChoiceNeeded);
    connect(&file, &DataFileModel::changed, &q, [this] {
        Q_EMIT q.dataFileChanged();
        update();
    });
    countdown.setInterval(std::chrono::seconds{1});
    connect(&countdown, &QTimer::timeout, &q, [this] { update(); });
    readAgain.setSingleShot(true);
    readAgain.setInterval(options.reconnectInterval);
    connect(&readAgain, &QTimer::timeout, &q, [this] { readAxisNow(); });
    update();
}

WizardController::Private::~Private()
{
    // All sessions end at the same time: together they take no longer than one.
    const auto all = q.findChildren<DriveConnection*>(QString(), Qt::FindDirectChildrenOnly);
    for (DriveConnection* connection : all) {
        connection->disconnect(&q);
        connection->close();
    }
    for (DriveConnection* connection : all)
        delete connection;
}

WizardController::WizardController(WizardOptions options, QObject* parent)
    : QObject(parent)
    , d(std::make_unique<Private>(*this, std::move(options)))
{
}

WizardController::~WizardController() = default;

void WizardController::setEndpoints(const QStringList& endpoints)
{
    d->setEndpoints(endpoints);
}

QStringList WizardController::endpoints() const
{
    QStringList endpoints;
    for (const DriveConnection* connection : d->connections)
        endpoints.append(connection->endpointAsGiven());
    return endpoints;
}

const std::vector<DriveState>& WizardController::drives() const
{
    return d->drives;
}

const std::vector<AxisEntry>& WizardController::axes() const
{
    return d->axes;
}

int WizardController::currentAxis() const
{
    return d->currentIndex;
}

void WizardController::selectAxis(int index)
{
    const bool isOne = index >= 0 && index < static_cast<int>(d->axes.size());
    if (!isOne || index == d->currentIndex)
        return;
    if (d->task) {
        // What runs belongs to the axis that is shown; the field goes back to it.
        d->refuse(
            [] { return tr("Wait for the current operation before selecting another axis."); });
        Q_EMIT currentAxisChanged();
        return;
    }
    const AxisEntry entry = d->axes[static_cast<std::size_t>(index)];
    d->select(entry);
}

void WizardController::refresh()
{
    for (DriveConnection* connection : d->connections)
        connection->explore();
}

SetupModel& WizardController::setup()
{
    return d->setup;
}

const SetupModel& WizardController::setup() const
{
    return d->setup;
}

const std::optional<AxisStatus>& WizardController::status() const
{
    return d->status;
}

const std::vector<DimSource>& WizardController::sourceShortlist() const
{
    static const std::vector<DimSource> none;
    const DriveConnection* drive = d->connection();
    return drive && drive->findings() ? drive->findings()->sources : none;
}

void WizardController::chooseSource(int dimension, const QString& text)
{
    d->chooseSource(dimension, text);
}

QString WizardController::sourceProblem(int dimension) const
{
    const Wording& problem = d->sourceField(dimension).problem;
    return problem ? problem() : QString();
}

bool WizardController::isSourceBeingChecked(int dimension) const
{
    return d->sourceField(dimension).isBeingChecked;
}

void WizardController::openData(const QString& path)
{
    importData(path, {});
}

void WizardController::importData(const QString& path, const ImportChoices& choices)
{
    if (!d->mayStart(Action::OpenData))
        return;
    d->isOpening = true;
    d->file.open(path, d->setup.edited().dimensionality, choices);
}

ImportChoices WizardController::importChoices(const QString& path) const
{
    return d->file.choicesFor(path);
}

void WizardController::readDataAgain()
{
    const QString path = d->file.file().path;
    if (!path.isEmpty() && d->mayStart(Action::OpenData))
        d->file.open(path, d->setup.edited().dimensionality, d->file.choicesFor(path));
}

void WizardController::closeData()
{
    d->file.close();
}

void WizardController::cancelReading()
{
    d->file.cancelReading();
}

const DataFile& WizardController::dataFile() const
{
    return d->file.file();
}

std::shared_ptr<const CompensationTable> WizardController::selectedTable() const
{
    return d->selectedTable().table;
}

std::shared_ptr<const CompensationTable> WizardController::driveTable() const
{
    return d->driveTable.table().table;
}

std::size_t WizardController::selectedTableBytes() const
{
    return d->selectedTableBytes();
}

ActionState WizardController::action(Action action) const
{
    return d->decision[action];
}

QString WizardController::hint() const
{
    return d->decision.hint;
}

void WizardController::planWrite()
{
    d->planWrite();
}

void WizardController::write()
{
    d->write();
}

void WizardController::activate()
{
    d->switchTo(Task::Activate, Action::Activate, Switch::Activate);
}

void WizardController::evaluate()
{
    d->switchTo(Task::Evaluate, Action::Evaluate, Switch::Evaluate);
}

void WizardController::deactivate()
{
    d->switchTo(Task::Deactivate, Action::Deactivate, Switch::Deactivate);
}

void WizardController::restorePrevious()
{
    d->restorePrevious();
}

QString WizardController::unfinishedWrite() const
{
    const bool isThere =
        d->unfinished && d->unfinished->outcome != AxisCompensator::UnfinishedOutcome::New;
    return isThere ? settledOutcome(*d->unfinished).text : QString();
}

void WizardController::finishWrite()
{
    d->recover(true);
}

void WizardController::undoWrite()
{
    d->recover(false);
}

void WizardController::cancel()
{
    d->cancel();
}

const BusyState& WizardController::busy() const
{
    return d->busy;
}

bool WizardController::isWriting() const
{
    return d->task && isWrite(*d->task);
}

const std::optional<WritePlan>& WizardController::plan() const
{
    return d->plan;
}

const std::optional<Proof>& WizardController::proof() const
{
    return d->proof;
}

QString WizardController::outcome() const
{
    return d->outcome.text;
}

bool WizardController::isOutcomeAnError() const
{
    return d->outcome.isError;
}

const std::vector<LogLine>& WizardController::log() const
{
    return d->logLines.lines();
}

int WizardController::flashWaitSeconds() const
{
    return static_cast<int>(d->flashBudget().wait.count());
}

const std::optional<FlashUse>& WizardController::flashUse() const
{
    return d->flashUse;
}

int WizardController::flashOperationsLeft() const
{
    return d->flashBudget().left;
}

void WizardController::refreshLive()
{
    d->live.readNow();
}

void WizardController::retranslate()
{
    d->retranslate();
}

} // namespace axiscomp::ui
