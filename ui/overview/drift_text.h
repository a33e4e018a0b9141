// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/machine_controller.h"
#include "ui/session/axis_entry.h"
#include "ui/style/contrast.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <span>
#include <vector>

namespace axiscomp::ui {

// What is said of how an axis stands to the machine file.

/// "14:03:12"; with the date when it was not today.
[[nodiscard]] QString momentText(const QDateTime& time);
/// "as the file says · 14:03:12", "differs: table, persistency · 14:03:12"
[[nodiscard]] QString driftText(const AxisDrift& drift);
/// The whole of it, with the reason where there is one.
[[nodiscard]] QString driftToolTip(const AxisDrift& drift);
/// None: nothing that stands out.
[[nodiscard]] std::optional<Tone> driftTone(AxisDrift::State state);

/// One field in which an axis differs.
struct DriftLine {
    QString field;
    QString before; ///< on the drive
    QString after; ///< as the file says
};
/// axes: of the drive.
[[nodiscard]] std::vector<DriftLine> driftLines(
    const AxisPlan& plan, const MachineAxis& wanted, std::span<const AxisEntry> axes);
/// Why an axis cannot be compared or written, and what to know about it; sentences. tables: what
/// its file has said, may be null.
[[nodiscard]] QStringList driftWarnings(const AxisPlan& plan, const MachineTable* table);
/// What was converted and assumed.
[[nodiscard]] QStringList driftRemarks(const AxisPlan& plan);
/// "http://192.168.1.20 (serial number 100001)", "..., axis X"
[[nodiscard]] QString machinePlaceText(
    const MachineDriveState& drive, std::optional<std::size_t> axis);

} // namespace axiscomp::ui
