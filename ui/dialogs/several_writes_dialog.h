// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/wizard_controller.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace axiscomp::ui {

class BusyMark;
class MultiAxisPlanView;
class ToneLabel;

/// Writes to several axes of the current drive: what is chosen, the plan of all, and the writes one
/// after the other. Nothing is written that was not planned with all others.
class SeveralWritesDialog : public QDialog {
    Q_OBJECT

public:
    ~SeveralWritesDialog() override;

    /// While the drive is written: stops the writes; the dialog stays and says what has become of
    /// them.
    void reject() override;

protected:
    /// The controller has an axis. action: what has to be possible for it.
    SeveralWritesDialog(WizardController& controller, Action action, QWidget* parent);

    /// Texts and the first plan: at the end of the constructor.
    void begin();
    /// What is chosen has changed.
    void plan();
    /// Why what is chosen cannot be planned, a translated sentence; empty: it can.
    [[nodiscard]] virtual QString obstacle() const = 0;
    [[nodiscard]] virtual bool isObstacleAnError() const { return false; }
    /// What is chosen from is not there yet.
    [[nodiscard]] virtual bool isWaiting() const { return false; }
    /// Asks for the plan of what is chosen; false: it cannot be asked for now.
    [[nodiscard]] virtual bool ask() = 0;
    virtual void setChoosable(bool isChoosable) = 0;
    /// The title, the introduction, and everything that is chosen with.
    virtual void retranslateChoices() = 0;
    void changeEvent(QEvent* event) override;

    [[nodiscard]] WizardController& controller() const { return m_controller; }
    [[nodiscard]] const std::vector<AxisEntry>& axes() const { return m_axes; }
    [[nodiscard]] QString driveName() const;
    [[nodiscard]] QLabel& introduction() const { return *m_introduction; }
    /// Between the introduction and the plan.
    [[nodiscard]] QVBoxLayout& choices() const { return *m_choices; }

private:
    enum class State { Choosing, Planning, Planned, Writing, Ended };

    void build();
    void follow();
    void retranslate();
    void planAgain();
    void write();
    void showBusy();
    void leaveLostDrive();
    void end();
    void enter(State state);
    void showButtons();
    void showReason();
    [[nodiscard]] bool isError() const;
    [[nodiscard]] QString reason() const;

    WizardController& m_controller;
    const Action m_action;
    std::vector<AxisEntry> m_axes;
    State m_state = State::Choosing;
    QLabel* m_introduction;
    QVBoxLayout* m_choices;
    QLabel* m_planTitle;
    MultiAxisPlanView* m_plan;
    BusyMark* m_busy;
    ToneLabel* m_reason;
    QProgressBar* m_progress;
    QPushButton* m_write;
    QPushButton* m_close;
};

/// What the button does that leaves a dialog of writes.
enum class Leaving { Cancels, StopsWrites, Closes };
/// Text and tool tip. stopping: the tool tip while it stops the writes.
void sayLeaving(QPushButton& button, Leaving leaving, const QString& stopping);

/// A label of several lines; name: of the object.
[[nodiscard]] ToneLabel* wrappedLabel(const char* name);

} // namespace axiscomp::ui
