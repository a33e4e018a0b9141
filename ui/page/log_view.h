// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/wizard_controller.h"

#include <QAbstractTableModel>
#include <QWidget>

class QAbstractItemView;
class QLabel;
class QToolButton;
class QTreeView;

namespace axiscomp::ui {

/// The controller's log: time, what happened, details.
class LogModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Time, Text, Detail, ColumnCount };

    explicit LogModel(const WizardController& controller, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(
        int section, Qt::Orientation orientation, int role) const override;

    /// The lines as they are kept in a file: UTC time, kind, text, detail.
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString text(const QModelIndexList& rows) const;
    void retranslate();

private:
    void follow();

    const WizardController& m_controller;
    std::vector<LogLine> m_lines;
};

/// The log at the foot of the page; can be copied and saved.
class LogView : public QWidget {
    Q_OBJECT

public:
    explicit LogView(const WizardController& controller, QWidget* parent = nullptr);

    [[nodiscard]] QString text() const;
    void retranslate();

Q_SIGNALS:
    /// The page asks for a file name and saves text().
    void saveRequested();
    void closeRequested();

private:
    void build();
    void copy();

    LogModel* m_model;
    QTreeView* m_view;
    QLabel* m_title;
    QToolButton* m_copy;
    QToolButton* m_save;
    QToolButton* m_close;
};

} // namespace axiscomp::ui
