// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QPointer>

class QSettings;

namespace axiscomp::ui {
class CompensationWizard;
}

/// The window of a program that is about machines. Axis compensation is one of its assistants.
class MachineWindow : public QMainWindow {
    Q_OBJECT

public:
    /// settings must outlive the window.
    explicit MachineWindow(QSettings& settings);
    ~MachineWindow() override;

    /// Assistant > Axis Compensation Wizard: opens it, or brings it to the front.
    void showAxisCompensation();
    /// Null when it is not open.
    [[nodiscard]] axiscomp::ui::CompensationWizard* axisCompensation() const;

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    class AssistantWindow;

    QSettings& m_settings;
    QPointer<AssistantWindow> m_assistant;
};
