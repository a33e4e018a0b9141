// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/file_picker.h"

#include <QDialog>
#include <QObject>
#include <QPointer>

#include <functional>

class QWidget;

namespace axiscomp::ui {

class WizardController;

/// What the menu Machine does: asks for files and opens the dialogs that the page needs for it.
class MachineActions : public QObject {
    Q_OBJECT

public:
    /// All references must outlive this; window is what dialogs belong to. picker, folder: of the
    /// moment.
    MachineActions(WizardController& controller, std::function<const FilePicker&()> picker,
        std::function<QString()> folder, QWidget& window);

    /// Asks for a machine file and opens it.
    void askAndOpen();
    void open(const QString& path);
    void planAgain();
    void close();
    /// Shows what applying the file would change; it is done from there. The list of all axes can
    /// ask for that again meanwhile: there is one such dialog.
    void apply();
    /// Running drives to a machine file.
    void save();

Q_SIGNALS:
    /// Where it is seen how the drives differ.
    void overviewRequested();

private:
    [[nodiscard]] QString startFolder() const;

    WizardController& m_controller;
    std::function<const FilePicker&()> m_picker;
    std::function<QString()> m_folder;
    QWidget& m_window;
    QPointer<QDialog> m_applying;
};

} // namespace axiscomp::ui
