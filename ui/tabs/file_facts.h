// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableWidget>

namespace axiscomp::ui {

struct ReadMeasurement;

/// What the file of a measurement says, a row for each statement.
class FileFacts : public QTableWidget {
    Q_OBJECT

public:
    explicit FileFacts(QWidget* parent = nullptr);

    /// Null: nothing.
    void show(const ReadMeasurement* reading);
    void retranslate();

private:
    void add(const QString& name, const QString& statement);
};

} // namespace axiscomp::ui
