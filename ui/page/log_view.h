// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/outcome/wizard_log.h"

#include <QWidget>

class QLabel;
class QToolButton;
class QTreeView;

namespace axiscomp::ui {

/// The log at the foot of the page; can be copied and saved.
class LogView : public QWidget {
    Q_OBJECT

public:
    /// log must outlive the view.
    explicit LogView(WizardLog& log, QWidget* parent = nullptr);

    [[nodiscard]] QString text() const;
    void retranslate();

Q_SIGNALS:
    /// The page asks for a file name and saves text().
    void saveRequested();
    void closeRequested();

private:
    void build();
    void copy();

    WizardLog& m_log;
    QTreeView* m_view;
    QLabel* m_title;
    QToolButton* m_copy;
    QToolButton* m_save;
    QToolButton* m_close;
};

} // namespace axiscomp::ui
