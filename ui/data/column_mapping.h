// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/proposals.h"
#include "ui/session/axis_entry.h"

#include <QString>

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

/// What the columns are looked up by. OwnPosition: each by the position of its axis, of one
/// dimension.
enum class SourcesForSeveral { Kept, OfPage, OwnPosition };

/// What the drive says about these axes.
[[nodiscard]] std::vector<AxisInfo> infosOf(std::span<const AxisEntry> axes);

/// Why these cannot be written, a translated sentence: no axis, or one twice; empty when they can.
[[nodiscard]] QString assignmentObstacle(
    std::span<const AxisChoice> choices, std::span<const AxisEntry> axes);

/// "X"; what the drive calls it when it is not among the entries.
[[nodiscard]] QString axisNameAmong(std::span<const AxisEntry> axes, int axis);

} // namespace axiscomp::ui
