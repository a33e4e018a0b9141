// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/machine_controller.h"
#include "ui/session/axis_entry.h"

#include <QWidget>

class QLabel;

namespace axiscomp::ui {

class RowList;
class WarningList;

/// How one axis differs from the machine file, field by field, and what to know about it.
class DriftDetails : public QWidget {
    Q_OBJECT

public:
    explicit DriftDetails(QWidget* parent = nullptr);

    /// name: of the axis, "X · Stage-7". axes: of its drive. table: of its file; may be null.
    void showDrift(const QString& name, const AxisDrift& drift, const MachineTable* table,
        std::span<const AxisEntry> axes);
    void clear();
    void retranslate(); ///< showDrift() follows

private:
    QLabel* m_title;
    RowList* m_rows;
    WarningList* m_warnings;
    QLabel* m_remarks;
};

} // namespace axiscomp::ui
