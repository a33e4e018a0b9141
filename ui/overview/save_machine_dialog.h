// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/file_picker.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace axiscomp::ui {

class BusyMark;
class MachineSaving;
class ToneLabel;
class WarningList;
class WizardController;

/// Running drives as a machine file in a folder: which drives, the name of the machine, and whether
/// files that are there may be replaced.
class SaveMachineDialog : public QDialog {
    Q_OBJECT

public:
    /// folder: in which a person begins to look for one.
    SaveMachineDialog(
        WizardController& controller, FilePicker picker, QString folder, QWidget* parent = nullptr);
    ~SaveMachineDialog() override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void listDrives();
    void takeChoice();
    void refresh();
    void askForFolder();
    void save(const QString& folder);
    [[nodiscard]] QStringList chosen() const;
    [[nodiscard]] QString obstacle() const;

    WizardController& m_controller;
    MachineSaving& m_saving;
    FilePicker m_picker;
    QString m_startFolder;
    QLabel* m_introduction;
    QLabel* m_nameLabel;
    QLineEdit* m_name;
    QLabel* m_drivesLabel;
    QListWidget* m_drives;
    WarningList* m_warnings;
    BusyMark* m_busy;
    ToneLabel* m_reason;
    QPushButton* m_replace;
    QPushButton* m_save;
    QPushButton* m_close;
};

} // namespace axiscomp::ui
