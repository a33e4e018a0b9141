// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/table_export.h"
#include "core/drive/drive_profile.h"
#include "ui/controller/action_rules.h"
#include "ui/dialogs/file_picker.h"

#include <QFuture>
#include <QObject>
#include <QPointer>

#include <memory>
#include <string>

namespace axiscomp {
struct CompensationTable;
struct Measurement;
struct TamConfiguration;
} // namespace axiscomp

namespace axiscomp::ui {

class DataFileField;
class ImportDialog;
class WizardController;
class WizardSettings;
struct FitOutcome;
struct RecordState;

/// Everything of the page that asks for a file: opening data and how it is to be understood,
/// exporting a table, parameters from and for a TAM configuration, saving an example, saving the
/// log.
class FileActions : public QObject {
    Q_OBJECT

public:
    /// All references must outlive this; window is what dialogs belong to.
    FileActions(WizardController& controller, WizardSettings& settings, DataFileField& field,
        const DriveProfile& profile, QWidget& window, QObject* parent = nullptr);

    void setPicker(FilePicker picker);
    [[nodiscard]] const FilePicker& picker() const { return m_picker; }
    /// A file of compensation data; dataChosen() follows.
    void askAndOpen();
    void open(const QString& path);
    /// A file of a measurement; measurementsChosen() follows.
    void askForMeasurements();
    /// The file with the dead path of an interferometer; deadPathChosen() follows.
    void askForDeadPath();
    /// Asks for a file, which gets a measurement with targets as runs; measurementSaved() follows.
    /// Its values are those of the files: a file does not say that it is corrected for the dead
    /// path, and would be once more. The files themselves are not written over.
    void saveMeasurement(const RecordState& state);
    /// The file of a table that was active during a measurement; activeTableChosen() follows.
    void askForActiveTable(bool isOnto);
    /// A fitted table as a file of any format.
    void saveFitted(const std::shared_ptr<const FitOutcome>& outcome, std::size_t table);
    /// Asks how the file is to be understood.
    void askForImport(const QString& path);
    /// The selected table as a file of another controller.
    void exportTable();
    /// The parameters of a TAM configuration to the current drive, which there must be.
    void importConfiguration();
    /// Of a file that is known; the action must be possible.
    void importConfigurationOf(const QString& path);
    /// Those of the current drive to a TAM configuration.
    void exportConfiguration();
    /// All axes of the current drive, which there must be, to a file.
    void backUpDrive();
    /// Such a file to the current drive.
    void restoreDrive();
    void saveExample(int dimensionality);
    void saveLog(const QString& text);

Q_SIGNALS:
    void failed(const QString& sentence);
    void dataChosen(const QString& path);
    void measurementsChosen(const QStringList& paths);
    void deadPathChosen(const QString& path);
    void activeTableChosen(const QString& path, bool isOnto);
    /// measurement: that of the state that was saved
    void measurementSaved(
        const QString& path, const std::shared_ptr<const Measurement>& measurement);

private:
    void askWhereToExport(const std::shared_ptr<const CompensationTable>& table,
        const TableFacts& facts, const ImportChoices& choices);
    void saveExport(const QString& path, const std::shared_ptr<const CompensationTable>& table,
        const TableFacts& facts, const ImportChoices& choices);
    /// open: gets what is picked, when the action is still possible then.
    void askForConfiguration(Action action, const std::function<void(const QString& path)>& open);
    void askWhereToSave(const QString& proposed,
        const std::shared_ptr<const TamConfiguration>& from, const std::string& text);
    void saveConfiguration(const QString& path, const QString& original,
        const std::shared_ptr<const TamConfiguration>& from, const std::string& text);
    void askWhereToSaveFitted(const std::shared_ptr<const FitOutcome>& outcome, std::size_t table,
        const ImportChoices& choices);
    struct RunsToSave;
    void writeMeasurement(const QString& path, const RunsToSave& runs);
    void save(const QString& path, std::string text);
    void report(const QFuture<Result<void>>& saved);

    WizardController& m_controller;
    WizardSettings& m_settings;
    DataFileField& m_field;
    const DriveProfile& m_profile;
    QWidget& m_window;
    FilePicker m_picker;
    QString m_measurementFolder; ///< of the last one; empty: none was opened yet
    QPointer<ImportDialog> m_import;
};

} // namespace axiscomp::ui
