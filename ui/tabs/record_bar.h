// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QToolButton;

namespace axiscomp::ui {

class RecordFile;

/// Which record is open, whether it is saved, and what can be done with it.
class RecordBar : public QWidget {
    Q_OBJECT

public:
    /// file must outlive the bar.
    explicit RecordBar(const RecordFile& file, QWidget* parent = nullptr);

    void retranslate();

Q_SIGNALS:
    void openRequested();
    void saveRequested();
    void reportRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void follow();

    const RecordFile& m_file;
    QLabel* m_title;
    QLabel* m_name;
    QToolButton* m_open;
    QToolButton* m_save;
    QToolButton* m_report;
};

} // namespace axiscomp::ui
