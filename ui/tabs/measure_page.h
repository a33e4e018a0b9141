// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/formats/measurement_format.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QTableView;

namespace axiscomp::ui {

class CapturePanel;
class ColumnPreview;
class ColumnProposal;
class FileChoices;
class FileFacts;
class FileLinesView;
class MeasurementFilesModel;
class MeasuringActions;
class NextStep;
class ProblemList;
class RecordModel;
class RunValuesView;
class WizardSettings;
struct ReadMeasurement;

/// The tab Measure: the files of a measurement, how each is read, what it says and what is wrong
/// with it.
class MeasurePage : public QWidget {
    Q_OBJECT

public:
    /// record must outlive the page.
    explicit MeasurePage(RecordModel& record, QWidget* parent = nullptr);

    /// What plans measurements and takes their values, and what remembers the columns of files;
    /// both must outlive the page. Once, before it is shown.
    void setMeasuring(MeasuringActions& measuring, WizardSettings& settings);

    void retranslate();
    /// The measurement is in this file now.
    /// Says where it is, as long as it is what is shown.
    void showSaved(const QString& path, const std::shared_ptr<const Measurement>& measurement);

Q_SIGNALS:
    void addRequested(); ///< the user wants to choose files
    void saveRequested(); ///< the measurement as runs; there is one with targets

private:
    void build();
    [[nodiscard]] QWidget* buildLeft();
    [[nodiscard]] QWidget* buildMeasuring();
    [[nodiscard]] QWidget* buildColumns();
    void connectParts();
    void chooseColumns(const std::vector<ColumnMapping>& columns);
    void proposeColumns();
    void showMeasuring();
    void takeCaptured(const QString& path);
    void follow();
    void showFile();
    void showProblems(const ReadMeasurement* reading);
    void sayNextStep();
    void remove();
    [[nodiscard]] std::optional<std::size_t> currentFile() const;
    [[nodiscard]] const ReadMeasurement* currentReading() const;

    RecordModel& m_record;
    MeasuringActions* m_measuring = nullptr;
    WizardSettings* m_settings = nullptr;
    MeasurementFilesModel* m_model;
    QPushButton* m_program;
    QPushButton* m_capture;
    QLabel* m_title;
    QPushButton* m_add;
    QTableView* m_files;
    QPushButton* m_remove;
    QCheckBox* m_swap;
    FileChoices* m_choices;
    NextStep* m_nextStep;
    QTabWidget* m_views;
    FileFacts* m_facts;
    ColumnPreview* m_columns;
    ColumnProposal* m_proposal;
    CapturePanel* m_capturePanel = nullptr;
    RunValuesView* m_values;
    QPushButton* m_save;
    QStackedWidget* m_problemStack;
    ProblemList* m_problems;
    FileLinesView* m_lines;
    std::size_t m_fileCount = 0; ///< as last seen
    QString m_savedName; ///< of the file that has m_saved
    std::shared_ptr<const Measurement> m_saved; ///< null: nothing was saved
};

} // namespace axiscomp::ui
