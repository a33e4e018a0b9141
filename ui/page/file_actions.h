// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/import_choices.h"
#include "core/table/table_layout.h"
#include "ui/dialogs/file_picker.h"

#include <QFuture>
#include <QObject>
#include <QPointer>

#include <memory>

namespace axiscomp {
struct CompensationTable;
}

namespace axiscomp::ui {

class DataFileField;
class ImportDialog;
class WizardController;
class WizardSettings;

/// Everything of the page that asks for a file: opening data and how it is to be understood,
/// exporting a table, saving an example, saving the log.
class FileActions : public QObject {
    Q_OBJECT

public:
    /// All references must outlive this; window is what dialogs belong to.
    FileActions(WizardController& controller, WizardSettings& settings, DataFileField& field,
        const TableLayout& layout, QWidget& window, QObject* parent = nullptr);

    void setPicker(FilePicker picker);
    void askAndOpen();
    void open(const QString& path);
    /// Asks how the file is to be understood.
    void askForImport(const QString& path);
    /// The selected table as a file of another controller.
    void exportTable();
    void saveExample(int dimensionality);
    void saveLog(const QString& text);

Q_SIGNALS:
    void failed(const QString& sentence);

private:
    void askWhereToExport(
        const std::shared_ptr<const CompensationTable>& table, const ImportChoices& choices);
    void saveExport(const QString& path, const std::shared_ptr<const CompensationTable>& table,
        const ImportChoices& choices);
    void save(const QString& path, std::string text);
    void report(const QFuture<Result<void>>& saved);

    WizardController& m_controller;
    WizardSettings& m_settings;
    DataFileField& m_field;
    const TableLayout& m_layout;
    QWidget& m_window;
    FilePicker m_picker;
    QPointer<ImportDialog> m_import;
};

} // namespace axiscomp::ui
