// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/base/error.h"
#include "core/base/result.h"
#include "core/base/wall_time.h"
#include "core/drive/operation.h"
#include "core/store/measured_figures.h"
#include "core/write/flash_account.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace axiscomp {

class AxisCompensator;

/// What can be said of one axis among others.
struct AxisSummary {
    AxisInfo axis;
    std::optional<AxisStatus> status{}; ///< none: no compensation registers, or the problem
    std::optional<Error> problem{}; ///< why the axis could not be read
    /// Of the newest backup that this computer has: one is kept before each write.
    std::optional<WallTime> lastWrite{};
    /// With the table that the axis has now, as it looks it up, as far as this computer knows.
    std::optional<MeasuredFigures> measured{};
};

/// All axes of one drive.
struct DriveSummary {
    DriveIdentity drive;
    std::vector<AxisSummary> axes;
    std::optional<FlashUse> flashUse; ///< none: it could not be read
};

/// What this computer knows of the table that the axis has, where the axis looks it up as the
/// record has it (isLookedUpAsMade) and its numbers mean what they meant (isMeantAsKept): otherwise
/// it is worth something else. A store that cannot be read knows nothing.
[[nodiscard]] std::optional<MeasuredFigures> measuredWith(
    const AxisStatus& status, const DriveProfile& profile, const std::filesystem::path& storeRoot);

/// Reads the axes one after the other, without what this computer knows of them; changes nothing.
/// rows: added to, also when the link fails in between. Errors: those of the link, Cancelled.
[[nodiscard]] Result<void> readAxes(
    AxisCompensator& compensator, const OperationOptions& options, std::vector<AxisSummary>& rows);

/// Reads all axes of a drive; changes nothing, also where a write did not end. Errors: those of the
/// link, Cancelled; what is wrong with one axis stands at that axis.
[[nodiscard]] Result<DriveSummary> summarizeDrive(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const OperationOptions& options);

} // namespace axiscomp
