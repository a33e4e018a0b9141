// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <memory>

class QPushButton;

namespace axiscomp {
struct Measurement;
}

namespace axiscomp::ui {

class FileViews;
class MeasurementFiles;
class NextStep;
class RecordModel;
class RunValuesView;

/// The tab Measure: the files of a measurement, how each is read, what it says and what is wrong
/// with it.
class MeasurePage : public QWidget {
    Q_OBJECT

public:
    /// record must outlive the page.
    explicit MeasurePage(RecordModel& record, QWidget* parent = nullptr);

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
    void connectParts();
    void follow();
    void sayNextStep();

    RecordModel& m_record;
    MeasurementFiles* m_files;
    NextStep* m_nextStep;
    FileViews* m_views;
    RunValuesView* m_values;
    QPushButton* m_save;
    QString m_savedName; ///< of the file that has m_saved
    std::shared_ptr<const Measurement> m_saved; ///< null: nothing was saved
};

} // namespace axiscomp::ui
