// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "ui/session/axis_entry.h"

#include <QWidget>

#include <span>

class QLabel;
class QTableWidget;

namespace axiscomp::ui {

/// What several writes will change, one row per axis: on the drive, new, slot; and what to know
/// about it.
class MultiAxisPlanView : public QWidget {
    Q_OBJECT

public:
    explicit MultiAxisPlanView(QWidget* parent = nullptr);

    /// tables: one per plan. axes: those of the drive.
    void showPlans(std::span<const WritePlan> plans,
        std::span<const CompensationTable* const> tables, std::span<const AxisEntry> axes);
    void clear();
    void retranslate(); ///< showPlans() follows

    /// "Together: flash operations ..."
    [[nodiscard]] static QString costText(std::span<const WritePlan> plans);

private:
    void addRow(const WritePlan& plan, const CompensationTable& table,
        std::span<const AxisEntry> axes, bool isSlotTaken);

    QTableWidget* m_rows;
    QLabel* m_remarks;
};

/// "Dim1: X · PositionController/MasterPosition", a line for each that is set.
[[nodiscard]] QStringList sourceLines(
    std::span<const DimSource> sources, std::span<const AxisEntry> axes);

} // namespace axiscomp::ui
