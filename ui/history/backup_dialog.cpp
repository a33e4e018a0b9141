// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/backup_dialog.h"

#include "ui/controller/wizard_controller.h"
#include "ui/plot/change_pictures.h"
#include "ui/plot/table_thumbnail.h"
#include "ui/style/plain_label.h"
#include "ui/style/warning_list.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

namespace {

enum BackupColumn { DateColumn, BackupAxisColumn, BackupTableColumn, CrcColumn, WriteColumn };

QString writeText(const KeptBackup& backup)
{
    using Write = KeptBackup::Write;
    if (backup.problem)
        return BackupDialog::tr("damaged", "backup");
    if (!backup.write)
        return BackupDialog::tr("last write", "what was done after the backup");
    switch (*backup.write) {
    case Write::NewTable:
        return BackupDialog::tr("new table", "what was done after the backup");
    case Write::NoTable:
        return BackupDialog::tr("table deleted", "what was done after the backup");
    case Write::Settings:
        return BackupDialog::tr("settings changed", "what was done after the backup");
    case Write::Nothing:
        break;
    }
    return BackupDialog::tr("undone, or nothing changed", "what was done after the backup");
}

QString tableOf(const KeptBackup& backup)
{
    if (backup.problem)
        return {};
    if (!backup.table)
        return BackupDialog::tr("none", "table");
    return QStringLiteral("%1: %2").arg(
        QString::fromStdString(backup.slot), gridText(backup.table->grid));
}

} // namespace

BackupDialog::BackupDialog(WizardController& controller, const DriveProfile& profile,
    std::filesystem::path storeRoot, FilePicker picker, QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_profile(std::make_shared<const DriveProfile>(profile))
    , m_storeRoot(std::move(storeRoot))
    , m_picker(std::move(picker))
    , m_drive(controller.status() ? controller.status()->drive : DriveIdentity{})
    , m_pictureJob([this](const TableChange& change) { drawPicture(change); })
    , m_introduction(new PlainLabel)
    , m_list(new QTreeWidget)
    , m_picture(new TableThumbnail)
    , m_warnings(new WarningList)
    , m_acceptOther(new QCheckBox)
    , m_file(new QPushButton)
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel))
{
    setObjectName(QStringLiteral("backupDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(m_list, &QTreeWidget::currentItemChanged, this, &BackupDialog::showCurrent);
    connect(m_acceptOther, &QCheckBox::toggled, this, &BackupDialog::updateButtons);
    connect(&m_controller, &WizardController::actionsChanged, this, &BackupDialog::updateButtons);
    connect(&m_controller, &WizardController::currentAxisChanged, this, &QDialog::reject);
    connect(m_file, &QPushButton::clicked, this, &BackupDialog::askForFile);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_buttons, &QDialogButtonBox::accepted, this, [this] {
        const KeptBackup* backup = current();
        if (!backup || !obstacle().isEmpty())
            return;
        const BackupChoice choice{backup->file, backup->axis, m_acceptOther->isChecked()};
        accept();
        Q_EMIT chosen(choice);
    });
    retranslate();
    read();
}

BackupDialog::~BackupDialog() = default;

void BackupDialog::build()
{
    m_introduction->setObjectName(QStringLiteral("backupIntroduction"));
    m_introduction->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("backups"));
    m_list->setRootIsDecorated(false);
    m_list->setAlternatingRowColors(true);
    m_list->setUniformRowHeights(true);
    m_list->setColumnCount(WriteColumn + 1);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(true);
    m_picture->setObjectName(QStringLiteral("backupPicture"));
    m_picture->setFixedWidth(32 * fontMetrics().averageCharWidth());
    m_warnings->setObjectName(QStringLiteral("backupWarnings"));
    m_acceptOther->setObjectName(QStringLiteral("acceptOtherDrive"));
    m_file->setObjectName(QStringLiteral("openBackupButton"));
    m_file->setAutoDefault(false);
    m_buttons->setObjectName(QStringLiteral("backupButtons"));
    m_buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("restoreBackupButton"));
    m_buttons->addButton(m_file, QDialogButtonBox::ActionRole);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(10);
    middle->addWidget(m_list, 1);
    middle->addWidget(m_picture);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_introduction);
    layout->addLayout(middle, 1);
    layout->addWidget(m_warnings);
    layout->addWidget(m_acceptOther);
    layout->addWidget(m_buttons);
    resize(900, 440);
}

void BackupDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void BackupDialog::retranslate()
{
    setWindowTitle(tr("Restore Backup"));
    m_introduction->setText(
        tr("Before each write this computer keeps what the axis had. Choose what %1 shall have "
           "again; the preview shows what that changes before anything is written.")
            .arg(QString::fromStdString(m_drive.name)));
    m_list->setHeaderLabels({tr("Date"), tr("Axis"), tr("Table"), tr("CRC"), tr("Before")});
    m_list->setAccessibleName(tr("Backups, the newest first"));
    m_acceptOther->setText(tr("Restore the backup of an&other drive to this one"));
    m_file->setText(tr("Open Backup &File…"));
    m_file->setToolTip(tr("Choose from a file that is kept elsewhere, such as one of a drive that "
                          "was replaced"));
    m_buttons->button(QDialogButtonBox::Ok)->setText(tr("&Restore…"));
    m_buttons->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    if (m_isRead)
        fill();
    updateButtons();
}

void BackupDialog::read()
{
    const auto read =
        inBackground<Backups>([root = m_storeRoot, drive = m_drive, profile = m_profile] {
            return backupsToChoose(DriveStore(root), drive, *profile);
        });
    whenDone(read, this, [this](const Backups& backups) { take(backups, false); });
}

void BackupDialog::askForFile()
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::OpenBackup;
    question.title = tr("Open Backup File");
    question.filter = tr("Backups (*.json)");
    question.start = QString::fromStdString(m_storeRoot.string());
    m_picker(*this, question, [this](const QString& path) {
        if (path.isEmpty())
            return;
        const auto read = inBackground<Backups>(
            [file = std::filesystem::path(path.toStdString()), profile = m_profile] {
                return backupsToChoose(file, *profile);
            });
        whenDone(read, this, [this](const Backups& backups) { take(backups, true); });
    });
}

/// Those of a file come first: they are what was asked for.
void BackupDialog::take(const Backups& backups, bool isFile)
{
    m_isRead = true;
    m_backups.insert(isFile ? m_backups.begin() : m_backups.end(), backups.begin(), backups.end());
    fill();
    if (m_list->topLevelItemCount() > 0 && (isFile || !m_list->currentItem()))
        m_list->setCurrentItem(m_list->topLevelItem(0));
    updateButtons();
}

void BackupDialog::fill()
{
    const int chosen = m_list->indexOfTopLevelItem(m_list->currentItem());
    m_list->clear();
    for (const KeptBackup& backup : m_backups)
        m_list->addTopLevelItem(itemFor(backup));
    m_list->setCurrentItem(m_list->topLevelItem(std::max(chosen, 0)));
    showCurrent();
}

QTreeWidgetItem* BackupDialog::itemFor(const KeptBackup& backup) const
{
    auto* item = new QTreeWidgetItem;
    item->setText(DateColumn,
        backup.time ? localTimeText(*backup.time)
                    : QString::fromStdString(backup.file.filename().string()));
    QString axis = nameOf(backup);
    if (isOther(backup))
        axis =
            tr("%1, drive %2", "axis and serial number").arg(axis).arg(backup.drive.serialNumber);
    item->setText(BackupAxisColumn, axis);
    item->setText(BackupTableColumn, tableOf(backup));
    if (backup.table)
        item->setText(CrcColumn, QStringLiteral("%1").arg(backup.tableCrc, 8, 16, QChar(u'0')));
    item->setText(WriteColumn, writeText(backup));
    for (int column = 0; column <= WriteColumn; ++column)
        item->setToolTip(column, QString::fromStdString(backup.file.string()));
    return item;
}

const KeptBackup* BackupDialog::current() const
{
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    return row < 0 ? nullptr : &m_backups.at(static_cast<std::size_t>(row));
}

bool BackupDialog::isOther(const KeptBackup& backup) const
{
    return !backup.problem && backup.drive.serialNumber != m_drive.serialNumber;
}

void BackupDialog::showCurrent()
{
    const KeptBackup* backup = current();
    m_acceptOther->setChecked(false);
    m_acceptOther->setVisible(backup && isOther(*backup));
    m_picture->setVisible(backup && backup->table);
    QStringList warnings;
    if (backup && backup->problem)
        warnings += tr("This backup is damaged: %1").arg(errorText(*backup->problem));
    if (backup && isOther(*backup))
        warnings += tr("This backup is of the drive with the serial number %1; this one is %2.")
                        .arg(backup->drive.serialNumber)
                        .arg(m_drive.serialNumber);
    m_warnings->setWarnings(warnings);
    if (backup && backup->table)
        showPicture(*backup);
    updateButtons();
}

void BackupDialog::showPicture(const KeptBackup& backup)
{
    m_picture->setPicture(nullptr, 1.0, {});
    m_picture->setTexts(tr("Table of the backup"), QString());
    m_pictureJob.start(
        [table = backup.table](const std::stop_token&) { return tableChange(table, nullptr); });
}

void BackupDialog::drawPicture(const TableChange& change)
{
    const KeptBackup* backup = current();
    if (!backup)
        return;
    const std::string unit = unitOf(*backup);
    m_picture->setPicture(change.after.drawn, change.scale(), unitSymbol(unit).toStdString());
    m_picture->setTexts(tr("Table of the backup"), pictureText(change.after, unit));
}

const AxisEntry* BackupDialog::entryOf(int axis) const
{
    const auto& axes = m_controller.axes();
    const auto found = std::ranges::find_if(axes, [&](const AxisEntry& entry) {
        return entry.axis.index == axis && m_controller.isCurrentDrive(entry);
    });
    return found == axes.end() ? nullptr : &*found;
}

/// As the backup has it; the axis of another drive has another one.
std::string BackupDialog::unitOf(const KeptBackup& backup) const
{
    const AxisEntry* entry = isOther(backup) ? nullptr : entryOf(backup.axis);
    return backup.unit.empty() && entry ? entry->axis.unit : backup.unit;
}

/// As the backup has it; it need not have one, and the axis of another drive has another name.
QString BackupDialog::nameOf(const KeptBackup& backup) const
{
    const AxisEntry* entry = isOther(backup) ? nullptr : entryOf(backup.axis);
    const std::string& name = backup.axisName.empty() && entry ? entry->axis.name : backup.axisName;
    return name.empty() ? QString::number(backup.axis) : QString::fromStdString(name);
}

QString BackupDialog::obstacle() const
{
    const KeptBackup* backup = current();
    if (!backup)
        return m_isRead ? tr("There is no backup of this drive on this computer.")
                        : tr("The backups are being read.");
    if (backup->problem)
        return tr("A damaged backup cannot be restored.");
    if (isOther(*backup) && !m_acceptOther->isChecked())
        return tr("Confirm first that the backup of another drive is meant.");
    const auto& status = m_controller.status();
    const ActionState state = m_controller.action(Action::RestoreBackup);
    if (status && status->axis.index == backup->axis && !state.isEnabled)
        return state.reason;
    return {};
}

void BackupDialog::updateButtons()
{
    const QString reason = obstacle();
    QPushButton* restore = m_buttons->button(QDialogButtonBox::Ok);
    restore->setEnabled(reason.isEmpty());
    restore->setToolTip(
        reason.isEmpty() ? tr("Show what restoring this backup would change") : reason);
    restore->setAccessibleDescription(restore->toolTip());
}

} // namespace axiscomp::ui
