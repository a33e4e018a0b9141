// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "ui/session/axis_entry.h"

#include <QWidget>

#include <span>

class QCheckBox;
class QLabel;

namespace axiscomp::ui {

class RowList;
class WarningList;

/// What several writes will change, one row per axis: on the drive, new, slot; and what to know
/// about it.
class MultiAxisPlanView : public QWidget {
    Q_OBJECT

public:
    explicit MultiAxisPlanView(QWidget* parent = nullptr);

    /// axes: those of the drive.
    void showPlans(std::span<const WritePlan> plans, std::span<const AxisEntry> axes);
    void clear();
    void retranslate(); ///< showPlans() follows

    /// Whether what is unusually large in the plans that are shown has been confirmed.
    [[nodiscard]] bool isAccepted() const;

    /// "Together: flash operations ..."
    [[nodiscard]] static QString costText(std::span<const WritePlan> plans);

Q_SIGNALS:
    void acceptedChanged();

private:
    RowList* m_rows;
    WarningList* m_warnings;
    QLabel* m_remarks; ///< on units that were converted or assumed
    QCheckBox* m_accept; ///< hidden: nothing is unusually large
};

/// "Dim1: X · PositionController/MasterPosition", a line for each that is set.
[[nodiscard]] QStringList sourceLines(
    std::span<const DimSource> sources, std::span<const AxisEntry> axes);

} // namespace axiscomp::ui
