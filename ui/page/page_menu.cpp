// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/page_menu.h"

#include "ui/help/documentation_site.h"
#include "ui/style/symbols.h"
#include "ui/text/language.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QMessageBox>
#include <QUrl>

namespace axiscomp::ui {

PageMenu::PageMenu(QWidget* parent)
    : QMenu(parent)
    , m_undo(addAction(QString()))
    , m_redo(addAction(QString()))
    , m_languages(addMenu(QString()))
    , m_languageGroup(new QActionGroup(this))
    , m_systemLanguage(m_languages->addAction(QString()))
    , m_overview(addAction(QString()))
    , m_machine(addMenu(QString()))
    , m_openMachine(m_machine->addAction(QString()))
    , m_planMachine(m_machine->addAction(QString()))
    , m_applyMachine(m_machine->addAction(QString()))
    , m_saveMachine(m_machine->addAction(symbolIcon(Symbol::Save), QString()))
    , m_closeMachine(m_machine->addAction(QString()))
    , m_writeSeveral(addAction(QString()))
    , m_importConfiguration(addAction(QString()))
    , m_exportConfiguration(addAction(QString()))
    , m_backUpDrive(addAction(QString()))
    , m_restoreDrive(addAction(QString()))
    , m_preview(addAction(QString()))
    , m_export(addAction(symbolIcon(Symbol::Save), QString()))
    , m_saveLog(addAction(symbolIcon(Symbol::Save), QString()))
    , m_help(addMenu(QString()))
    , m_guide(m_help->addAction(QString()))
    , m_documentation(m_help->addAction(QString()))
    , m_about(m_help->addAction(QString()))
{
    setObjectName(QStringLiteral("pageMenu"));
    setToolTipsVisible(true);
    m_undo->setObjectName(QStringLiteral("undoAction"));
    m_redo->setObjectName(QStringLiteral("redoAction"));
    insertSeparator(m_languages->menuAction());
    m_languages->setObjectName(QStringLiteral("languageMenu"));
    fillLanguages();
    m_overview->setObjectName(QStringLiteral("overviewAction"));
    m_machine->setObjectName(QStringLiteral("machineMenu"));
    m_machine->setToolTipsVisible(true);
    m_openMachine->setObjectName(QStringLiteral("openMachineAction"));
    m_planMachine->setObjectName(QStringLiteral("planMachineAction"));
    m_applyMachine->setObjectName(QStringLiteral("applyMachineAction"));
    m_saveMachine->setObjectName(QStringLiteral("saveMachineAction"));
    connect(m_applyMachine, &QAction::triggered, this, &PageMenu::applyMachineRequested);
    connect(m_saveMachine, &QAction::triggered, this, &PageMenu::saveMachineRequested);
    m_closeMachine->setObjectName(QStringLiteral("closeMachineAction"));
    connect(m_openMachine, &QAction::triggered, this, &PageMenu::openMachineRequested);
    connect(m_planMachine, &QAction::triggered, this, &PageMenu::planMachineRequested);
    connect(m_closeMachine, &QAction::triggered, this, &PageMenu::closeMachineRequested);
    showMachine(false, false);
    m_writeSeveral->setObjectName(QStringLiteral("writeSeveralAction"));
    m_importConfiguration->setObjectName(QStringLiteral("importConfigurationAction"));
    m_exportConfiguration->setObjectName(QStringLiteral("exportConfigurationAction"));
    m_backUpDrive->setObjectName(QStringLiteral("backUpDriveAction"));
    m_restoreDrive->setObjectName(QStringLiteral("restoreDriveAction"));
    m_preview->setObjectName(QStringLiteral("previewVolatileAction"));
    m_preview->setCheckable(true);
    m_preview->setChecked(true);
    m_export->setObjectName(QStringLiteral("exportAction"));
    m_saveLog->setObjectName(QStringLiteral("saveLogAction"));
    insertSeparator(m_help->menuAction());
    m_help->setObjectName(QStringLiteral("helpMenu"));
    m_guide->setObjectName(QStringLiteral("guideAction"));
    prepareDocumentation();
    m_about->setObjectName(QStringLiteral("aboutAction"));
    for (const Action action : drivenActions)
        connect(entryOf(action), &QAction::triggered, this,
            [this, action] { Q_EMIT actionRequested(action); });
    connect(m_preview, &QAction::triggered, this,
        [this](bool isShown) { Q_EMIT previewSkippedChosen(!isShown); });
    connect(m_undo, &QAction::triggered, this, &PageMenu::undoRequested);
    connect(m_redo, &QAction::triggered, this, &PageMenu::redoRequested);
    connect(m_export, &QAction::triggered, this, &PageMenu::exportRequested);
    connect(m_saveLog, &QAction::triggered, this, &PageMenu::saveLogRequested);
    connect(m_overview, &QAction::triggered, this, &PageMenu::overviewRequested);
    connect(m_guide, &QAction::triggered, this, &PageMenu::guideRequested);
    connect(m_about, &QAction::triggered, this, &PageMenu::showAbout);
    retranslate();
}

void PageMenu::fillLanguages()
{
    m_systemLanguage->setData(QString());
    m_languages->addSeparator();
    for (const QString& language : Language::available()) {
        QAction* action = m_languages->addAction(Language::nativeName(language));
        action->setData(language);
    }
    const auto actions = m_languages->actions();
    for (QAction* action : actions) {
        if (action->isSeparator())
            continue;
        action->setCheckable(true);
        action->setObjectName(QStringLiteral("language_") + action->data().toString());
        m_languageGroup->addAction(action);
    }
    connect(m_languageGroup, &QActionGroup::triggered, this,
        [this](const QAction* action) { Q_EMIT languageChosen(action->data().toString()); });
}

void PageMenu::showLanguage(const QString& language)
{
    const auto actions = m_languageGroup->actions();
    for (QAction* action : actions)
        action->setChecked(action->data().toString() == language);
}

void PageMenu::showPreviewSkipped(bool isSkipped)
{
    m_preview->setChecked(!isSkipped);
}

void PageMenu::setExportEnabled(bool isEnabled)
{
    m_export->setEnabled(isEnabled);
    m_export->setToolTip(isEnabled ? tr("Save the selected table as a file for another controller")
                                   : tr("No table is selected."));
}

void PageMenu::showMachine(bool isOpen, bool mayPlan)
{
    m_planMachine->setEnabled(mayPlan);
    m_planMachine->setToolTip(!isOpen ? tr("No machine file is open.")
            : mayPlan ? tr("Read the machine file again and compare all drives with it")
                      : tr("The drives are being compared."));
    m_applyMachine->setEnabled(isOpen);
    m_applyMachine->setToolTip(isOpen
            ? tr("Show what would be written to all drives, before anything is written")
            : tr("No machine file is open."));
    m_closeMachine->setEnabled(isOpen);
    m_closeMachine->setToolTip(isOpen ? tr("The drives stay connected; nothing is changed")
                                      : tr("No machine file is open."));
}

void PageMenu::showHistory(const QString& undo, const QString& redo)
{
    m_undoText = undo;
    m_redoText = redo;
    // The keys are the page's: those of a closed menu do nothing.
    m_undo->setText(
        (undo.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undo)) + QStringLiteral("\tCtrl+Z"));
    m_redo->setText((redo.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redo))
        + QStringLiteral("\tCtrl+Shift+Z"));
    m_undo->setEnabled(!undo.isEmpty());
    m_redo->setEnabled(!redo.isEmpty());
    m_undo->setToolTip(tr("Takes the last change of the fields back; the drive is not reached"));
    m_redo->setToolTip(tr("Makes the change that was undone again"));
}

QAction* PageMenu::entryOf(Action action) const
{
    return action == Action::WriteSeveral       ? m_writeSeveral
        : action == Action::ImportConfiguration ? m_importConfiguration
        : action == Action::ExportConfiguration ? m_exportConfiguration
        : action == Action::BackUpDrive         ? m_backUpDrive
                                                : m_restoreDrive;
}

void PageMenu::showAction(Action action, const ActionState& state)
{
    entryOf(action)->setEnabled(state.isEnabled);
    entryOf(action)->setToolTip(state.reason);
}

void PageMenu::retranslate()
{
    showHistory(m_undoText, m_redoText);
    m_languages->setTitle(tr("&Language"));
    m_systemLanguage->setText(tr("&System Language"));
    m_overview->setText(tr("&Overview of All Axes…") + QStringLiteral("\tCtrl+Shift+O"));
    m_overview->setToolTip(tr("State and table of each axis of all connected drives"));
    m_machine->setTitle(tr("&Machine"));
    m_openMachine->setText(tr("&Open Machine File…"));
    m_openMachine->setToolTip(
        tr("Compare all drives of a machine with the file that says which tables they have"));
    m_planMachine->setText(tr("&Plan Again"));
    m_applyMachine->setText(tr("&Apply…"));
    m_saveMachine->setText(tr("&Save Machine File…"));
    m_saveMachine->setToolTip(
        tr("Running drives as a machine file with all tables, in a folder of your choice"));
    m_closeMachine->setText(tr("&Close Machine File"));
    showMachine(m_closeMachine->isEnabled(), m_planMachine->isEnabled());
    m_writeSeveral->setText(tr("&Write Several Axes…"));
    m_importConfiguration->setText(tr("&Import TAM Configuration…"));
    m_exportConfiguration->setText(tr("Export to &TAM Configuration…"));
    m_backUpDrive->setText(tr("Ba&ck Up Whole Drive…"));
    m_restoreDrive->setText(tr("Restore Whole &Drive…"));
    m_preview->setText(tr("Show &Preview Before Volatile Writes"));
    m_preview->setToolTip(tr("Persistent writes always show the preview"));
    m_export->setText(tr("&Export for Another Controller…"));
    setExportEnabled(m_export->isEnabled());
    m_saveLog->setText(tr("Save Lo&g…"));
    m_help->setTitle(tr("&Help"));
    m_guide->setText(tr("User &Guide") + QStringLiteral("\tF1"));
    m_documentation->setText(tr("Documentation in the &Browser"));
    m_about->setText(tr("&About"));
}

/// It may be installed and removed while the window is open.
void PageMenu::prepareDocumentation()
{
    m_documentation->setObjectName(QStringLiteral("documentationAction"));
    connect(m_documentation, &QAction::triggered, this, &PageMenu::openDocumentation);
    const auto showOrHide = [this] {
        m_documentation->setVisible(!installedDocumentation().isEmpty());
    };
    connect(m_help, &QMenu::aboutToShow, this, showOrHide);
    showOrHide();
}

void PageMenu::openDocumentation()
{
    const QString page = installedDocumentation();
    if (QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
        return;
    auto* box = new QMessageBox(parentWidget());
    box->setObjectName(QStringLiteral("documentationBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setIcon(QMessageBox::Information);
    box->setWindowTitle(tr("Documentation"));
    box->setText(tr("No browser could be opened. The documentation is in %1.").arg(page));
    box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    box->open();
}

void PageMenu::showAbout()
{
    auto* box = new QMessageBox(parentWidget());
    box->setObjectName(QStringLiteral("aboutBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setIconPixmap(QPixmap(QStringLiteral(":/axiscomp/icons/axis-compensation-wizard-64.png")));
    box->setWindowTitle(tr("About"));
    box->setText(
        tr("<b>Axis Compensation Wizard</b> %1").arg(QCoreApplication::applicationVersion()));
    box->setInformativeText(
        tr("Writes error compensation tables to servo drives, activates them and proves that the "
           "drive applies them.\n\nA compensation value is reference minus encoder; the drive adds "
           "it to the encoder position.\n\nFree software under the GNU General Public License, "
           "version 3 or later."));
    box->open();
}

} // namespace axiscomp::ui
