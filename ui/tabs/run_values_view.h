// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/run_selection.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QTableView;

namespace axiscomp::ui {

class RecordModel;
class RunValuesModel;

/// The values of all files of a record, for a person to leave some out and to use them again.
class RunValuesView : public QWidget {
    Q_OBJECT

public:
    /// So many cells at most are left out in one step; a whole run or target is one.
    static constexpr int mostSelected = 500;

    /// record must outlive the view.
    explicit RunValuesView(RecordModel& record, QWidget* parent = nullptr);

    void retranslate();

private:
    void build();
    void fitTargets();
    void follow();
    void exclude();
    void excludeRun();
    void useAgain();
    [[nodiscard]] bool isTooMuchSelected() const;
    /// What the selected cells stand for; nothing when they are too many.
    [[nodiscard]] std::vector<Exclusion> selected() const;

    RecordModel& m_record;
    RunValuesModel* m_model;
    QLabel* m_summary;
    QTableView* m_table;
    QPushButton* m_exclude;
    QPushButton* m_excludeRun;
    QPushButton* m_useAgain;
};

} // namespace axiscomp::ui
