// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTableWidget>

namespace axiscomp::ui {

/// Rows to read, each as high as its lines; the columns share the width.
class RowList : public QTableWidget {
    Q_OBJECT

public:
    RowList(const char* name, int columns, QWidget* parent = nullptr);

    void addRow(const QStringList& texts);
};

} // namespace axiscomp::ui
