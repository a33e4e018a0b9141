// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/run_selection.h"
#include "ui/page/page_tabs.h"

#include <QPointer>
#include <QWidget>

#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QSplitter;
class QTableView;
class QTabWidget;

namespace axiscomp::ui {

class CorrectionsDialog;
class DeviationPlot;
class DriftPlot;
class JudgementTableModel;
class LimitFields;
class NextStep;
class OutlierList;
class RecordModel;
class TargetFiguresModel;
class ToneLabel;

/// The tab Judge: what a measurement says of its axis. Plot, figures and tables at the right;
/// tolerances and what does not fit at the left. What is selected in one place is so in all.
class JudgePage : public QWidget {
    Q_OBJECT

public:
    /// record must outlive the page.
    explicit JudgePage(RecordModel& record, QWidget* parent = nullptr);

    void retranslate();
    [[nodiscard]] PageTabs::Mark mark() const;
    /// The file that the user has chosen for the corrections.
    void readDeadPath(const QString& path);

Q_SIGNALS:
    void deadPathRequested(); ///< the user wants to choose its file

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Table {
        JudgementTableModel* model;
        QTableView* view;
    };
    void build();
    [[nodiscard]] QWidget* buildLeft();
    [[nodiscard]] QWidget* buildRight();
    void connectParts();
    void addTable(const char* name, JudgementTableModel* model);
    void follow();
    void showPlots();
    void showHeading();
    void showCorrections();
    void askForCorrections();
    void select(const std::optional<Exclusion>& values);

    RecordModel& m_record;
    TargetFiguresModel* m_targets;
    std::vector<Table> m_tables; ///< in the order of their tabs
    std::optional<Exclusion> m_selected;
    bool m_isSelecting = false;
    bool m_arePlotsOld = true; ///< as long as nobody sees them
    LimitFields* m_limits;
    OutlierList* m_outliers;
    NextStep* m_nextStep;
    QLabel* m_limitsTitle;
    QLabel* m_correctionsText;
    QPushButton* m_corrections;
    QPointer<CorrectionsDialog> m_correctionsDialog;
    ToneLabel* m_heading;
    QCheckBox* m_showsAll;
    DeviationPlot* m_plot;
    DriftPlot* m_drift;
    QTabWidget* m_plots;
    QTabWidget* m_views;
};

} // namespace axiscomp::ui
