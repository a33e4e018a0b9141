// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/record.h"

#include <QTabWidget>

class QStackedWidget;

namespace axiscomp::ui {

class ColumnPreview;
class FileFacts;
class FileLinesView;
class ProblemList;
struct ReadMeasurement;

/// What one file of a measurement says, the columns of a CSV file, and what is wrong with it: a tab
/// each. Others may stand beside them.
class FileViews : public QTabWidget {
    Q_OBJECT

public:
    /// prefix: as of MeasurementFiles.
    explicit FileViews(const QString& prefix = {}, QWidget* parent = nullptr);

    /// reading: null while it is being read.
    void show(const MeasurementFile& file, const ReadMeasurement* reading);
    void retranslate();

Q_SIGNALS:
    /// As ColumnPreview.
    void mappingChosen(const std::vector<axiscomp::ColumnMapping>& columns);

private:
    void showProblems(const ReadMeasurement* reading);

    FileFacts* m_facts;
    ColumnPreview* m_columns;
    QStackedWidget* m_problemStack;
    ProblemList* m_problems;
    FileLinesView* m_lines;
};

} // namespace axiscomp::ui
