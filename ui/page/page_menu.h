// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/action_rules.h"

#include <QMenu>

#include <array>

class QAction;
class QActionGroup;

namespace axiscomp::ui {

/// What the page offers beside its daily work: the overview, several axes at once, TAM
/// configurations, language, the list before volatile writes, export, the log, help, about.
class PageMenu : public QMenu {
    Q_OBJECT

public:
    /// Those entries that a drive is needed for.
    static constexpr std::array drivenActions{Action::WriteSeveral, Action::ImportConfiguration,
        Action::ExportConfiguration, Action::BackUpDrive, Action::RestoreDrive};

    explicit PageMenu(QWidget* parent = nullptr);

    /// Empty: the system's.
    void showLanguage(const QString& language);
    void showPreviewSkipped(bool isSkipped);
    void setExportEnabled(bool isEnabled);
    /// A machine file is open, and can be read again.
    void showMachine(bool isOpen, bool mayPlan);
    /// What can be undone and done again, a phrase each; empty: nothing, or not now.
    void showHistory(const QString& undo, const QString& redo);
    /// One of drivenActions.
    void showAction(Action action, const ActionState& state);
    void retranslate();

Q_SIGNALS:
    void languageChosen(const QString& language);
    void previewSkippedChosen(bool isSkipped);
    void undoRequested();
    void redoRequested();
    void saveLogRequested();
    void guideRequested();
    void overviewRequested();
    void openMachineRequested();
    void planMachineRequested();
    void closeMachineRequested();
    void applyMachineRequested();
    void saveMachineRequested();
    void exportRequested();
    void actionRequested(axiscomp::ui::Action action); ///< one of drivenActions

private:
    [[nodiscard]] QAction* entryOf(Action action) const;
    void fillLanguages();
    void prepareDocumentation();
    void openDocumentation();
    void showAbout();

    QString m_undoText;
    QString m_redoText;
    QAction* m_undo;
    QAction* m_redo;
    QMenu* m_languages;
    QActionGroup* m_languageGroup;
    QAction* m_systemLanguage;
    QAction* m_overview;
    QMenu* m_machine;
    QAction* m_openMachine;
    QAction* m_planMachine;
    QAction* m_applyMachine;
    QAction* m_saveMachine;
    QAction* m_closeMachine;
    QAction* m_writeSeveral;
    QAction* m_importConfiguration;
    QAction* m_exportConfiguration;
    QAction* m_backUpDrive;
    QAction* m_restoreDrive;
    QAction* m_preview;
    QAction* m_export;
    QAction* m_saveLog;
    QMenu* m_help;
    QAction* m_guide;
    QAction* m_documentation;
    QAction* m_about;
};

} // namespace axiscomp::ui
