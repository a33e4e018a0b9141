// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"
#include "ui/session/axis_entry.h"

#include <QString>

#include <optional>
#include <span>
#include <vector>

/// Which column of a file is for which axis, as plain values.
namespace axiscomp::ui {

/// A table of the open file, by its index, and the axis of the current drive that it is for.
struct ColumnForAxis {
    int column = 0;
    int axis = 0;
    friend bool operator==(const ColumnForAxis&, const ColumnForAxis&) = default;
};

/// An index on the drive; none: the column is not written.
using AxisChoice = std::optional<int>;

/// One choice per table. A table is proposed for the axis whose name it has, or that name and
/// "error" ("X error"), whatever the letters' case; an axis is proposed once, and the exact name
/// comes first. An axis whose name another one has too is not proposed.
[[nodiscard]] std::vector<AxisChoice> proposedAxes(
    std::span<const CompensationTable> tables, std::span<const AxisEntry> axes);

/// Why these cannot be written, a translated sentence: no axis, or one twice; empty when they can.
[[nodiscard]] QString assignmentObstacle(
    std::span<const AxisChoice> choices, std::span<const AxisEntry> axes);

/// "X"; what the drive calls it when it is not among the entries.
[[nodiscard]] QString axisNameAmong(std::span<const AxisEntry> axes, int axis);

} // namespace axiscomp::ui
