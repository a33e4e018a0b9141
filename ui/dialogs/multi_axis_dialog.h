// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/wizard_controller.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace axiscomp::ui {

class BusyMark;
class ColumnMappingTable;
class MultiAxisPlanView;

/// Columns of the open file for several axes of the current drive: what is for which, the plan of
/// all, and the writes one after the other. Nothing is written that was not planned with all
/// others.
class MultiAxisDialog : public QDialog {
    Q_OBJECT

public:
    /// The controller has an open file and an axis.
    explicit MultiAxisDialog(WizardController& controller, QWidget* parent = nullptr);
    ~MultiAxisDialog() override;

    /// While the drive is written: stops the writes; the dialog stays and says what has become of
    /// them.
    void reject() override;

protected:
    void changeEvent(QEvent* event) override;

private:
    enum class State { Choosing, Planning, Planned, Writing, Ended };

    void build();
    void follow();
    void retranslate();
    void fillSources();
    void plan();
    void planAgain();
    void takePlans();
    void write();
    void showBusy();
    void leaveLostDrive();
    void end();
    void enter(State state);
    void showButtons();
    void showReason();
    [[nodiscard]] std::vector<ColumnForAxis> chosen() const;
    [[nodiscard]] QString obstacle() const;
    [[nodiscard]] QString reason() const;

    WizardController& m_controller;
    std::vector<AxisEntry> m_axes;
    std::vector<ColumnForAxis> m_asked; ///< what the plan is of
    State m_state = State::Choosing;
    QLabel* m_introduction;
    ColumnMappingTable* m_columns;
    QLabel* m_sourcesLabel;
    QComboBox* m_sources;
    QLabel* m_persistency;
    QLabel* m_planTitle;
    MultiAxisPlanView* m_plan;
    BusyMark* m_busy;
    QLabel* m_reason;
    QProgressBar* m_progress;
    QPushButton* m_write;
    QPushButton* m_close;
};

} // namespace axiscomp::ui
