// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/record/comparison_model.h"
#include "ui/style/contrast.h"

#include <QWidget>

class QAbstractItemModel;
class QCheckBox;
class QPushButton;
class QTableView;

namespace axiscomp::ui {

class ComparisonFiguresModel;
class FileViews;
class MeasurementFiles;
class NextStep;
class RecordModel;
class ResidualModel;
class ResidualPlot;
class ToneLabel;

/// The tab Prove: a second measurement, with the table active, and what it says of what was
/// promised.
class ProvePage : public QWidget {
    Q_OBJECT

public:
    /// record: with the table in use; after: the second measurement. Both must outlive the page.
    ProvePage(RecordModel& record, RecordModel& after, QWidget* parent = nullptr);

    void retranslate();
    /// Whether the file of the record lacks something of it.
    void setUnsaved(bool isUnsaved);
    /// How things are here.
    enum class Standing { Empty, Ready, Warning };
    [[nodiscard]] Standing standing() const;

Q_SIGNALS:
    void addRequested(); ///< the user wants to choose files
    void standingChanged();

private:
    void build();
    [[nodiscard]] QWidget* buildLeft();
    [[nodiscard]] QWidget* buildComparison();
    [[nodiscard]] QTableView* table(const char* name, QAbstractItemModel* model) const;
    void connectParts();
    void follow();
    [[nodiscard]] bool isStated() const; ///< that the table that is compared was active
    void sayWarnings();
    void sayPromise();
    void sayNextStep();
    [[nodiscard]] std::pair<Tone, QString> nextStep() const;
    [[nodiscard]] std::pair<Tone, QString> missing() const;
    [[nodiscard]] std::pair<Tone, QString> result() const;

    RecordModel& m_record;
    RecordModel& m_after;
    ComparisonModel m_comparison;
    ComparisonFiguresModel* m_figuresModel;
    ResidualModel* m_residualModel;
    MeasurementFiles* m_files;
    QCheckBox* m_stated;
    QPushButton* m_keep;
    NextStep* m_nextStep;
    FileViews* m_views;
    QWidget* m_comparisonView;
    ToneLabel* m_warnings;
    NextStep* m_promise;
    ToneLabel* m_hints;
    QTableView* m_figures;
    ResidualPlot* m_plot;
    QTableView* m_residual;
    bool m_isUnsaved = true;
};

} // namespace axiscomp::ui
