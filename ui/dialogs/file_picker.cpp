// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/file_picker.h"

#include <QFileDialog>
#include <QFileInfo>

namespace axiscomp::ui {

namespace {

void ask(QWidget& parent, const FileQuestion& question, std::function<void(const QString&)> answer)
{
    auto* dialog = new QFileDialog(&parent, question.title, {}, question.filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("fileDialog"));
    if (question.purpose == FileQuestion::Purpose::OpenData
        || question.purpose == FileQuestion::Purpose::OpenMeasurement
        || question.purpose == FileQuestion::Purpose::OpenDeadPath
        || question.purpose == FileQuestion::Purpose::OpenActiveTable
        || question.purpose == FileQuestion::Purpose::OpenConfiguration
        || question.purpose == FileQuestion::Purpose::OpenBackup
        || question.purpose == FileQuestion::Purpose::OpenRecord
        || question.purpose == FileQuestion::Purpose::OpenPlan
        || question.purpose == FileQuestion::Purpose::OpenMachine) {
        dialog->setFileMode(QFileDialog::ExistingFile);
        dialog->setDirectory(question.start);
    } else if (question.purpose == FileQuestion::Purpose::SaveMachine) {
        dialog->setFileMode(QFileDialog::Directory);
        dialog->setOption(QFileDialog::ShowDirsOnly);
        dialog->setDirectory(question.start);
    } else {
        const QFileInfo proposed(question.start);
        dialog->setAcceptMode(QFileDialog::AcceptSave);
        dialog->setDefaultSuffix(proposed.suffix());
        // Values go on where their file ends. Of a record the page asks that itself, and says what
        // is there.
        dialog->setOption(QFileDialog::DontConfirmOverwrite,
            question.purpose == FileQuestion::Purpose::SaveValues
                || question.purpose == FileQuestion::Purpose::SaveRecord);
        dialog->setDirectory(proposed.absolutePath());
        dialog->selectFile(proposed.fileName());
    }
    QObject::connect(dialog, &QFileDialog::fileSelected, &parent, std::move(answer));
    dialog->open();
}

} // namespace

FilePicker systemFilePicker()
{
    return ask;
}

} // namespace axiscomp::ui
