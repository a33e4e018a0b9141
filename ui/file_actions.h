// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/file_picker.h"

#include <QObject>

namespace axiscomp::ui {

class DataField;
class WizardController;
class WizardSettings;

/// Everything of the page that asks for a file: opening data, saving an example, saving the log.
class FileActions : public QObject {
    Q_OBJECT

public:
    /// All references must outlive this; window is what dialogs belong to.
    FileActions(WizardController& controller, WizardSettings& settings, DataField& field,
        QWidget& window, QObject* parent = nullptr);

    void setPicker(FilePicker picker);
    void askAndOpen();
    void open(const QString& path);
    void saveExample(int dimensionality);
    void saveLog(const QString& text);

Q_SIGNALS:
    void failed(const QString& sentence);

private:
    void save(const QString& path, std::string text);

    WizardController& m_controller;
    WizardSettings& m_settings;
    DataField& m_field;
    QWidget& m_window;
    FilePicker m_picker;
};

} // namespace axiscomp::ui
