// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/calibration_csv.h"
#include "ui/data/column_mapping.h"

#include <QTableWidget>

#include <memory>

class QComboBox;

namespace axiscomp::ui {

/// The columns of a file, one row each: name, range of values, and a choice of the axis that shall
/// have it.
class ColumnMappingTable : public QTableWidget {
    Q_OBJECT

public:
    /// Begins with what proposedAxes() proposes.
    ColumnMappingTable(std::shared_ptr<const CalibrationData> file, std::vector<AxisEntry> axes,
        QWidget* parent = nullptr);

    [[nodiscard]] std::vector<AxisChoice> choices() const; ///< one per column
    void setChoosable(bool isChoosable);
    void retranslate();

Q_SIGNALS:
    void choiceChanged();

private:
    void build();
    void addRow(int row, const AxisChoice& proposal);
    void askForRanges();
    [[nodiscard]] QString columnName(int row) const;

    std::shared_ptr<const CalibrationData> m_file;
    std::vector<AxisEntry> m_axes;
    std::vector<QComboBox*> m_combos; ///< one per row
};

} // namespace axiscomp::ui
