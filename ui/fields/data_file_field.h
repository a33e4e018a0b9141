// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QLineEdit;
class QMenu;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace axiscomp::ui {

/// The name of the open file, or how far it is read, with the buttons to open and to cancel.
class DataFileField : public QWidget {
    Q_OBJECT

public:
    explicit DataFileField(QWidget* parent = nullptr);

    /// What the label of the field leads to.
    [[nodiscard]] QWidget& nameField();
    /// Empty: no file is open. isMade: path is what tables are called that are of no file.
    void showFile(const QString& path, bool isMade = false);
    void showReading(double fraction);
    void setOpenEnabled(bool isEnabled, const QString& reason);
    void setRecentFiles(const QStringList& paths);
    void retranslate();

Q_SIGNALS:
    void openRequested();
    void fileChosen(const QString& path);
    void readAgainRequested();
    void importOptionsRequested();
    void closeRequested();
    void cancelRequested();

private:
    void fillMenu();

    QStackedWidget* m_stack;
    QLineEdit* m_name;
    QProgressBar* m_progress;
    QPushButton* m_open;
    QPushButton* m_cancel;
    QToolButton* m_more;
    QMenu* m_menu;
    QString m_path;
    bool m_isMade = false;
    QStringList m_recent;
    QString m_reason;
};

} // namespace axiscomp::ui
