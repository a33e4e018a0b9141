// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

class QAction;
class QActionGroup;

namespace axiscomp::ui {

/// What the page offers beside its daily work: several axes at once, language, the list before
/// volatile writes, export, the log, about.
class PageMenu : public QMenu {
    Q_OBJECT

public:
    explicit PageMenu(QWidget* parent = nullptr);

    /// Empty: the system's.
    void showLanguage(const QString& language);
    void showPreviewSkipped(bool isSkipped);
    void setExportEnabled(bool isEnabled);
    /// reason: why not, or what it does.
    void showWriteSeveral(bool isEnabled, const QString& reason);
    void retranslate();

Q_SIGNALS:
    void languageChosen(const QString& language);
    void previewSkippedChosen(bool isSkipped);
    void saveLogRequested();
    void exportRequested();
    void writeSeveralRequested();

private:
    void fillLanguages();
    void showAbout();

    QMenu* m_languages;
    QActionGroup* m_languageGroup;
    QAction* m_systemLanguage;
    QAction* m_writeSeveral;
    QAction* m_preview;
    QAction* m_export;
    QAction* m_saveLog;
    QAction* m_about;
};

} // namespace axiscomp::ui
