// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/restore_drive_dialog.h"

#include "core/io/local_file.h"
#include "ui/async/background_job.h"
#include "ui/style/tone_label.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QFileInfo>
#include <QLabel>

namespace axiscomp::ui {

namespace {

Result<std::shared_ptr<const DriveBackup>> loadBackup(
    const std::filesystem::path& file, const std::string& name)
{
    AXISCOMP_TRY(const auto bytes, loadFile(file, maximumBackupSize));
    AXISCOMP_TRY(auto backup, readBackup(asText(bytes), name));
    return std::make_shared<const DriveBackup>(std::move(backup));
}

} // namespace

RestoreDriveDialog::RestoreDriveDialog(WizardController& controller, QString path, QWidget* parent)
    : SeveralWritesDialog(controller, Action::RestoreDrive, parent)
    , m_path(std::move(path))
    , m_content(wrappedLabel("driveBackupContent"))
    , m_accept(new QCheckBox)
{
    setObjectName(QStringLiteral("restoreDriveDialog"));
    m_accept->setObjectName(QStringLiteral("acceptOtherDrive"));
    m_accept->hide();
    choices().addWidget(m_content);
    choices().addWidget(m_accept);
    connect(m_accept, &QCheckBox::toggled, this, &RestoreDriveDialog::plan);
    begin();
    whenDone(inBackground<Loaded>([file = QFileInfo(m_path).filesystemAbsoluteFilePath(),
                                      name = QFileInfo(m_path).fileName().toStdString()] {
        return loadBackup(file, name);
    }),
        this, [this](const Loaded& backup) { take(backup); });
}

void RestoreDriveDialog::take(const Loaded& backup)
{
    m_backup = backup;
    m_accept->setVisible(isOther());
    retranslateChoices();
    plan();
}

std::optional<DriveIdentity> RestoreDriveDialog::drive() const
{
    if (!m_backup || !*m_backup)
        return std::nullopt;
    const DriveBackup& backup = ***m_backup;
    return backup.axes.empty() ? backup.drive : backup.axes.front().drive;
}

bool RestoreDriveDialog::isOther() const
{
    const auto kept = drive();
    return kept && !axes().empty() && kept->serialNumber != axes().front().serialNumber;
}

QString RestoreDriveDialog::obstacle() const
{
    if (!m_backup)
        return tr("The backup is being read.");
    if (!*m_backup)
        return errorText(m_backup->error());
    if (isOther() && !m_accept->isChecked())
        return tr("The backup is of another drive: confirm it first.");
    return {};
}

bool RestoreDriveDialog::isObstacleAnError() const
{
    return m_backup && !*m_backup;
}

bool RestoreDriveDialog::ask()
{
    return controller().planRestoreDrive(**m_backup, m_accept->isChecked());
}

void RestoreDriveDialog::setChoosable(bool isChoosable)
{
    m_accept->setEnabled(isChoosable);
}

QString RestoreDriveDialog::contentText() const
{
    const auto kept = drive();
    if (!kept)
        return {};
    const DriveBackup& backup = ***m_backup;
    QString text = tr("Backup of %1, serial number %2; axes: %3")
                       .arg(QString::fromStdString(kept->name))
                       .arg(kept->serialNumber)
                       .arg(countText(backup.axes.size()));
    if (!backup.axes.empty())
        text += tr(", of %1", "time").arg(localTimeText(backup.axes.front().time));
    QStringList others;
    for (const AxisBackup::File& file : backup.otherFiles)
        others += QString::fromStdString(file.slot);
    if (!others.isEmpty())
        text += u'\n'
            + tr("Tables that no axis uses, restored after the axes: %1").arg(listText(others));
    return text;
}

void RestoreDriveDialog::retranslateChoices()
{
    setWindowTitle(tr("Restore Whole Drive"));
    introduction().setText(
        tr("Brings all axes of %1 back to the backup in %2, one after the other. All writes are "
           "checked before the first one begins; each one makes a backup and is verified. No "
           "compensation is switched on.")
            .arg(driveName(), QFileInfo(m_path).fileName()));
    m_content->setText(contentText());
    m_accept->setText(tr("The backup is of &another drive, which this one replaces"));
}

} // namespace axiscomp::ui
