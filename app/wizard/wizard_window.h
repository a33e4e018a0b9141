// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/compensation_wizard.h"

class QSettings;

namespace axiscomp::app {

/// The window of the program: nothing but the wizard, its title and its place on the screen.
class WizardWindow : public QWidget {
    Q_OBJECT

public:
    /// settings must outlive the window.
    WizardWindow(const ui::WizardOptions& options, QSettings& settings);

    [[nodiscard]] ui::CompensationWizard& wizard();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void keepOnScreen();

    QSettings& m_settings;
    ui::CompensationWizard* m_wizard;
};

} // namespace axiscomp::app
