// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QList>
#include <QStringList>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace axiscomp::ui {

class BusyMark;
class MachineController;
class RowList;
class ToneLabel;
class WarningList;
struct MachineDriveState;
class WizardController;

/// A machine file brought to its drives: what all writes together would change, the writes, and
/// what each axis holds in the end. Nothing is written while a part of it is impossible.
class ApplyMachineDialog : public QDialog {
    Q_OBJECT

public:
    /// A machine file is open; it is read again, and its drives are compared anew.
    explicit ApplyMachineDialog(WizardController& controller, QWidget* parent = nullptr);
    ~ApplyMachineDialog() override;

    /// While drives are written: stops the writes; the dialog stays and says what has become of
    /// them.
    void reject() override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void refresh();
    void fillPlans();
    void fillOutcomes();
    void showReason();
    void showButtons();
    void apply();
    void end();
    [[nodiscard]] QList<QStringList> plannedRows(const MachineDriveState& drive) const;
    [[nodiscard]] QStringList warnings() const;
    [[nodiscard]] QString costText() const;

    WizardController& m_controller;
    MachineController& m_machine;
    enum class State { Planning, Writing, Ended } m_state = State::Planning;
    QLabel* m_introduction;
    QCheckBox* m_activates;
    QCheckBox* m_allowsMissing;
    RowList* m_rows;
    WarningList* m_warnings;
    QLabel* m_remarks;
    BusyMark* m_busy;
    ToneLabel* m_reason;
    QProgressBar* m_progress;
    QPushButton* m_apply;
    QPushButton* m_close;
};

} // namespace axiscomp::ui
