// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/wizard_controller.h"

#include "core/axis/proposals.h"
#include "core/drive/axis_target.h"
#include "core/drive/drive_units.h"
#include "core/table/target_axis.h"
#include "core/write/lookup_side.h"
#include "ui/controller/axis_overview.h"
#include "ui/controller/machine_controller.h"
#include "ui/controller/multi_axis_controller.h"
#include "ui/controller/parameter_export.h"
#include "ui/controller/proof_follower.h"
#include "ui/controller/setup_history.h"
#include "ui/controller/wizard_actions.h"
#include "ui/text/message_text.h"
#include "ui/text/sign_sentence.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace axiscomp::ui {

namespace {

/// All axes take longer to read than one.
std::chrono::milliseconds overviewInterval(const WizardOptions& options)
{
    return 10 * options.liveInterval;
}

} // namespace

/// Each knows only parts above it; what these have to learn from it are signals, which
/// WizardController connects.
struct WizardController::Parts {
    explicit Parts(const WizardOptions& options)
        : profile(*options.profile)
        , drives(options, log, outcome)
        , axis(options, drives, setup, log, outcome)
        , proof(*options.profile, axis, outcome)
        , sources(drives, setup, log)
        , tables(options.profile->layout, setup, log)
        , history(setup, tables)
        , runner(*options.profile, drives, axis, setup, tables, log, outcome)
        , multiAxis(*options.profile, drives, axis, setup, tables, runner, outcome)
        , parameterExport(drives, axis, outcome)
        , overview(drives, axis, proof, tables, runner, overviewInterval(options))
        , machine(*options.profile, drives, axis, overview, runner, log, outcome)
        , actions(*options.profile, drives, axis, setup, sources, tables, runner, outcome)
    {
    }

    const DriveProfile& profile;
    WizardLog log;
    LastOutcome outcome{log};
    SetupModel setup;
    DriveList drives;
    AxisState axis;
    ProofFollower proof;
    SourceCheck sources;
    TableSelection tables;
    SetupHistory history;
    OperationRunner runner;
    MultiAxisController multiAxis;
    ParameterExport parameterExport;
    AxisOverview overview;
    MachineController machine;
    WizardActions actions;
};

WizardController::WizardController(WizardOptions options, QObject* parent)
    : QObject(parent)
    , m_parts(std::make_unique<Parts>(options))
{
    wireDrives();
    wireAxis();
    wireTables();
    wireOperations();
    m_parts->tables.proposeBy([this](const CalibrationData& file) {
        const int axis = status() ? status()->axis.index : -1;
        return proposedTable(file.tables, axesOfDrive(), axis).value_or(0);
    });
    m_parts->actions.update();
}

WizardController::~WizardController() = default;

void WizardController::wireDrives()
{
    const DriveList* drives = &m_parts->drives;
    connect(drives, &DriveList::drivesChanged, this, &WizardController::drivesChanged);
    connect(drives, &DriveList::axesChanged, this, &WizardController::axesChanged);
    connect(drives, &DriveList::currentAxisChanged, this, &WizardController::currentAxisChanged);
    connect(drives, &DriveList::axisLeft, this, [this] {
        m_parts->axis.forget();
        m_parts->proof.forget();
        m_parts->runner.forget();
        m_parts->tables.driveTable().clear();
        m_parts->tables.setTableOnDrive({});
        m_parts->setup.clear();
        m_parts->sources.forget();
        m_parts->history.clear();
    });
    connect(drives, &DriveList::axisReady, this, [this](bool isAnother) {
        m_parts->outcome.connectedAgain();
        if (isAnother) {
            m_parts->sources.forget();
            m_parts->history.clear();
        }
        m_parts->axis.begin(isAnother);
    });
    connect(drives, &DriveList::progressed, &m_parts->runner, &OperationRunner::showProgress);
    connect(drives, &DriveList::removed, &m_parts->runner, &OperationRunner::abandon);
    for (const auto changed :
        {&DriveList::drivesChanged, &DriveList::axesChanged, &DriveList::currentAxisChanged})
        connect(drives, changed, &m_parts->actions, &WizardActions::update);
}

void WizardController::wireAxis()
{
    const AxisState* axis = &m_parts->axis;
    connect(axis, &AxisState::taken, this, [this](bool isComplete) {
        m_parts->tables.setTableOnDrive(status()->table);
        m_parts->tables.driveTable().follow(
            *m_parts->drives.connection(), *m_parts->axis.status(), isComplete);
        m_parts->proof.take(driveTable());
    });
    connect(axis, &AxisState::statusChanged, this, &WizardController::updatePlace);
    connect(axis, &AxisState::statusChanged, this, &WizardController::updateUnits);
    connect(axis, &AxisState::statusChanged, this, &WizardController::statusChanged);
    connect(axis, &AxisState::liveChanged, this, &WizardController::liveChanged);
    for (const auto changed :
        {&AxisState::statusChanged, &AxisState::liveChanged, &AxisState::failed})
        connect(axis, changed, &m_parts->actions, &WizardActions::update);
    connect(&m_parts->sources, &SourceCheck::checked, this, &WizardController::sourceChecked);
    connect(&m_parts->sources, &SourceCheck::checked, &m_parts->actions, &WizardActions::update);
    connect(&m_parts->setup, &SetupModel::fieldChanged, this, &WizardController::updatePlace);
    connect(&m_parts->setup, &SetupModel::fieldChanged, this, &WizardController::updateUnits);
    connect(&m_parts->setup, &SetupModel::fieldChanged, this, &WizardController::watchSources);
    connect(
        &m_parts->setup, &SetupModel::fieldChanged, &m_parts->runner, &OperationRunner::dropPlan);
    connect(&m_parts->setup, &SetupModel::fieldChanged, &m_parts->actions, &WizardActions::update);
    connect(&m_parts->setup, &SetupModel::changedByUser, &m_parts->outcome,
        &LastOutcome::choiceChanged);
}

/// A file of another controller is read for what the axis is among its sources.
void WizardController::updatePlace()
{
    const EditedSetup& edited = setup().edited();
    const bool isKnown =
        status() && std::ssize(sourcePaths(edited)) == std::ptrdiff_t{edited.dimensionality};
    m_parts->tables.setPlace(isKnown ? std::optional(chosenPlace()) : std::nullopt);
}

/// Tables are shown in the units in which the drive takes them.
void WizardController::updateUnits()
{
    if (!status())
        return m_parts->tables.setUnits({}, std::nullopt);
    const auto current = static_cast<std::size_t>(currentAxis());
    const auto unitOf = [&](int axis) -> Result<std::string> {
        if (axis == status()->axis.index)
            return status()->axis.unit;
        for (const AxisEntry& entry : axes())
            if (entry.axis.index == axis && current < axes().size()
                && entry.endpoint == axes()[current].endpoint)
                return entry.axis.unit;
        return std::string();
    };
    const EditedSetup& edited = setup().edited();
    const auto sources =
        std::span(edited.sources).first(static_cast<std::size_t>(edited.dimensionality));
    m_parts->tables.setUnits(
        driveUnits(m_parts->profile, sources, status()->axis.index, unitOf).value_or(TableUnits{}),
        ownDimension(m_parts->profile, status()->axis.index, sourcePaths(edited)));
}

void WizardController::wireTables()
{
    const DataFileModel* file = &m_parts->tables.file();
    const DriveTable* driveTable = &m_parts->tables.driveTable();
    connect(
        &m_parts->tables, &TableSelection::changed, this, &WizardController::selectedTableChanged);
    connect(driveTable, &DriveTable::changed, this, &WizardController::statusChanged);
    connect(driveTable, &DriveTable::failed, &m_parts->axis, &AxisState::takeLiveFailure);
    connect(file, &DataFileModel::choiceNeeded, this, &WizardController::importChoiceNeeded);
    connect(file, &DataFileModel::changed, this, &WizardController::dataFileChanged);
    connect(file, &DataFileModel::changed, &m_parts->actions, &WizardActions::update);
    connect(file, &DataFileModel::dataReplaced, &m_parts->outcome, &LastOutcome::choiceChanged);
}

void WizardController::wireOperations()
{
    const OperationRunner* runner = &m_parts->runner;
    connect(runner, &OperationRunner::busyChanged, this, &WizardController::busyChanged);
    connect(runner, &OperationRunner::busyChanged, &m_parts->actions, &WizardActions::update);
    connect(runner, &OperationRunner::planReady, this, &WizardController::planReady);
    connect(runner, &OperationRunner::ended, this, [this](Task task) {
        if (isWrite(task))
            m_parts->history.clear();
        if (isMultiAxis(task))
            Q_EMIT multiAxisWritten();
        if (task == Task::Activate && !isOutcomeAnError())
            Q_EMIT tableActivated();
    });
    connect(runner, &OperationRunner::tableWritten, this, &WizardController::tableWritten);
    connect(&m_parts->multiAxis, &MultiAxisController::tableWritten, this,
        &WizardController::tableWritten);
    connect(&m_parts->multiAxis, &MultiAxisController::columnWritten, &m_parts->overview,
        &AxisOverview::noteWritten);
    connect(&m_parts->machine.application(), &MachineApplication::columnWritten, &m_parts->overview,
        &AxisOverview::noteWritten);
    connect(&m_parts->multiAxis, &MultiAxisController::planned, this,
        &WizardController::multiAxisPlanned);
    connect(&m_parts->parameterExport, &ParameterExport::parametersRead, this,
        &WizardController::parametersRead);
    // Who waits for the end of a write waits for all drives, also where the current one has none.
    for (const auto changed : {&MachineApplication::started, &MachineApplication::ended})
        connect(&m_parts->machine.application(), changed, this, &WizardController::busyChanged);
    connect(&m_parts->actions, &WizardActions::changed, this, &WizardController::actionsChanged);
    connect(&m_parts->outcome, &LastOutcome::changed, this, &WizardController::outcomeChanged);
}

void WizardController::setEndpoints(const QStringList& endpoints)
{
    m_parts->drives.setEndpoints(endpoints);
}

DriveConnection* WizardController::connection() const
{
    return m_parts->drives.connection();
}

QStringList WizardController::endpoints() const
{
    return m_parts->drives.endpoints();
}

const std::vector<DriveState>& WizardController::drives() const
{
    return m_parts->drives.drives();
}

const std::vector<AxisEntry>& WizardController::axes() const
{
    return m_parts->drives.axes();
}

int WizardController::currentAxis() const
{
    return m_parts->drives.currentIndex();
}

int WizardController::usableAxisOf(const QString& endpoint) const
{
    // The axes of a drive that has just been lost are still those that it had.
    const auto drive = std::ranges::find(drives(), endpoint, &DriveState::endpoint);
    if (drive == drives().end() || drive->connection != DriveState::Connection::Connected)
        return -1;
    const auto axis = std::ranges::find_if(axes(),
        [&](const AxisEntry& entry) { return entry.endpoint == endpoint && entry.isUsable; });
    return axis == axes().end() ? -1 : static_cast<int>(axis - axes().begin());
}

bool WizardController::isCurrentDrive(const AxisEntry& entry) const
{
    if (currentAxis() < 0)
        return false;
    const AxisEntry& now = axes().at(static_cast<std::size_t>(currentAxis()));
    return now.endpoint == entry.endpoint && now.serialNumber == entry.serialNumber;
}

bool WizardController::isConnected() const
{
    const DriveConnection* drive = m_parts->drives.connection();
    return drive && drive->isConnected();
}

void WizardController::selectAxis(int index)
{
    if (index < 0 || index >= static_cast<int>(axes().size()) || index == currentAxis())
        return;
    if (m_parts->runner.task() || m_parts->machine.application().isRunning()) {
        // What runs belongs to the axis that is shown; the field goes back to it.
        m_parts->outcome.refuse(
            [] { return tr("Wait for the current operation before selecting another axis."); });
        Q_EMIT currentAxisChanged();
        return;
    }
    m_parts->drives.select(index);
}

bool WizardController::selectAxis(const AxisEntry& entry)
{
    const auto place = [](const AxisEntry& one) {
        return std::tuple(one.endpoint, one.serialNumber, one.axis.index);
    };
    const auto found = std::ranges::find(axes(), place(entry), place);
    if (found == axes().end())
        return false;
    const int index = static_cast<int>(found - axes().begin());
    selectAxis(index);
    return currentAxis() == index;
}

void WizardController::refresh()
{
    m_parts->drives.refresh();
}

void WizardController::tryDrive(const QString& endpoint)
{
    m_parts->drives.tryAgain(endpoint);
}

AxisOverview& WizardController::overview()
{
    return m_parts->overview;
}

MachineController& WizardController::machine()
{
    return m_parts->machine;
}

SetupModel& WizardController::setup()
{
    return m_parts->setup;
}

const SetupModel& WizardController::setup() const
{
    return m_parts->setup;
}

SetupHistory& WizardController::history()
{
    return m_parts->history;
}

const std::optional<AxisStatus>& WizardController::status() const
{
    return m_parts->axis.status();
}

const std::vector<DimSource>& WizardController::sourceShortlist() const
{
    return m_parts->drives.sourceShortlist();
}

void WizardController::chooseSource(int dimension, const QString& text)
{
    m_parts->sources.choose(dimension, text);
}

void WizardController::forgetSourceProblem(int dimension)
{
    m_parts->sources.forgetProblem(dimension);
}

std::vector<AxisInfo> WizardController::axesOfDrive() const
{
    std::vector<AxisInfo> infos;
    for (const AxisEntry& entry : axes())
        if (isCurrentDrive(entry))
            infos.push_back(entry.axis);
    return infos;
}

Grid WizardController::columnsOfPositions() const
{
    const auto dimensions = static_cast<std::size_t>(setup().edited().dimensionality);
    const auto table = m_parts->tables.selectedOfFile().table;
    if (table && table->grid.axes.size() == dimensions)
        return table->grid;
    return Grid{std::vector<GridAxis>(dimensions)};
}

DimSource WizardController::proposedSource(int dimension) const
{
    const auto index = static_cast<std::size_t>(dimension - 1);
    const EditedSetup& edited = setup().edited();
    if (!status() || dimension > edited.dimensionality)
        return {};
    if (edited.sources[index].isSet() && sourceDoubt(dimension).isEmpty())
        return {};
    const std::vector<AxisInfo> known = axesOfDrive();
    DimSource proposed = proposedSources({m_parts->profile, sourceShortlist(), known},
        status()->axis.index, columnsOfPositions())[index];
    const auto used =
        std::span(edited.sources).first(static_cast<std::size_t>(edited.dimensionality));
    const bool isUsed = std::ranges::find(used, proposed) != used.end();
    return isUsed ? DimSource{} : proposed;
}

QString WizardController::sourceDoubt(int dimension) const
{
    const auto index = static_cast<std::size_t>(dimension - 1);
    const EditedSetup& edited = setup().edited();
    const Grid columns = columnsOfPositions();
    if (!status() || index >= columns.axes.size() || !edited.sources[index].isSet())
        return {};
    const auto table = m_parts->tables.selectedOfFile().table;
    const bool isStated = table && isStatedSource(*table, index);
    const auto doubt = axiscomp::sourceDoubt(
        m_parts->profile, columns.axes[index], index + 1, edited.sources[index], isStated,
        [this](int axis) {
            for (const AxisInfo& info : axesOfDrive())
                if (info.index == axis)
                    return info.name;
            return std::string();
        },
        [this](int axis) {
            std::vector<std::string> others;
            for (const AxisInfo& info : axesOfDrive())
                if (info.index != axis)
                    others.push_back(info.name);
            return others;
        });
    return doubt ? sentenceText(doubt->text) : QString();
}

std::optional<double> WizardController::sourceValue(int dimension) const
{
    const DimSource& source = setup().edited().sources.at(static_cast<std::size_t>(dimension - 1));
    return m_parts->axis.valueOf(source);
}

/// Sources that are chosen have a value before they are written.
void WizardController::watchSources()
{
    const EditedSetup& edited = setup().edited();
    std::vector<std::string> paths;
    for (const DimSource& source :
        std::span(edited.sources).first(static_cast<std::size_t>(edited.dimensionality)))
        if (!source.path.empty())
            paths.push_back(source.path);
    m_parts->axis.watch(std::move(paths));
}

QString WizardController::sourceProblem(int dimension) const
{
    return m_parts->setup.problem(sourceField(dimension));
}

bool WizardController::isSourceBeingChecked(int dimension) const
{
    return m_parts->sources.isBeingChecked(dimension);
}

void WizardController::openData(const QString& path)
{
    importData(path, {});
}

void WizardController::importData(const QString& path, const ImportChoices& choices)
{
    if (!m_parts->actions.mayStart(Action::OpenData))
        return;
    ImportChoices known = choices;
    known.place = chosenPlace();
    m_parts->tables.open(path, known);
}

void WizardController::openDataAs(const QString& path, int dimensions)
{
    if (m_parts->actions.mayStart(Action::OpenData))
        m_parts->tables.openAs(path, dimensions);
}

bool WizardController::useTables(const MadeTables& made)
{
    if (!m_parts->actions.mayStart(Action::OpenData))
        return false;
    m_parts->tables.show(made);
    return true;
}

ImportChoices WizardController::importChoices(const QString& path) const
{
    return m_parts->tables.file().choicesFor(path);
}

void WizardController::readDataAgain()
{
    if (!dataFile().path.isEmpty() && m_parts->actions.mayStart(Action::OpenData))
        m_parts->tables.readAgain(chosenPlace());
}

void WizardController::closeData()
{
    m_parts->tables.file().close();
}

void WizardController::cancelReading()
{
    m_parts->tables.file().cancelReading();
}

const DataFile& WizardController::dataFile() const
{
    return m_parts->tables.file().file();
}

AxisPlace WizardController::chosenPlace() const
{
    if (!status())
        return {};
    const auto sources = sourcePaths(setup().edited());
    return {axisTarget(m_parts->profile, status()->axis.index, sources),
        lookupAtSources(m_parts->profile, status()->axis.index, sources)};
}

AxisPlace WizardController::selectedPlace() const
{
    AxisPlace place = chosenPlace();
    if (setup().edited().table.fileTable)
        place.lookupAt = dataFile().lookupAt ? dataFile().lookupAt : place.lookupAt;
    else if (status())
        place.lookupAt =
            lookupAtSources(m_parts->profile, status()->axis.index, sourcePaths(status()->setup));
    return place;
}

std::shared_ptr<const CompensationTable> WizardController::selectedTable() const
{
    return m_parts->tables.selected().table;
}

std::vector<std::string> WizardController::selectedNotes() const
{
    const bool isOfFile = setup().edited().table.fileTable && dataFile().data;
    return isOfFile ? dataFile().data->notes : std::vector<std::string>{};
}

bool WizardController::isSelectedComputed() const
{
    return setup().edited().table.fileTable && dataFile().isComputed;
}

std::shared_ptr<const CompensationTable> WizardController::driveTable() const
{
    return m_parts->tables.driveTable().table().table;
}

std::size_t WizardController::selectedTableBytes() const
{
    return m_parts->tables.selectedBytes();
}

QString WizardController::signSentence() const
{
    const AxisInfo axis = status() ? status()->axis : AxisInfo{};
    const LoadedTable table = m_parts->tables.selected();
    // Which unit is meant may depend on sources that are still to be chosen.
    if (const auto refusal = m_parts->tables.unitRefusal())
        return refusal->code == ErrorCode::UnitMissing ? QString() : errorText(*refusal);
    const auto& sources = setup().edited().sources;
    std::vector<std::string> paths;
    std::ranges::transform(sources, std::back_inserter(paths), &DimSource::path);
    auto own = ownDimension(m_parts->profile, axis.index, paths);
    // Until a source is chosen, a curve is shown as one over the axis's own position.
    if (!sources[0].isSet() && table.table && table.table->grid.dimensions() == 1)
        own = 0;
    return signSentenceFor(table, axis, {own, selectedPlace().lookupAt, isSelectedComputed()});
}

ActionState WizardController::action(Action action) const
{
    return m_parts->actions.states()[action];
}

QString WizardController::hint() const
{
    return m_parts->actions.states().hint;
}

void WizardController::planWrite(std::vector<Text> doubts)
{
    if (m_parts->actions.mayStart(Action::Write))
        m_parts->runner.planWrite(std::move(doubts));
}

void WizardController::write(bool acceptsLarge)
{
    if (plan() && plannedRestoration()) {
        const bool isChosen = m_parts->runner.isBackupChosen();
        if (m_parts->actions.mayStart(isChosen ? Action::RestoreBackup : Action::RestorePrevious))
            m_parts->runner.restore();
        return;
    }
    const bool deletes = plan() && !plan()->deletedSlot.empty();
    if (m_parts->actions.mayStart(deletes ? Action::DeleteTable : Action::Write))
        m_parts->runner.write(acceptsLarge);
}

void WizardController::refuseOldPlan()
{
    m_parts->runner.refuseOldPlan();
}

void WizardController::planRestoration()
{
    if (m_parts->actions.mayStart(Action::RestorePrevious))
        m_parts->runner.planRestoration();
}

void WizardController::planRestoration(const BackupChoice& choice)
{
    if (m_parts->actions.mayStart(Action::RestoreBackup))
        m_parts->runner.planRestoration(choice);
}

std::optional<Restoration> WizardController::plannedRestoration() const
{
    const auto& restoration = m_parts->runner.plannedRestoration();
    return restoration ? std::optional(restoration->state) : std::nullopt;
}

void WizardController::planDeletion()
{
    if (m_parts->actions.mayStart(Action::DeleteTable))
        m_parts->runner.planDeletion();
}

void WizardController::activate()
{
    if (m_parts->actions.mayStart(Action::Activate))
        m_parts->runner.switchTo(Switch::Activate);
}

void WizardController::evaluate()
{
    if (m_parts->actions.mayStart(Action::Evaluate))
        m_parts->runner.switchTo(Switch::Evaluate);
}

void WizardController::deactivate()
{
    if (m_parts->actions.mayStart(Action::Deactivate))
        m_parts->runner.switchTo(Switch::Deactivate);
}

QString WizardController::unfinishedWrite() const
{
    const auto& unfinished = m_parts->axis.unfinished();
    const bool isThere =
        unfinished && unfinished->outcome != AxisCompensator::UnfinishedOutcome::New;
    return isThere ? settledOutcome(*unfinished).text : QString();
}

void WizardController::finishWrite()
{
    if (m_parts->actions.mayStart(Action::FinishWrite))
        m_parts->runner.recover(true);
}

void WizardController::undoWrite()
{
    if (m_parts->actions.mayStart(Action::UndoWrite))
        m_parts->runner.recover(false);
}

std::vector<AxisEntry> WizardController::usableAxes() const
{
    return m_parts->drives.usableAxes();
}

std::vector<DimSource> WizardController::sourcesForSeveral() const
{
    return m_parts->multiAxis.sources();
}

DimSource WizardController::ownPosition(int axis) const
{
    return m_parts->multiAxis.ownPosition(axis);
}

bool WizardController::planMultiAxis(
    const std::vector<ColumnForAxis>& columns, SourcesForSeveral sources)
{
    m_parts->actions.update();
    const bool may = action(Action::WriteSeveral).isEnabled;
    if (may)
        m_parts->multiAxis.plan(columns, sources);
    return may;
}

bool WizardController::planImport(const std::shared_ptr<const TamConfiguration>& configuration,
    std::size_t station, bool acceptsOther)
{
    m_parts->actions.update();
    const bool may = action(Action::ImportConfiguration).isEnabled;
    if (may)
        m_parts->multiAxis.planImport(configuration, station, acceptsOther);
    return may;
}

bool WizardController::planRestoreDrive(
    const std::shared_ptr<const DriveBackup>& backup, bool acceptsOther)
{
    m_parts->actions.update();
    const bool may = action(Action::RestoreDrive).isEnabled;
    if (may)
        m_parts->multiAxis.planRestoreDrive(backup, acceptsOther);
    return may;
}

void WizardController::backUpDrive(const QString& path)
{
    if (m_parts->actions.mayStart(Action::BackUpDrive))
        m_parts->runner.backUpDrive(path);
}

void WizardController::dropSeveral()
{
    m_parts->multiAxis.drop();
}

const std::optional<Result<std::vector<WritePlan>>>& WizardController::multiAxisPlans() const
{
    return m_parts->multiAxis.plans();
}

void WizardController::writeMultiAxis(bool acceptsLarge)
{
    const Task task = m_parts->multiAxis.task();
    const Action action = task == Task::Import ? Action::ImportConfiguration
        : task == Task::RestoreDrive           ? Action::RestoreDrive
                                               : Action::WriteSeveral;
    if (m_parts->actions.mayStart(action))
        m_parts->multiAxis.write(acceptsLarge);
}

bool WizardController::readParameters()
{
    m_parts->actions.update();
    const bool may = action(Action::ExportConfiguration).isEnabled;
    if (may)
        m_parts->parameterExport.read();
    return may;
}

void WizardController::dropParameters()
{
    m_parts->parameterExport.drop();
}

const std::optional<Result<CompensationParameters>>& WizardController::parameters() const
{
    return m_parts->parameterExport.parameters();
}

void WizardController::reportExport(const QString& fileName, const Result<void>& saved)
{
    m_parts->parameterExport.report(fileName, saved);
}

void WizardController::cancel()
{
    if (m_parts->machine.application().isRunning())
        m_parts->machine.application().stop();
    else if (m_parts->runner.task())
        m_parts->runner.cancel();
    else
        cancelReading();
}

const BusyState& WizardController::busy() const
{
    return m_parts->runner.busy();
}

bool WizardController::isWriting() const
{
    return m_parts->machine.application().isRunning()
        || (m_parts->runner.task() && isWrite(*m_parts->runner.task()));
}

const std::optional<WritePlan>& WizardController::plan() const
{
    return m_parts->runner.plan();
}

const std::optional<MovingProof>& WizardController::movingProof() const
{
    return m_parts->proof.proof();
}

const std::optional<Proof>& WizardController::proof() const
{
    return m_parts->runner.proof();
}

QString WizardController::outcome() const
{
    return m_parts->outcome.get().text;
}

bool WizardController::isOutcomeAnError() const
{
    return m_parts->outcome.get().isError;
}

bool WizardController::isOutcomeAWarning() const
{
    return m_parts->outcome.get().isWarning;
}

WizardLog& WizardController::logModel()
{
    return m_parts->log;
}

const std::vector<LogLine>& WizardController::log() const
{
    return m_parts->log.lines();
}

int WizardController::flashWaitSeconds() const
{
    return static_cast<int>(m_parts->axis.flashBudget().wait.count());
}

int WizardController::flashOperationsLeft() const
{
    return m_parts->axis.flashBudget().left;
}

const std::optional<FlashUse>& WizardController::flashUse() const
{
    return m_parts->axis.flashUse();
}

void WizardController::refreshLive()
{
    m_parts->axis.readLiveNow();
}

void WizardController::retranslate()
{
    m_parts->outcome.retranslate();
    m_parts->log.retranslate();
    m_parts->drives.retranslate();
    m_parts->sources.retranslate();
    m_parts->runner.retranslate();
    m_parts->actions.update();
}

} // namespace axiscomp::ui
