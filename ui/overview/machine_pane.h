// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPushButton;
class QTreeView;

namespace axiscomp::ui {

class BusyMark;
class MachineController;
class ProblemModel;
class ToneLabel;
class WarningList;

/// The machine file over the overview: how many axes are as it says and since when that is known,
/// what is wrong with the file, and what can be done with it. Hidden without one.
class MachinePane : public QWidget {
    Q_OBJECT

public:
    /// machine must outlive the pane.
    explicit MachinePane(MachineController& machine, QWidget* parent = nullptr);

    void retranslate();

Q_SIGNALS:
    void applyRequested();

private:
    void build();
    void refresh();
    void showProblems();
    [[nodiscard]] QString summary() const;
    [[nodiscard]] QStringList warnings() const;

    MachineController& m_machine;
    ToneLabel* m_summary;
    BusyMark* m_busy;
    QPushButton* m_planAgain;
    QPushButton* m_apply;
    QPushButton* m_close;
    WarningList* m_warnings;
    ProblemModel* m_problemModel;
    QTreeView* m_problems;
};

} // namespace axiscomp::ui
