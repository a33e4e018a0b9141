// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <memory>

class QPushButton;

namespace axiscomp {
struct Measurement;
}

namespace axiscomp::ui {

class CapturePanel;
class FileViews;
class MeasurementFiles;
class MeasuringActions;
class NextStep;
class RecordModel;
class RunValuesView;
class WizardSettings;

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
    void showMeasuring();
    void takeCaptured(const QString& path);
    void connectParts();
    void follow();
    void sayNextStep();

    RecordModel& m_record;
    MeasuringActions* m_measuring = nullptr;
    QPushButton* m_program;
    QPushButton* m_capture;
    MeasurementFiles* m_files;
    NextStep* m_nextStep;
    FileViews* m_views;
    CapturePanel* m_capturePanel = nullptr;
    QWidget* m_captureView = nullptr; ///< with the panel
    bool m_isCapturingForRecord = false; ///< not for one that was opened since the capture began
    QString m_capturedForAnother; ///< the file of such a capture; empty: none
    RunValuesView* m_values;
    QPushButton* m_save;
    QString m_savedName; ///< of the file that has m_saved
    std::shared_ptr<const Measurement> m_saved; ///< null: nothing was saved
};

} // namespace axiscomp::ui
