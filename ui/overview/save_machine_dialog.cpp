// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overview/save_machine_dialog.h"

#include "ui/controller/machine_controller.h"
#include "ui/controller/wizard_controller.h"
#include "ui/dialogs/several_writes_dialog.h"
#include "ui/style/busy_mark.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/style/warning_list.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QDir>
#include <QEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>

#include <map>
#include <utility>

namespace axiscomp::ui {

using Stage = MachineSaving::Stage;

SaveMachineDialog::SaveMachineDialog(
    WizardController& controller, FilePicker picker, QString folder, QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_saving(controller.machine().saving())
    , m_picker(std::move(picker))
    , m_startFolder(std::move(folder))
    , m_introduction(wrappedLabel("saveMachineIntroduction"))
    , m_nameLabel(new PlainLabel)
    , m_name(new QLineEdit)
    , m_drivesLabel(new PlainLabel)
    , m_drives(new QListWidget)
    , m_warnings(new WarningList)
    , m_busy(new BusyMark)
    , m_reason(wrappedLabel("saveMachineReason"))
    , m_replace(new QPushButton)
    , m_save(new QPushButton)
    , m_close(new QPushButton)
{
    setObjectName(QStringLiteral("saveMachineDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_saving.drop();
    build();
    listDrives();
    const auto& file = controller.machine().file();
    if (file && file->reading.machine)
        m_name->setText(qString(file->reading.machine->name));
    connect(m_save, &QPushButton::clicked, this, &SaveMachineDialog::askForFolder);
    connect(m_replace, &QPushButton::clicked, &m_saving, &MachineSaving::replace);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_drives, &QListWidget::itemChanged, this, &SaveMachineDialog::takeChoice);
    connect(m_name, &QLineEdit::textEdited, this, &SaveMachineDialog::takeChoice);
    connect(&m_saving, &MachineSaving::changed, this, &SaveMachineDialog::refresh);
    connect(&controller, &WizardController::drivesChanged, this, &SaveMachineDialog::listDrives);
    connect(&controller, &WizardController::busyChanged, this, &SaveMachineDialog::refresh);
    retranslate();
}

SaveMachineDialog::~SaveMachineDialog()
{
    m_saving.disconnect(this);
    m_saving.drop();
}

void SaveMachineDialog::build()
{
    m_name->setObjectName(QStringLiteral("machineName"));
    m_nameLabel->setBuddy(m_name);
    m_drives->setObjectName(QStringLiteral("machineDrives"));
    m_drivesLabel->setBuddy(m_drives);
    m_warnings->setObjectName(QStringLiteral("saveMachineWarnings"));
    m_replace->setObjectName(QStringLiteral("replaceMachineButton"));
    m_save->setObjectName(QStringLiteral("saveMachineButton"));
    m_close->setObjectName(QStringLiteral("closeSaveMachineButton"));
    m_save->setDefault(true);
    for (QPushButton* button : {m_replace, m_close})
        button->setAutoDefault(false);
    auto* state = new QHBoxLayout;
    state->addWidget(m_reason, 1);
    state->addWidget(m_busy);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_replace);
    buttons->addWidget(m_save);
    buttons->addWidget(m_close);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_introduction);
    layout->addWidget(m_nameLabel);
    layout->addWidget(m_name);
    layout->addWidget(m_drivesLabel);
    layout->addWidget(m_drives, 1);
    layout->addWidget(m_warnings);
    layout->addLayout(state);
    layout->addLayout(buttons);
    resize(640, 460);
}

void SaveMachineDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void SaveMachineDialog::retranslate()
{
    setWindowTitle(tr("Save Machine File"));
    m_introduction->setText(tr("Writes machine.toml and the tables of all axes into a folder. The "
                               "drives are only read."));
    m_nameLabel->setText(tr("&Name of the machine (may be empty)"));
    m_drivesLabel->setText(tr("&Drives"));
    m_name->setAccessibleName(tr("Name of the machine"));
    m_drives->setAccessibleName(tr("Drives of the machine"));
    m_replace->setText(tr("&Replace These Files"));
    m_save->setText(tr("&Save in Folder…"));
    m_close->setText(tr("C&lose"));
    m_close->setToolTip(tr("Go back to the page (Esc)"));
    refresh();
}

/// What was ticked stays so. A demo drive is no part of a machine, unless somebody says so.
void SaveMachineDialog::listDrives()
{
    const QSignalBlocker blocker(m_drives);
    std::map<QString, Qt::CheckState> known;
    for (int row = 0; row < m_drives->count(); ++row)
        known[m_drives->item(row)->data(Qt::UserRole).toString()] =
            m_drives->item(row)->checkState();
    m_drives->clear();
    for (const DriveState& drive : m_controller.drives()) {
        const QString text = drive.name.isEmpty()
            ? drive.endpoint
            : drive.name + QStringLiteral(" · ") + drive.endpoint;
        auto* item = new QListWidgetItem(drive.connection == DriveState::Connection::Connected
                ? text
                : tr("%1 (does not answer)", "drive").arg(text),
            m_drives);
        item->setData(Qt::UserRole, drive.endpoint);
        const auto state = known.find(drive.endpoint);
        item->setCheckState(state != known.end() ? state->second
                : drive.isDemo                   ? Qt::Unchecked
                                                 : Qt::Checked);
    }
    refresh();
}

/// What was read and waits for an answer is not what is chosen now.
void SaveMachineDialog::takeChoice()
{
    if (m_saving.stage() == Stage::Asking)
        m_saving.drop();
    refresh();
}

QStringList SaveMachineDialog::chosen() const
{
    QStringList endpoints;
    for (int row = 0; row < m_drives->count(); ++row)
        if (m_drives->item(row)->checkState() == Qt::Checked)
            endpoints += m_drives->item(row)->data(Qt::UserRole).toString();
    return endpoints;
}

QString SaveMachineDialog::obstacle() const
{
    const QStringList wanted = chosen();
    if (wanted.isEmpty())
        return tr("No drive is chosen.");
    for (const DriveState& drive : m_controller.drives())
        if (wanted.contains(drive.endpoint)
            && drive.connection != DriveState::Connection::Connected)
            return tr("%1 does not answer: a machine file without one of its drives would be "
                      "another machine.")
                .arg(drive.name.isEmpty() ? drive.endpoint : drive.name);
    if (m_controller.isWriting())
        return tr("Wait for the end of the write.");
    return {};
}

void SaveMachineDialog::refresh()
{
    const Stage stage = m_saving.stage();
    const bool isBusy = stage == Stage::Reading || stage == Stage::Saving;
    const QString reason = obstacle();
    m_busy->setBusy(isBusy);
    m_name->setEnabled(!isBusy);
    m_drives->setEnabled(!isBusy);
    m_save->setEnabled(!isBusy && reason.isEmpty());
    m_save->setToolTip(
        reason.isEmpty() ? tr("Files that are there are not replaced unasked") : reason);
    m_save->setAccessibleDescription(m_save->toolTip());
    m_replace->setVisible(stage == Stage::Asking);
    QStringList warnings;
    if (stage == Stage::Asking)
        warnings += tr("The folder has other files of these names, which would be replaced: %1.")
                        .arg(listText(m_saving.replaced()));
    if (warnings != m_warnings->warnings())
        m_warnings->setWarnings(warnings);
    QString text = reason;
    std::optional<Tone> tone;
    if (stage == Stage::Reading) {
        text = tr("Reading the drives …");
    } else if (stage == Stage::Saving) {
        text = tr("Saving …");
    } else if (stage == Stage::Asking) {
        text = tr("Nothing is saved yet.");
    } else if (stage == Stage::Failed) {
        text = errorText(*m_saving.problem());
        if (!m_saving.problemPlace().isEmpty())
            text = tr("%1: %2", "drive and problem").arg(m_saving.problemPlace(), text);
        tone = Tone::Error;
    } else if (stage == Stage::Saved) {
        const MachineSnapshot& saved = *m_saving.snapshot();
        text = tr("Saved %1: drives: %2, tables: %3.")
                   .arg(QDir::toNativeSeparators(
                            QDir(m_saving.folder()).filePath(QLatin1StringView(machineFileName))),
                       countText(saved.drives), countText(saved.tables()));
        tone = Tone::Success;
    }
    m_reason->setText(text);
    m_reason->setTone(tone);
}

void SaveMachineDialog::askForFolder()
{
    m_picker(*this,
        {FileQuestion::Purpose::SaveMachine, tr("Folder for the Machine File"), {}, m_startFolder},
        [dialog = QPointer(this)](const QString& folder) {
            if (dialog)
                dialog->save(folder);
        });
}

void SaveMachineDialog::save(const QString& folder)
{
    m_startFolder = folder;
    if (obstacle().isEmpty())
        m_saving.save(chosen(), m_name->text().trimmed(), folder);
}

} // namespace axiscomp::ui
