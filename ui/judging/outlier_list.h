// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/run_selection.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

namespace axiscomp::ui {

class OutliersModel;
class RecordModel;

/// Values that do not fit the others, by a rule that the user chooses: a proposal, and what is
/// excluded already.
class OutlierList : public QWidget {
    Q_OBJECT

public:
    /// record must outlive the list.
    explicit OutlierList(RecordModel& record, QWidget* parent = nullptr);

    void retranslate();
    /// What the buttons are about; does not report it.
    void select(const std::optional<Exclusion>& values);
    void exclude(); ///< what is selected

Q_SIGNALS:
    /// By the user, in the list.
    void selectionChanged(const std::optional<axiscomp::Exclusion>& values);

private:
    void build();
    void follow();
    void useAgain();
    void excludeAll();

    RecordModel& m_record;
    OutliersModel* m_model;
    std::optional<Exclusion> m_selected;
    bool m_isSelecting = false; ///< not by the user
    QLabel* m_ruleLabel;
    QComboBox* m_rule;
    QTableView* m_table;
    QPushButton* m_excludeAll;
    QPushButton* m_exclude;
    QPushButton* m_useAgain;
};

} // namespace axiscomp::ui
