// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QStringList>
#include <QTableWidget>

namespace axiscomp::ui {

/// Rows to read, each as high as its lines; the columns share the width.
class RowList : public QTableWidget {
    Q_OBJECT

public:
    RowList(const char* name, int columns, QWidget* parent = nullptr);

    void addRow(const QStringList& texts);
    /// These and no others. What is the same stays as it is, and with it where somebody reads.
    void setRows(const QList<QStringList>& rows);

private:
    void setCell(int row, int column, const QString& text);
};

} // namespace axiscomp::ui
