// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QToolButton;

namespace axiscomp::ui {

class WizardController;

/// The first row of the page: which drives there are, how they are, where they are set up.
class DriveBar : public QWidget {
    Q_OBJECT

public:
    DriveBar(WizardController& controller, QMenu& menu, QWidget* parent = nullptr);

    void retranslate();

Q_SIGNALS:
    /// The user wants an axis of this drive.
    void driveChosen(const QString& endpoint);
    void connectionsRequested();

private:
    void showDrives();
    void showState();
    [[nodiscard]] QString currentEndpoint() const;

    WizardController& m_controller;
    QLabel* m_label;
    QComboBox* m_drives;
    QPushButton* m_connections;
    QPushButton* m_refresh;
    QLabel* m_symbol;
    QLabel* m_state;
    QToolButton* m_menuButton;
};

} // namespace axiscomp::ui
