// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/wizard_controller.h"
#include "ui/dialogs/file_picker.h"

#include <QWidget>

#include <memory>

class QSettings;

namespace axiscomp::ui {

/// The one-page wizard of AN140 figure 2 (docs/user-guide.md), as a widget that another Qt program
/// can put behind its own menu entry (docs/embedding).
class CompensationWizard : public QWidget {
    Q_OBJECT

public:
    /// settings remembers files, connections, language and the page's proportions; may be null,
    /// must outlive the wizard. When it is shown first and has been given no endpoints, it connects
    /// to those of the settings, or to the demo drive.
    CompensationWizard(WizardOptions options, QSettings* settings, QWidget* parent = nullptr);
    ~CompensationWizard() override;

    [[nodiscard]] WizardController& controller();
    /// Opens a file of compensation data, or what the name says that it is: a record, a machine
    /// file, a TAM configuration.
    void openData(const QString& path);
    /// A record, whatever the file is called.
    void openRecord(const QString& path);
    /// A file of any kind that the program has something to do with, by its name or its content: a
    /// record, a machine file, a TAM configuration, a table, a measurement. What is wrong with it
    /// is said on the page.
    void openFile(const QString& path);
    /// Asks when a write is running or changes are unwritten; false: stay open.
    [[nodiscard]] bool mayClose();
    /// Without questions; closeRequested follows at once. A running write is stopped and put back
    /// by the destructor, which takes as long as the drive needs for that, and one deadline when
    /// the drive hangs.
    void closeNow();
    /// Asks for files in place of the system's dialog.
    void setFilePicker(FilePicker picker);

Q_SIGNALS:
    /// For the title of the window around it: "[*]Axis Compensation Wizard - X · Triamec-616
    /// (demo)".
    void titleChanged(const QString& title, bool isModified);
    void closeRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dragLeaveEvent(QDragLeaveEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
