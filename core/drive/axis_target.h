// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive/compensation_setup.h"
#include "core/drive/drive_profile.h"
#include "core/table/compensation_table.h"

#include <span>

namespace axiscomp {

/// What an axis of the drive is among the sources of its table (target_axis.h): "#1" when the first
/// source is a position of that axis, "other" when all are positions of other axes. Empty: that
/// cannot be told, because a source is another signal. sources: paths of registers.
[[nodiscard]] std::string axisTarget(
    const DriveProfile& profile, int axis, std::span<const std::string> sources);

/// That a table whose file says what it corrects is not written to an axis that is something else
/// among the sources: the Y errors of a grid to axis X. Nor is one that was converted for what
/// another axis, or this one, was among other sources. Errors: TargetMismatch.
[[nodiscard]] Result<void> checkTarget(const DriveProfile& profile, int axis,
    std::span<const std::string> sources, const CompensationTable& table);

/// The paths of the sources that are set.
[[nodiscard]] std::vector<std::string> sourcePaths(const CompensationSetup& setup);

} // namespace axiscomp
