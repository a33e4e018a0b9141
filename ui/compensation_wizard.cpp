// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compensation_wizard.h"

#include "core/compensator/file_kind.h"
#include "core/drive/drive_profile.h"
#include "core/write/lookup_side.h"
#include "ui/async/background_job.h"
#include "ui/controller/machine_controller.h"
#include "ui/controller/setup_history.h"
#include "ui/controller/wizard_settings.h"
#include "ui/dialogs/certificate_dialog.h"
#include "ui/dialogs/connections_dialog.h"
#include "ui/dialogs/multi_axis_dialog.h"
#include "ui/fields/typed_fields.h"
#include "ui/help/guide_window.h"
#include "ui/history/backup_dialog.h"
#include "ui/judging/judge_page.h"
#include "ui/measuring/measuring_actions.h"
#include "ui/overview/machine_actions.h"
#include "ui/overview/overview_dialog.h"
#include "ui/page/action_panel.h"
#include "ui/page/drive_bar.h"
#include "ui/page/drop_frame.h"
#include "ui/page/file_actions.h"
#include "ui/page/log_view.h"
#include "ui/page/message_presenter.h"
#include "ui/page/message_stack.h"
#include "ui/page/page_menu.h"
#include "ui/page/page_tabs.h"
#include "ui/page/preview_panel.h"
#include "ui/page/setup_panel.h"
#include "ui/page/unsaved_changes_guard.h"
#include "ui/page/wizard_page.h"
#include "ui/page/write_flow.h"
#include "ui/page/write_preview.h"
#include "ui/record/record_model.h"
#include "ui/style/dirty_style.h"
#include "ui/style/plain_tool_tips.h"
#include "ui/tabs/fit_page.h"
#include "ui/tabs/measure_page.h"
#include "ui/tabs/prove_page.h"
#include "ui/tabs/record_actions.h"
#include "ui/tabs/record_bar.h"
#include "ui/text/language.h"
#include "ui/text/message_text.h"

#include <QApplication>
#include <QBoxLayout>
#include <QDialog>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMimeData>
#include <QPointer>
#include <QShortcut>
#include <QTimer>

#include <algorithm>
#include <optional>
#include <utility>

namespace axiscomp::ui {

namespace {

const QLatin1StringView demoEndpoint("demo:");
const QLatin1StringView waitingId("waitingFileMessage");

/// The files that are dragged; none when there is a folder among them, or something else.
QStringList draggedFiles(const QMimeData& data)
{
    QStringList files;
    for (const QUrl& url : data.urls()) {
        const QString path = url.toLocalFile();
        if (!QFileInfo(path).isFile())
            return {};
        files += path;
    }
    return files;
}

/// The name says that it is no table, and no file of a measurement.
bool hasItsPlace(const QString& path)
{
    const auto kind = kindOfName(path.toStdString());
    return kind && *kind != FileKind::Table;
}

} // namespace

struct CompensationWizard::Private {
    Private(CompensationWizard& wizard, const WizardOptions& wizardOptions, QSettings* qSettings);

    void connectParts();
    void connectRecord();
    void connectMachine();
    void addShortcut(const QKeySequence& keys, std::function<void()> action);
    void addShortcuts();
    void start();
    void chooseDrive(const QString& endpoint);
    void chooseAxis(int index);
    void showConnections();
    void askAboutCertificate(const RejectedCertificate& certificate);
    void takeEndpoints(const QStringList& endpoints);
    void showBackups();
    void restore(const BackupChoice& choice);
    void begin(Action action);
    void offerActions();
    void offerHistory();
    void undo();
    void redo();
    void chooseLanguage(const QString& chosen);
    void skipPreview(bool isSkipped);
    void showGuide(const GuidePlace& place);
    void showGuideOver(QDialog& dialog);
    void showOverview();
    void announceTitle();
    [[nodiscard]] bool isWriteShown() const;
    [[nodiscard]] RecordModel& measurementShown();
    void proceedToWrite();
    [[nodiscard]] bool isWelcome(const QStringList& dragged) const;
    void open(const QStringList& dropped);
    void openData(const QString& path);
    void recognise(const QString& path, std::function<void(const Result<FileKind>&)> show);
    void showFile(const Result<FileKind>& kind, const QString& path);
    void openAs(FileKind kind, const QString& path);
    void whenPossible(Action action, const QString& path, std::function<void()> open);
    void openWaiting();
    void showMarkOfMeasure();
    void connectFit();
    void tellDrive();
    void useTable(const std::shared_ptr<const FitOutcome>& outcome, std::size_t table);
    void showMarkOfFit();

    CompensationWizard& q;
    WizardOptions options;
    WizardSettings settings;
    Language language;
    DirtyStyle style;
    WizardController controller;
    RecordModel record;
    RecordActions recordActions;
    PageMenu* menu;
    MeasurePage* measure;
    JudgePage* judge;
    FitPage* fit;
    WizardPage* page;
    DropFrame* dropFrame;
    FileActions files;
    MeasuringActions measuring;
    MachineActions machine;
    WriteFlow writeFlow;
    UnsavedChangesGuard guard;
    MessagePresenter messages;
    QPointer<ConnectionsDialog> connections;
    QPointer<GuideWindow> guide;
    QPointer<OverviewDialog> overview;
    struct WaitingFile { ///< the drive is still being asked, or cannot be reached
        Action action;
        QString name;
        std::function<void()> open;
        bool isSaid = false;
    };
    std::optional<WaitingFile> waiting;
    bool isStarted = false;
};

CompensationWizard::Private::Private(
    CompensationWizard& wizard, const WizardOptions& wizardOptions, QSettings* qSettings)
    : q(wizard)
    , options(wizardOptions)
    , settings(qSettings)
    , language(settings.language())
    , controller(wizardOptions)
    , recordActions(record, controller, *options.profile, options.storeRoot)
    , menu(new PageMenu(&wizard))
    , measure(new MeasurePage(record))
    , judge(new JudgePage(record))
    , fit(new FitPage(record))
    , page(new WizardPage(controller, *options.profile, style, *menu, measure, judge, fit,
          recordActions.prove(), recordActions.bar(), &wizard))
    , dropFrame(new DropFrame(&wizard))
    , files(controller, settings, page->setup->dataField(), *options.profile, wizard)
    , measuring(controller, options, files, settings, wizard)
    , machine(
          controller, [this]() -> const FilePicker& { return files.picker(); },
          [this] { return settings.folder(); }, wizard)
    , writeFlow(controller, *page->preview)
    , guard(controller, *page->messages)
    , messages(controller, *page->messages)
{
    new PlainToolTips(wizard); // which owns it
    new TypedFields(wizard); // likewise
    menu->showLanguage(settings.language());
    page->preview->writePreview().setSkippedForVolatile(settings.isPreviewSkippedForVolatile());
    menu->showPreviewSkipped(settings.isPreviewSkippedForVolatile());
    measure->setMeasuring(measuring, settings);
    page->restoreSplitters(settings);
}

void CompensationWizard::Private::connectParts()
{
    connect(page->driveBar, &DriveBar::driveChosen, &q,
        [this](const QString& endpoint) { chooseDrive(endpoint); });
    connect(page->driveBar, &DriveBar::connectionsRequested, &q, [this] { showConnections(); });
    connect(&messages, &MessagePresenter::connectionsRequested, &q, [this] { showConnections(); });
    connect(&messages, &MessagePresenter::certificateRequested, &q,
        [this](const RejectedCertificate& certificate) { askAboutCertificate(certificate); });
    connect(&messages, &MessagePresenter::driveChosen, &q,
        [this](const QString& endpoint) { chooseDrive(endpoint); });
    connect(page->setup, &SetupPanel::axisChosen, &q, [this](int index) { chooseAxis(index); });
    connect(page->actions, &ActionPanel::writeRequested, &q, [this] { proceedToWrite(); });
    connect(&writeFlow, &WriteFlow::previewingChanged, page->actions, &ActionPanel::setPreviewing);
    connect(page->actions, &ActionPanel::deleteRequested, &writeFlow, &WriteFlow::proceedToDelete);
    connect(
        page->actions, &ActionPanel::restoreRequested, &writeFlow, &WriteFlow::proceedToRestore);
    connect(page->actions, &ActionPanel::backupsRequested, &q, [this] { showBackups(); });
    connect(page->preview, &PreviewPanel::saveExampleRequested, &files, &FileActions::saveExample);
    connect(&page->preview->writePreview(), &WritePreview::skipForVolatileChanged, &q,
        [this](bool isSkipped) { skipPreview(isSkipped); });
    connect(page->log, &LogView::saveRequested, &q, [this] { files.saveLog(page->log->text()); });
    connect(&files, &FileActions::failed, &messages, &MessagePresenter::showFailure);
    connect(&files, &FileActions::dataChosen, &q, [this](const QString& path) { openData(path); });
    connect(&guard, &UnsavedChangesGuard::closeAgreed, &q, &CompensationWizard::closeRequested);
    connect(menu, &PageMenu::exportRequested, &files, &FileActions::exportTable);
    const auto offerExport = [this] {
        menu->setExportEnabled(controller.selectedTable() != nullptr);
    };
    connect(&controller, &WizardController::selectedTableChanged, menu, offerExport);
    offerExport();
    connect(menu, &PageMenu::actionRequested, &q, [this](Action action) { begin(action); });
    connect(&controller, &WizardController::actionsChanged, &q, [this] { offerActions(); });
    connect(
        &controller, &WizardController::actionsChanged, &q, [this] { openWaiting(); },
        Qt::QueuedConnection);
    offerActions();
    connect(menu, &PageMenu::undoRequested, &q, [this] { undo(); });
    connect(menu, &PageMenu::redoRequested, &q, [this] { redo(); });
    for (const auto changed : {&WizardController::busyChanged, &WizardController::actionsChanged})
        connect(&controller, changed, &q, [this] { offerHistory(); });
    connect(&controller.history(), &SetupHistory::changed, &q, [this] { offerHistory(); });
    offerHistory();
    connect(menu, &PageMenu::languageChosen, &q,
        [this](const QString& chosen) { chooseLanguage(chosen); });
    connect(menu, &PageMenu::previewSkippedChosen, &q,
        [this](bool isSkipped) { skipPreview(isSkipped); });
    connect(menu, &PageMenu::guideRequested, &q, [this] { showGuide({}); });
    connect(menu, &PageMenu::overviewRequested, &q, [this] { showOverview(); });
    connect(menu, &PageMenu::saveLogRequested, &q, [this] { files.saveLog(page->log->text()); });
    connect(measure, &MeasurePage::addRequested, &q, [this] { files.askForMeasurements(); });
    connect(judge, &JudgePage::deadPathRequested, &files, &FileActions::askForDeadPath);
    connect(&files, &FileActions::deadPathChosen, judge, &JudgePage::readDeadPath);
    connect(measure, &MeasurePage::saveRequested, &q,
        [this] { files.saveMeasurement(record.state()); });
    connect(&files, &FileActions::measurementSaved, measure, &MeasurePage::showSaved);
    connect(&files, &FileActions::measurementsChosen, &q,
        [this](const QStringList& paths) { measurementShown().addFiles(paths); });
    connect(&record, &RecordModel::historyChanged, &q, [this] { offerHistory(); });
    connect(page->tabs, &PageTabs::currentChanged, &q, [this] { offerHistory(); });
    connect(&record, &RecordModel::stateChanged, &q, [this] { showMarkOfMeasure(); });
    connect(&record, &RecordModel::stateChanged, &q,
        [this] { page->tabs->setMark(PageTabs::Judge, judge->mark()); });
    connectFit();
    connect(&writeFlow, &WriteFlow::previewingChanged, &q, [this](bool isPreviewing) {
        if (isPreviewing)
            page->tabs->setCurrentIndex(PageTabs::Write);
    });
    connectRecord();
    connectMachine();
    const auto announce = [this] { announceTitle(); };
    connect(&controller, &WizardController::currentAxisChanged, &q, announce);
    connect(&controller, &WizardController::axesChanged, &q, announce);
    connect(&controller.setup(), &SetupModel::fieldChanged, &q, announce);
    connect(&recordActions.file(), &RecordFile::changed, &q, announce);
}

void CompensationWizard::Private::connectRecord()
{
    recordActions.attach(
        {*page->messages, guard, *menu, q, [this]() -> const FilePicker& { return files.picker(); },
            [this] { return settings.folder(); }});
    connect(&recordActions, &RecordActions::failed, &messages, &MessagePresenter::showFailure);
    connect(recordActions.prove(), &ProvePage::addRequested, &q,
        [this] { files.askForMeasurements(); });
    connect(recordActions.prove(), &ProvePage::standingChanged, &q, [this] {
        const auto standing = recordActions.prove()->standing();
        page->tabs->setMark(PageTabs::Prove,
            standing == ProvePage::Standing::Warning     ? PageTabs::Mark::Warning
                : standing == ProvePage::Standing::Ready ? PageTabs::Mark::Ready
                                                         : PageTabs::Mark::Empty);
    });
    addShortcut(Qt::CTRL | Qt::ALT | Qt::Key_O, [this] { recordActions.askAndOpen(); });
    addShortcut(QKeySequence::Save, [this] { recordActions.save(); });
    addShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_S, [this] { recordActions.saveAs(); });
    addShortcut(QKeySequence::Print, [this] { recordActions.report(); });
}

void CompensationWizard::Private::connectMachine()
{
    connect(menu, &PageMenu::openMachineRequested, &machine, &MachineActions::askAndOpen);
    connect(menu, &PageMenu::planMachineRequested, &machine, &MachineActions::planAgain);
    connect(menu, &PageMenu::closeMachineRequested, &machine, &MachineActions::close);
    connect(menu, &PageMenu::applyMachineRequested, &machine, &MachineActions::apply);
    connect(menu, &PageMenu::saveMachineRequested, &machine, &MachineActions::save);
    connect(&machine, &MachineActions::overviewRequested, &q, [this] { showOverview(); });
    const auto offer = [this] {
        const MachineController& state = controller.machine();
        const bool isOpen = !state.path().isEmpty();
        menu->showMachine(isOpen, isOpen && !state.isReading() && !state.isAsking());
    };
    for (const auto changed : {&MachineController::fileChanged, &MachineController::driftChanged})
        connect(&controller.machine(), changed, menu, offer); // a dialog may outlive the menu
}

/// That of the tab which is shown.
RecordModel& CompensationWizard::Private::measurementShown()
{
    return page->tabs->currentIndex() == PageTabs::Prove ? recordActions.after() : record;
}

/// Nothing is written while a field shows something else: a source that was refused, with the
/// reason below it.
void CompensationWizard::Private::proceedToWrite()
{
    if (!page->setup->isBeingTyped() && recordActions.mayWrite())
        writeFlow.proceed(recordActions.doubtsOfWrite());
}

void CompensationWizard::Private::connectFit()
{
    connect(fit, &FitPage::useRequested, &q,
        [this](const std::shared_ptr<const FitOutcome>& outcome, std::size_t table) {
            useTable(outcome, table);
        });
    connect(fit, &FitPage::saveRequested, &files, &FileActions::saveFitted);
    connect(fit, &FitPage::fileWanted, &files, &FileActions::askForActiveTable);
    connect(&files, &FileActions::activeTableChosen, fit, &FitPage::takeFile);
    connect(fit, &FitPage::stateChanged, &q, [this] { showMarkOfFit(); });
    showMarkOfFit();
    for (const auto changed : {&WizardController::statusChanged,
             &WizardController::currentAxisChanged, &WizardController::selectedTableChanged})
        connect(&controller, changed, &q, [this] { tellDrive(); });
    connect(&controller.setup(), &SetupModel::fieldChanged, &q, [this] { tellDrive(); });
    tellDrive();
    const auto offerUse = [this] {
        const ActionState open = controller.action(Action::OpenData);
        fit->setObstacle(open.isEnabled ? QString() : open.reason);
    };
    connect(&controller, &WizardController::actionsChanged, fit, offerUse);
    offerUse();
}

/// The axis that a table is made for, with the source that it will have.
void CompensationWizard::Private::tellDrive()
{
    FitDrive drive;
    drive.profile = options.profile;
    drive.storeRoot = options.storeRoot;
    if (const auto& status = controller.status()) {
        drive.axis = axisOfDrive(*status, *options.profile);
        drive.axis->source = lookupSource(
            *options.profile, status->axis.index, sourcePaths(controller.setup().edited()));
        if (const auto& table = status->table)
            drive.held = identityOf(*table);
        drive.table = controller.driveTable();
    }
    record.setDrive(drive);
}

/// What was promised is noted with the table, once Write has it.
void CompensationWizard::Private::useTable(
    const std::shared_ptr<const FitOutcome>& outcome, std::size_t table)
{
    using Calibration = std::shared_ptr<const CalibrationRecord>;
    const auto begun = inBackground<Calibration>([outcome] { return calibrationOf(*outcome); });
    whenDone(begun, &q, [this, outcome, table](const Calibration& calibration) {
        // Another record may be there by now: the table is of none of its files.
        if (outcome->request.record.files != record.record().files)
            return;
        if (!calibration || !controller.useTables(madeTables(*outcome, table)))
            return;
        // Of the tables that are there already stays what was written and measured.
        const auto& now = record.record().calibration;
        const auto isSame = [](const RecordedTable& one, const RecordedTable& other) {
            return isSameTable(one, other);
        };
        if (!now || !std::ranges::equal(now->tables, calibration->tables, isSame))
            record.setCalibration(calibration);
        page->tabs->setCurrentIndex(PageTabs::Write);
    });
}

void CompensationWizard::Private::showMarkOfFit()
{
    const FitPage::State state = fit->state();
    page->tabs->setMark(PageTabs::Fit,
        state == FitPage::State::Empty         ? PageTabs::Mark::Empty
            : state == FitPage::State::Warning ? PageTabs::Mark::Warning
                                               : PageTabs::Mark::Ready);
}

void CompensationWizard::Private::addShortcut(
    const QKeySequence& keys, std::function<void()> action)
{
    auto* shortcut = new QShortcut(keys, &q);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, &q, std::move(action));
}

void CompensationWizard::Private::addShortcuts()
{
    addShortcut(QKeySequence::Refresh, [this] {
        if (controller.action(Action::Refresh).isEnabled)
            controller.refresh();
    });
    addShortcut(QKeySequence::HelpContents,
        [this] { showGuide(guidePlaceOf(QApplication::focusWidget())); });
    addShortcut(QKeySequence::Open, [this] {
        if (isWriteShown())
            files.askAndOpen();
        else
            files.askForMeasurements();
    });
    // What changes the setup or the drive needs what it changes in sight.
    for (const auto key : {Qt::Key_Return, Qt::Key_Enter})
        addShortcut(Qt::CTRL | key, [this] {
            if (isWriteShown())
                proceedToWrite();
        });
    addShortcut(Qt::CTRL | Qt::Key_R, [this] {
        if (isWriteShown())
            page->setup->revertFocused();
    });
    addShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_R, [this] {
        if (isWriteShown() && controller.action(Action::Revert).isEnabled)
            controller.setup().revert();
    });
    addShortcut(Qt::CTRL | Qt::Key_PageUp, [this] { page->tabs->step(-1); });
    addShortcut(Qt::CTRL | Qt::Key_PageDown, [this] { page->tabs->step(1); });
    addShortcut(Qt::CTRL | Qt::Key_Z, [this] { undo(); });
    addShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_Z, [this] { redo(); });
    addShortcut(Qt::CTRL | Qt::Key_Y, [this] { redo(); });
    addShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_O, [this] { showOverview(); });
    addShortcut(Qt::CTRL | Qt::Key_L, [this] { page->showLog(!page->isLogShown()); });
}

void CompensationWizard::Private::start()
{
    if (isStarted)
        return;
    isStarted = true;
    recordActions.lookForUnsaved();
    if (!controller.endpoints().isEmpty())
        return;
    const QStringList known = settings.endpoints();
    controller.setEndpoints(known.isEmpty() ? QStringList(demoEndpoint) : known);
    if (known.isEmpty())
        messages.offerDemo();
}

void CompensationWizard::Private::chooseDrive(const QString& endpoint)
{
    const auto& axes = controller.axes();
    const int current = controller.currentAxis();
    if (current >= 0 && axes.at(static_cast<std::size_t>(current)).endpoint == endpoint)
        return;
    const int usable = controller.usableAxisOf(endpoint);
    if (usable >= 0)
        chooseAxis(usable);
    else
        messages.showUnreachable(endpoint);
}

void CompensationWizard::Private::chooseAxis(int index)
{
    messages.forgetUnreachable();
    // Until the question is answered another drive's axes may come before it.
    guard.loseChanges(UnsavedChangesGuard::Reason::ChangeAxis,
        [this, entry = controller.axes().at(static_cast<std::size_t>(index))] {
            controller.selectAxis(entry);
        });
}

void CompensationWizard::Private::showConnections()
{
    if (!connections) {
        connections = new ConnectionsDialog(controller,
            {options.linkFactory, options.portCandidates, options.network, options.profile,
                options.storeRoot, options.timeout},
            &q);
        connect(connections, &ConnectionsDialog::endpointsAccepted, &q,
            [this](const QStringList& endpoints) { takeEndpoints(endpoints); });
        connect(connections, &ConnectionsDialog::certificateTrusted, &controller,
            &WizardController::refresh);
    }
    connections->open();
}

void CompensationWizard::Private::askAboutCertificate(const RejectedCertificate& certificate)
{
    auto* dialog = new CertificateDialog(certificate, options.storeRoot, &q);
    connect(dialog, &CertificateDialog::trusted, &controller, &WizardController::refresh);
    connect(dialog, &QDialog::rejected, &messages, &MessagePresenter::showConnection);
    dialog->open();
}

void CompensationWizard::Private::takeEndpoints(const QStringList& endpoints)
{
    if (endpoints == controller.endpoints())
        return;
    guard.loseChanges(UnsavedChangesGuard::Reason::ChangeConnections, [this, endpoints] {
        settings.setEndpoints(endpoints);
        page->messages->remove(QStringLiteral("demoMessage"));
        controller.setEndpoints(endpoints);
    });
}

void CompensationWizard::Private::showBackups()
{
    if (!controller.status())
        return;
    auto* dialog =
        new BackupDialog(controller, *options.profile, options.storeRoot, files.picker(), &q);
    connect(
        dialog, &BackupDialog::chosen, &q, [this](const BackupChoice& choice) { restore(choice); });
    dialog->open();
}

/// A backup of another axis of the drive goes to that axis.
void CompensationWizard::Private::restore(const BackupChoice& choice)
{
    const auto& axes = controller.axes();
    const auto found = std::ranges::find_if(axes, [&](const AxisEntry& entry) {
        return entry.axis.index == choice.axis && controller.isCurrentDrive(entry);
    });
    if (found == axes.end())
        return;
    if (found - axes.begin() == controller.currentAxis()) {
        writeFlow.restore(choice, *found);
        return;
    }
    guard.loseChanges(UnsavedChangesGuard::Reason::ChangeAxis, [this, entry = *found, choice] {
        if (controller.selectAxis(entry))
            writeFlow.restore(choice, entry);
    });
}

void CompensationWizard::Private::begin(Action action)
{
    if (!controller.action(action).isEnabled)
        return;
    if (action == Action::ImportConfiguration)
        files.importConfiguration();
    else if (action == Action::ExportConfiguration)
        files.exportConfiguration();
    else if (action == Action::BackUpDrive)
        files.backUpDrive();
    else if (action == Action::RestoreDrive)
        files.restoreDrive();
    else
        (new MultiAxisDialog(controller, &q))->open();
}

void CompensationWizard::Private::offerActions()
{
    for (const Action action : PageMenu::drivenActions)
        menu->showAction(action, controller.action(action));
}

void CompensationWizard::Private::offerHistory()
{
    if (!isWriteShown()) {
        menu->showHistory(record.undoText(), record.redoText());
        return;
    }
    const bool isBusy = controller.busy().isBusy;
    const SetupHistory& history = controller.history();
    menu->showHistory(
        isBusy ? QString() : history.undoText(), isBusy ? QString() : history.redoText());
}

void CompensationWizard::Private::undo()
{
    if (!isWriteShown())
        record.undo();
    else if (!controller.busy().isBusy)
        controller.history().undo();
}

void CompensationWizard::Private::redo()
{
    if (!isWriteShown())
        record.redo();
    else if (!controller.busy().isBusy)
        controller.history().redo();
}

void CompensationWizard::Private::chooseLanguage(const QString& chosen)
{
    settings.setLanguage(chosen);
    language.select(chosen);
    menu->showLanguage(chosen);
}

void CompensationWizard::Private::skipPreview(bool isSkipped)
{
    settings.setPreviewSkippedForVolatile(isSkipped);
    menu->showPreviewSkipped(isSkipped);
    page->preview->writePreview().setSkippedForVolatile(isSkipped);
}

void CompensationWizard::Private::showGuide(const GuidePlace& place)
{
    if (!guide)
        guide = new GuideWindow(&q);
    guide->showPlace(place);
}

/// A dialog that is open keeps other windows from being used, but not its own.
void CompensationWizard::Private::showGuideOver(QDialog& dialog)
{
    auto* over = dialog.findChild<GuideWindow*>(QString(), Qt::FindDirectChildrenOnly);
    if (!over)
        over = new GuideWindow(&dialog);
    over->showPlace(guidePlaceOf(QApplication::focusWidget()));
}

void CompensationWizard::Private::showOverview()
{
    if (!overview) {
        overview = new OverviewDialog(controller, &q);
        connect(overview, &OverviewDialog::applyRequested, &machine, &MachineActions::apply);
        connect(overview, &OverviewDialog::axisChosen, &q, [this](int index) {
            if (index != controller.currentAxis())
                chooseAxis(index);
        });
    }
    overview->show();
    overview->raise();
    overview->activateWindow();
}

void CompensationWizard::Private::announceTitle()
{
    const int axis = controller.currentAxis();
    const QString program = CompensationWizard::tr("Axis Compensation Wizard");
    const QString title = axis < 0 ? program
                                   : program + QStringLiteral(" - ")
            + controller.axes().at(static_cast<std::size_t>(axis)).label;
    const RecordFile& file = recordActions.file();
    Q_EMIT q.titleChanged(QStringLiteral("[*]") + title,
        controller.setup().isDirty() || (file.isModified() && !file.isEmpty()));
}

bool CompensationWizard::Private::isWriteShown() const
{
    return page->tabs->currentIndex() == PageTabs::Write;
}

/// One file that has its place whatever is shown, such as a record; one file on Write; the files of
/// a measurement elsewhere.
bool CompensationWizard::Private::isWelcome(const QStringList& dragged) const
{
    if (std::ranges::any_of(dragged, &hasItsPlace))
        return dragged.size() == 1;
    if (isWriteShown())
        return dragged.size() == 1 && controller.action(Action::OpenData).isEnabled;
    return !dragged.isEmpty();
}

/// Where it belongs. But on the tabs of a measurement a file is one of a measurement, unless it
/// certainly is something else: which column of a CSV file is what is said there.
void CompensationWizard::Private::open(const QStringList& dropped)
{
    RecordModel* const measurement = isWriteShown() ? nullptr : &measurementShown();
    if (measurement && dropped.size() > 1)
        return measurement->addFiles(dropped);
    recognise(dropped.front(),
        [this, path = dropped.front(), measurement](const Result<FileKind>& found) {
            const bool isOther = found && *found != FileKind::Measurement
                && (*found != FileKind::Table || kindOfName(path.toStdString()));
            if (measurement && !isOther)
                measurement->addFiles({path});
            else
                showFile(found, path);
        });
}

/// As compensation data, unless its name says something else.
void CompensationWizard::Private::openData(const QString& path)
{
    if (hasItsPlace(path))
        openAs(*kindOfName(path.toStdString()), path);
    else
        files.open(path);
}

void CompensationWizard::Private::recognise(
    const QString& path, std::function<void(const Result<FileKind>&)> show)
{
    const auto kind = inBackground<Result<FileKind>>(
        [file = QFileInfo(path).filesystemAbsoluteFilePath()] { return kindOfFile(file); });
    whenDone(kind, &q, std::move(show));
}

void CompensationWizard::Private::showFile(const Result<FileKind>& kind, const QString& path)
{
    if (kind)
        openAs(*kind, path);
    else
        messages.showFailure(errorText(kind.error()));
}

void CompensationWizard::Private::openAs(FileKind kind, const QString& path)
{
    switch (kind) {
    case FileKind::Record:
        recordActions.open(path);
        break;
    case FileKind::MachineFile:
        machine.open(path);
        break;
    case FileKind::Configuration:
        page->tabs->setCurrentIndex(PageTabs::Write);
        whenPossible(
            Action::ImportConfiguration, path, [this, path] { files.importConfigurationOf(path); });
        break;
    case FileKind::Table:
        page->tabs->setCurrentIndex(PageTabs::Write);
        whenPossible(Action::OpenData, path, [this, path] { files.open(path); });
        break;
    case FileKind::Measurement:
        page->tabs->setCurrentIndex(PageTabs::Measure);
        record.addFiles({path});
        break;
    }
}

/// open: called as soon as the action is possible. Only the last file waits.
void CompensationWizard::Private::whenPossible(
    Action action, const QString& path, std::function<void()> open)
{
    page->messages->remove(waitingId);
    waiting = {action, QFileInfo(path).fileName(), std::move(open)};
    openWaiting();
}

void CompensationWizard::Private::openWaiting()
{
    if (!waiting)
        return;
    const ActionState state = controller.action(waiting->action);
    const bool isPutAway = waiting->isSaid && !page->messages->contains(waitingId);
    if (isPutAway || state.isEnabled) {
        page->messages->remove(waitingId);
        const auto open = std::exchange(waiting, {})->open;
        if (!isPutAway)
            open();
        return;
    }
    Message message;
    message.id = waitingId;
    message.text = CompensationWizard::tr("%1 is opened as soon as that is possible. %2")
                       .arg(waiting->name, state.reason);
    waiting->isSaid = true;
    if (page->messages->text(waitingId) != message.text)
        page->messages->show(message);
}

void CompensationWizard::Private::showMarkOfMeasure()
{
    const RecordState& state = record.state();
    const bool hasProblems =
        state.refusal || std::ranges::any_of(state.files, [](const ReadMeasurement& file) {
            return file.refusal || (file.reading && !file.reading->diagnostics.empty());
        });
    page->tabs->setMark(PageTabs::Measure,
        record.record().files.empty() ? PageTabs::Mark::Empty
            : hasProblems             ? PageTabs::Mark::Warning
            : state.measurement       ? PageTabs::Mark::Ready
                                      : PageTabs::Mark::Empty);
}

CompensationWizard::CompensationWizard(WizardOptions options, QSettings* settings, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(*this, options, settings))
{
    setObjectName(QStringLiteral("compensationWizard"));
    setAcceptDrops(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(d->page);
    d->connectParts();
    d->addShortcuts();
    qApp->installEventFilter(this);
}

/// The keys of the page end at its window: F1 in a dialog comes by here.
bool CompensationWizard::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType()
        || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::HelpContents))
        return QWidget::eventFilter(watched, event);
    auto* dialog = qobject_cast<QDialog*>(static_cast<QWidget*>(watched)->window());
    bool isOfPage = false;
    for (const QWidget* parent = dialog; parent && !isOfPage; parent = parent->parentWidget())
        isOfPage = parent == this;
    if (!isOfPage || qobject_cast<GuideWindow*>(dialog))
        return QWidget::eventFilter(watched, event);
    d->showGuideOver(*dialog);
    return true;
}

CompensationWizard::~CompensationWizard()
{
    d->page->saveSplitters(d->settings);
    // The widgets refer to what d owns, so they go first.
    const auto children = findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly);
    qDeleteAll(children);
}

WizardController& CompensationWizard::controller()
{
    return d->controller;
}

void CompensationWizard::openData(const QString& path)
{
    d->openData(path);
}

void CompensationWizard::openRecord(const QString& path)
{
    d->recordActions.open(path);
}

void CompensationWizard::openFile(const QString& path)
{
    d->recognise(path, [this, path](const Result<FileKind>& kind) { d->showFile(kind, path); });
}

bool CompensationWizard::mayClose()
{
    return d->guard.mayClose();
}

void CompensationWizard::closeNow()
{
    d->guard.closeNow();
}

void CompensationWizard::setFilePicker(FilePicker picker)
{
    d->files.setPicker(std::move(picker));
}

void CompensationWizard::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange && d) {
        d->controller.retranslate();
        d->menu->retranslate();
        d->offerHistory();
        d->page->retranslate();
        d->measure->retranslate();
        d->judge->retranslate();
        d->recordActions.retranslate();
        d->fit->retranslate();
        d->messages.retranslate();
        d->openWaiting();
        d->guard.retranslate();
        d->announceTitle();
    }
    QWidget::changeEvent(event);
}

void CompensationWizard::dragEnterEvent(QDragEnterEvent* event)
{
    const QStringList files = draggedFiles(*event->mimeData());
    if (!d->isWelcome(files))
        return;
    event->acceptProposedAction();
    const QString name = QFileInfo(files.front()).fileName();
    d->dropFrame->showFor(files.size() == 1 ? name : name + QStringLiteral(", …"));
}

void CompensationWizard::dragLeaveEvent(QDragLeaveEvent* event)
{
    d->dropFrame->hide();
    QWidget::dragLeaveEvent(event);
}

void CompensationWizard::dropEvent(QDropEvent* event)
{
    d->dropFrame->hide();
    const QStringList files = draggedFiles(*event->mimeData());
    if (!d->isWelcome(files))
        return;
    event->acceptProposedAction();
    d->open(files);
}

void CompensationWizard::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (d->writeFlow.isPreviewing())
        d->writeFlow.back();
    else if (d->controller.busy().canCancel)
        d->controller.cancel();
    else
        QWidget::keyPressEvent(event);
}

void CompensationWizard::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    // After the first paint.
    QTimer::singleShot(0, this, [this] { d->start(); });
}

} // namespace axiscomp::ui
