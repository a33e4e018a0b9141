// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/wizard_controller.h"

#include <QWidget>

class QAction;
class QLabel;
class QMenu;
class QPushButton;

namespace axiscomp::ui {

/// The buttons of the page, each with its reason, and the line that says what comes next.
class ActionPanel : public QWidget {
    Q_OBJECT

public:
    explicit ActionPanel(WizardController& controller, QWidget* parent = nullptr);

    /// While the list before a write is shown it is confirmed there.
    void setPreviewing(bool isPreviewing);
    void retranslate();

Q_SIGNALS:
    void writeRequested();
    void restoreRequested();
    void backupsRequested();
    void deleteRequested();

private:
    void showActions();
    void apply(QPushButton& button, Action action, const QString& toolTip);
    void apply(QAction& menuEntry, Action action, const QString& toolTip);
    void connectActions();

    WizardController& m_controller;
    bool m_isPreviewing = false;
    QPushButton* m_write;
    QPushButton* m_revert;
    QPushButton* m_activate;
    QPushButton* m_activateMore;
    QPushButton* m_deactivate;
    QMenu* m_menu;
    QAction* m_evaluate;
    QAction* m_restore;
    QAction* m_backups;
    QAction* m_delete;
    QLabel* m_hintSymbol;
    QLabel* m_hint;
};

} // namespace axiscomp::ui
