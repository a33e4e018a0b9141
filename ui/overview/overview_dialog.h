// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QAction;
class QDialogButtonBox;
class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace axiscomp::ui {

class AxisOverview;
class DriftDetails;
class MachineController;
class MachinePane;
class OverviewModel;
class WizardController;

/// All axes of all drives beside the page, read again and again while it is shown; one of them is
/// chosen to be gone to.
class OverviewDialog : public QDialog {
    Q_OBJECT

public:
    explicit OverviewDialog(WizardController& controller, QWidget* parent = nullptr);
    ~OverviewDialog() override;

Q_SIGNALS:
    /// Index into WizardController::axes().
    void axisChosen(int index);
    /// Of the machine file.
    void applyRequested();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    void connectParts();
    void retranslate();
    void selectCurrentAxis();
    void showChosen();
    void showDrift();
    [[nodiscard]] QSize room() const;
    void showMachineColumn();
    void goToAxis();
    void copy();
    /// Of the overview; -1: none.
    [[nodiscard]] int chosenRow() const;
    /// Index into the controller's axes; -1: it cannot be gone to.
    [[nodiscard]] int axisOf(int row) const;
    [[nodiscard]] QString obstacle() const;

    WizardController& m_controller;
    AxisOverview& m_overview;
    MachineController& m_machine;
    OverviewModel* m_model;
    QSortFilterProxyModel* m_sorted;
    QTableView* m_table;
    MachinePane* m_machinePane;
    DriftDetails* m_drift;
    QLabel* m_note;
    QAction* m_copy;
    QPushButton* m_copyButton;
    QPushButton* m_go;
    QDialogButtonBox* m_buttons;
};

} // namespace axiscomp::ui
