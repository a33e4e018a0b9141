// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace axiscomp::ui {

class StateField;
class WizardController;

/// The last row of the page: what runs and how far it is on the left, what the drive does now on
/// the right.
class StatusStrip : public QWidget {
    Q_OBJECT

public:
    explicit StatusStrip(WizardController& controller, QWidget* parent = nullptr);

    void retranslate();
    void setLogShown(bool isShown);

Q_SIGNALS:
    void logToggled(bool isShown);

private:
    void showBusy();

    WizardController& m_controller;
    QLabel* m_step;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    StateField* m_state;
    QToolButton* m_log;
};

} // namespace axiscomp::ui
