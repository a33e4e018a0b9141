// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QMenu;
class QSplitter;
class QStackedWidget;
class QStyle;

namespace axiscomp {
struct DriveProfile;
}

namespace axiscomp::ui {

class ActionPanel;
class DriveBar;
class LogView;
class MessageStack;
class PageTabs;
class PreviewPanel;
class SetupPanel;
class StatusStrip;
class WizardController;
class WizardSettings;

/// The parts of the page and where they are.
class WizardPage : public QWidget {
    Q_OBJECT

public:
    /// measure, judge, fit, prove: what the tabs of these names show; record: stands beside the
    /// tabs. The page takes them. All references must outlive the page.
    WizardPage(WizardController& controller, const DriveProfile& profile, QStyle& style,
        QMenu& menu, QWidget* measure, QWidget* judge, QWidget* fit, QWidget* prove,
        QWidget* record, QWidget* parent = nullptr);

    void retranslate();
    void showLog(bool isShown);
    [[nodiscard]] bool isLogShown() const;
    void restoreSplitters(const WizardSettings& settings);
    void saveSplitters(WizardSettings& settings) const;

    // The parts; they live as long as the page.
    DriveBar* const driveBar;
    MessageStack* const messages;
    PageTabs* const tabs;
    SetupPanel* const setup;
    ActionPanel* const actions;
    PreviewPanel* const preview;
    LogView* const log;
    StatusStrip* const status;

private:
    [[nodiscard]] QWidget* buildMessages();
    [[nodiscard]] QWidget* buildLeft();
    void buildWritePage();
    void showMarkOfWrite();

    WizardController& m_controller;
    QStackedWidget* m_pages; ///< one for each tab
    QSplitter* m_columns;
    QSplitter* m_rows;
};

} // namespace axiscomp::ui
