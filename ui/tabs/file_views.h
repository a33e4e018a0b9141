// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/record.h"

#include <QTabWidget>

class QStackedWidget;

namespace axiscomp::ui {

class ColumnPreview;
class ColumnProposal;
class FileFacts;
class FileLinesView;
class ProblemList;
class WizardSettings;
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
    /// Keeps what the columns were said to be, and proposes it for files with the same names; must
    /// outlive the views.
    void remember(WizardSettings& settings);
    void retranslate();

Q_SIGNALS:
    /// As ColumnPreview.
    void mappingChosen(const std::vector<axiscomp::ColumnMapping>& columns);

private:
    [[nodiscard]] QWidget* buildColumns();
    void choose(const std::vector<ColumnMapping>& columns);
    void propose();
    void showProblems(const ReadMeasurement* reading);

    FileFacts* m_facts;
    ColumnProposal* m_proposal;
    ColumnPreview* m_columns;
    QWidget* m_columnsPage; ///< with both
    WizardSettings* m_settings = nullptr;
    MeasurementFile m_file; ///< that is shown
    QStackedWidget* m_problemStack;
    ProblemList* m_problems;
    FileLinesView* m_lines;
};

} // namespace axiscomp::ui
