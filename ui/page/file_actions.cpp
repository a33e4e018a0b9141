// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/file_actions.h"

#include "core/configuration/tam_configuration.h"
#include "core/conversion/table_export.h"
#include "core/csv/calibration_csv.h"
#include "core/formats/formats.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/io/local_file.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/table/large_correction.h"
#include "ui/async/background_job.h"
#include "ui/controller/wizard_controller.h"
#include "ui/controller/wizard_settings.h"
#include "ui/dialogs/export_configuration_dialog.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/file_filters.h"
#include "ui/dialogs/import_configuration_dialog.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/fields/data_file_field.h"
#include "ui/history/restore_drive_dialog.h"
#include "ui/record/fit_outcome.h"
#include "ui/record/record_state.h"
#include "ui/text/message_text.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QWidget>

#include <algorithm>

namespace axiscomp::ui {

namespace {

Bytes bytesOf(const std::string& text)
{
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    return {begin, begin + text.size()};
}

TableFacts factsOf(const FitOutcome& outcome)
{
    return {notesOf(outcome), outcome.isComputed};
}

/// Of the format that the choices name.
Result<std::string> fittedFile(const FitOutcome& outcome, std::size_t table,
    const ImportChoices& choices, const std::string& fileName, const TableLayout& layout)
{
    if (choices.format == &calibration_csv::format() && !choices.isConversion() && !choices.sign)
        return writeCalibrationCsv(*madeTables(outcome, table).data);
    const CompensationTable& chosen = *outcome.tables[table].table;
    if (choices.format == &tam_table::format())
        for (const Text& large : largeCorrections(chosen))
            return fail(ErrorCode::LargeCorrection, {{"reason", large}});
    AXISCOMP_TRY(
        auto exported, axiscomp::exportTable(chosen, choices, fileName, layout, factsOf(outcome)));
    return std::move(exported.bytes);
}

} // namespace

FileActions::FileActions(WizardController& controller, WizardSettings& settings,
    DataFileField& field, const DriveProfile& profile, QWidget& window, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_field(field)
    , m_profile(profile)
    , m_window(window)
    , m_picker(systemFilePicker())
{
    field.setRecentFiles(settings.recentFiles());
    connect(&field, &DataFileField::openRequested, this, &FileActions::askAndOpen);
    connect(&field, &DataFileField::fileChosen, this, &FileActions::open);
    connect(
        &field, &DataFileField::readAgainRequested, this, [this] { m_controller.readDataAgain(); });
    connect(&field, &DataFileField::importOptionsRequested, this,
        [this] { askForImport(m_controller.dataFile().path); });
    connect(&controller, &WizardController::importChoiceNeeded, this, &FileActions::askForImport);
    connect(&field, &DataFileField::closeRequested, &controller, &WizardController::closeData);
    connect(&field, &DataFileField::cancelRequested, &controller, &WizardController::cancelReading);
}

void FileActions::setPicker(FilePicker picker)
{
    m_picker = std::move(picker);
}

void FileActions::askAndOpen()
{
    if (!m_controller.action(Action::OpenData).isEnabled)
        return;
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::OpenData;
    question.title = tr("Open Compensation Data");
    question.filter = openFilter();
    question.start = m_settings.folder();
    m_picker(m_window, question, [this](const QString& path) {
        if (!path.isEmpty())
            Q_EMIT dataChosen(path);
    });
}

void FileActions::askForMeasurements()
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::OpenMeasurement;
    question.title = tr("Add Measurement");
    question.filter = measurementFilter();
    question.start = m_measurementFolder.isEmpty() ? m_settings.folder() : m_measurementFolder;
    m_picker(m_window, question, [this](const QString& path) {
        if (path.isEmpty())
            return;
        m_measurementFolder = QFileInfo(path).absolutePath();
        Q_EMIT measurementsChosen({path});
    });
}

void FileActions::askForDeadPath()
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::OpenDeadPath;
    question.title = tr("Dead Path");
    question.filter = tr("Dead path (*.json)");
    question.start = m_measurementFolder.isEmpty() ? m_settings.folder() : m_measurementFolder;
    m_picker(m_window, question, [this](const QString& path) {
        if (!path.isEmpty())
            Q_EMIT deadPathChosen(path);
    });
}

void FileActions::askForActiveTable(bool isOnto)
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::OpenActiveTable;
    question.title = tr("Table That Was Active");
    question.filter = openFilter();
    question.start = m_settings.folder();
    m_picker(m_window, question, [this, isOnto](const QString& path) {
        if (!path.isEmpty())
            Q_EMIT activeTableChosen(QFileInfo(path).absoluteFilePath(), isOnto);
    });
}

void FileActions::saveFitted(const std::shared_ptr<const FitOutcome>& outcome, std::size_t table)
{
    const auto& chosen = outcome->tables[table].table;
    ExportDialog::Options options{chosen, QString::fromStdString(chosen->name), m_profile.layout,
        {m_controller.chosenPlace().target, outcome->report->lookupAt}, true, factsOf(*outcome)};
    auto* dialog = new ExportDialog(std::move(options), &m_window);
    connect(dialog, &ExportDialog::chosen, this,
        [this, outcome, table](const auto&, const ImportChoices& choices) {
            askWhereToSaveFitted(outcome, table, choices);
        });
    dialog->open();
}

/// As `axiscomp fit -o` does it: the calibration file has all columns and says what they are made
/// of, and what is unusually large becomes no table of the drive unseen.
void FileActions::askWhereToSaveFitted(const std::shared_ptr<const FitOutcome>& outcome,
    std::size_t table, const ImportChoices& choices)
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::SaveTable;
    question.title = tr("Save Table");
    question.filter = saveFilter(*choices.format);
    const QString name = QFileInfo(outcome->request.files.front().file.path).completeBaseName()
        + QStringLiteral("-table") + extensionOf(*choices.format);
    question.start = QDir(m_settings.folder()).filePath(name);
    m_picker(m_window, question, [this, outcome, table, choices](const QString& path) {
        if (path.isEmpty())
            return;
        report(inBackground<Result<void>>(
            [path, outcome, table, choices, layout = m_profile.layout]() -> Result<void> {
                const QFileInfo file(path);
                AXISCOMP_TRY(const std::string bytes,
                    fittedFile(*outcome, table, choices, file.fileName().toStdString(), layout));
                return saveFile(file.filesystemAbsoluteFilePath(), bytesOf(bytes));
            }));
    });
}

/// What goes into a file of runs.
struct FileActions::RunsToSave {
    Record record;
    std::vector<ReadMeasurement> files;
    std::shared_ptr<const Measurement> measurement; ///< as it is shown
};

void FileActions::saveMeasurement(const RecordState& state)
{
    const RunsToSave runs{state.record, state.files, state.measurement};
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::SaveMeasurement;
    question.title = tr("Save as Runs");
    question.filter = tr("Runs (*.csv)");
    const QString name = QFileInfo(runs.files.front().file.path).completeBaseName();
    const QString folder =
        m_measurementFolder.isEmpty() ? m_settings.folder() : m_measurementFolder;
    question.start = QDir(folder).filePath(name + QStringLiteral("-runs.csv"));
    m_picker(m_window, question, [this, runs](const QString& path) {
        if (!path.isEmpty())
            writeMeasurement(path, runs);
    });
}

void FileActions::writeMeasurement(const QString& path, const RunsToSave& runs)
{
    const auto saved = inBackground<Result<void>>([path, runs]() -> Result<void> {
        const QFileInfo file(path);
        const bool isSource = std::ranges::any_of(runs.record.files,
            [&](const MeasurementFile& source) { return QFileInfo(source.path) == file; });
        if (isSource)
            return fail(ErrorCode::FileNotWritable,
                {{"file", file.fileName().toStdString()},
                    {"reason",
                        AXISCOMP_TEXT("Error",
                            "it is one of the files of this measurement; choose another name")}});
        AXISCOMP_TRY(const auto measurement, uncorrected(runs.record, runs.files));
        return saveFile(file.filesystemAbsoluteFilePath(), bytesOf(writeRunsCsv(measurement)));
    });
    whenDone(saved, this, [this, path, measurement = runs.measurement](const Result<void>& result) {
        if (result)
            Q_EMIT measurementSaved(path, measurement);
        else
            Q_EMIT failed(errorText(result.error()));
    });
}

void FileActions::open(const QString& path)
{
    if (path.isEmpty())
        return;
    m_controller.openData(path);
    m_settings.addRecentFile(path);
    m_field.setRecentFiles(m_settings.recentFiles());
}

void FileActions::askForImport(const QString& path)
{
    if (path.isEmpty() || !m_controller.action(Action::OpenData).isEnabled)
        return;
    if (m_import)
        m_import->reject();
    ImportChoices choices = m_controller.importChoices(path);
    if (!choices.format && m_controller.dataFile().path == path && m_controller.dataFile().data)
        choices.format = m_controller.dataFile().format;
    choices.place = m_controller.chosenPlace();
    m_import = new ImportDialog(
        {path, m_controller.setup().edited().dimensionality, std::move(choices), m_profile.layout},
        &m_window);
    connect(m_import, &ImportDialog::chosen, &m_controller, &WizardController::importData);
    m_import->open();
}

void FileActions::exportTable()
{
    const auto table = m_controller.selectedTable();
    if (!table)
        return;
    const TableFacts facts{m_controller.selectedNotes(), m_controller.isSelectedComputed()};
    auto* dialog = new ExportDialog({table, QString::fromStdString(table->name), m_profile.layout,
                                        m_controller.selectedPlace(), false, facts},
        &m_window);
    connect(dialog, &ExportDialog::chosen, this,
        [this, facts](const auto& chosen, const ImportChoices& choices) {
            askWhereToExport(chosen, facts, choices);
        });
    dialog->open();
}

void FileActions::askWhereToExport(const std::shared_ptr<const CompensationTable>& table,
    const TableFacts& facts, const ImportChoices& choices)
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::ExportTable;
    question.title = tr("Export for Another Controller");
    question.filter = saveFilter(*choices.format);
    QString name = QString::fromStdString(table->name);
    static const QRegularExpression notForNames(QStringLiteral("[^\\w.-]+"));
    name.replace(notForNames, QStringLiteral("-"));
    question.start = QDir(m_settings.folder())
                         .filePath((name.isEmpty() ? QStringLiteral("table") : name)
                             + extensionOf(*choices.format));
    m_picker(m_window, question, [this, table, facts, choices](const QString& path) {
        saveExport(path, table, facts, choices);
    });
}

void FileActions::saveExport(const QString& path,
    const std::shared_ptr<const CompensationTable>& table, const TableFacts& facts,
    const ImportChoices& choices)
{
    if (path.isEmpty())
        return;
    report(inBackground<Result<void>>(
        [path, table, facts, choices, layout = m_profile.layout]() -> Result<void> {
            const std::string name = QFileInfo(path).fileName().toStdString();
            AXISCOMP_TRY(
                const auto exported, axiscomp::exportTable(*table, choices, name, layout, facts));
            return saveFile(QFileInfo(path).filesystemAbsoluteFilePath(), bytesOf(exported.bytes));
        }));
}

void FileActions::importConfiguration()
{
    askForConfiguration(
        Action::ImportConfiguration, [this](const QString& path) { importConfigurationOf(path); });
}

void FileActions::importConfigurationOf(const QString& path)
{
    (new ImportConfigurationDialog(m_controller, path, &m_window))->open();
}

void FileActions::exportConfiguration()
{
    askForConfiguration(Action::ExportConfiguration, [this](const QString& path) {
        auto* dialog = new ExportConfigurationDialog(m_controller, m_profile, path, &m_window);
        connect(dialog, &ExportConfigurationDialog::chosen, this,
            [this, path](const auto& from, const auto& text) { askWhereToSave(path, from, text); });
        dialog->open();
    });
}

void FileActions::askForConfiguration(
    Action action, const std::function<void(const QString& path)>& open)
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::OpenConfiguration;
    question.title = action == Action::ImportConfiguration ? tr("Import TAM Configuration")
                                                           : tr("Export to TAM Configuration");
    question.filter = tr("TAM configurations (*.TAMcfg)");
    question.start = m_settings.folder();
    m_picker(m_window, question, [this, action, open](const QString& path) {
        const ActionState state = m_controller.action(action);
        if (path.isEmpty())
            return;
        if (state.isEnabled)
            open(path);
        else
            Q_EMIT failed(state.reason);
    });
}

void FileActions::askWhereToSave(const QString& proposed,
    const std::shared_ptr<const TamConfiguration>& from, const std::string& text)
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::SaveConfiguration;
    question.title = tr("Save TAM Configuration");
    question.filter = tr("TAM configurations (*.TAMcfg)");
    question.start = proposed;
    m_picker(m_window, question, [this, proposed, from, text](const QString& path) {
        if (!path.isEmpty())
            saveConfiguration(path, proposed, from, text);
    });
}

/// What another program has put into the file since it was read is not lost.
void FileActions::saveConfiguration(const QString& path, const QString& original,
    const std::shared_ptr<const TamConfiguration>& from, const std::string& text)
{
    const auto place = QFileInfo(path).filesystemAbsoluteFilePath();
    const bool isSameFile = QFileInfo(path) == QFileInfo(original);
    const auto saved =
        inBackground<Result<void>>([place, isSameFile, from, text]() -> Result<void> {
            if (isSameFile) {
                AXISCOMP_TRY(const auto now, loadFile(place, maximumConfigurationSize));
                if (now != from->bytes)
                    return fail(ErrorCode::FileNotWritable,
                        {{"file", from->fileName},
                            {"reason",
                                AXISCOMP_TEXT(
                                    "Error", "it has changed since it was read; export again")}});
            }
            return saveFile(place, asBytes(text));
        });
    whenDone(saved, this, [this, name = QFileInfo(path).fileName()](const Result<void>& result) {
        m_controller.reportExport(name, result);
    });
}

void FileActions::backUpDrive()
{
    const auto& status = m_controller.status();
    if (!status)
        return;
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::SaveBackup;
    question.title = tr("Back Up Whole Drive");
    question.filter = tr("Backups (*.json)");
    QString name = QString::fromStdString(status->drive.name);
    static const QRegularExpression notForNames(QStringLiteral("[^\\w.-]+"));
    name.replace(notForNames, QStringLiteral("-"));
    question.start =
        QDir(m_settings.folder())
            .filePath(
                QStringLiteral("%1-%2-%3.json")
                    .arg(name)
                    .arg(status->drive.serialNumber)
                    .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"))));
    m_picker(m_window, question, [this](const QString& path) {
        if (!path.isEmpty())
            m_controller.backUpDrive(path);
    });
}

void FileActions::restoreDrive()
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::OpenBackup;
    question.title = tr("Restore Whole Drive");
    question.filter = tr("Backups (*.json)");
    question.start = m_settings.folder();
    m_picker(m_window, question, [this](const QString& path) {
        const ActionState state = m_controller.action(Action::RestoreDrive);
        if (path.isEmpty())
            return;
        if (state.isEnabled)
            (new RestoreDriveDialog(m_controller, path, &m_window))->open();
        else
            Q_EMIT failed(state.reason);
    });
}

void FileActions::saveExample(int dimensionality)
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::SaveExample;
    question.title = tr("Save Example File");
    question.filter = tr("Calibration files (*.csv)");
    question.start =
        QDir(m_settings.folder()).filePath(QStringLiteral("example-%1d.csv").arg(dimensionality));
    m_picker(m_window, question, [this, dimensionality](const QString& path) {
        save(path, exampleCalibrationCsv(dimensionality));
    });
}

void FileActions::saveLog(const QString& text)
{
    FileQuestion question;
    question.purpose = FileQuestion::Purpose::SaveLog;
    question.title = tr("Save Log");
    question.filter = tr("Text files (*.txt)");
    const QString time = QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
    question.start =
        QDir(m_settings.folder()).filePath(QStringLiteral("axis-compensation-%1.txt").arg(time));
    m_picker(m_window, question,
        [this, text = text.toStdString()](const QString& path) { save(path, text); });
}

void FileActions::save(const QString& path, std::string text)
{
    if (path.isEmpty())
        return;
    const std::filesystem::path file = path.toStdString();
    report(inBackground<Result<void>>(
        [file, text = std::move(text)] { return saveFile(file, bytesOf(text)); }));
}

void FileActions::report(const QFuture<Result<void>>& saved)
{
    whenDone(saved, this, [this](const Result<void>& result) {
        if (!result)
            Q_EMIT failed(errorText(result.error()));
    });
}

} // namespace axiscomp::ui
