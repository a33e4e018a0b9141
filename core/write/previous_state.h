// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/base/result.h"
#include "core/drive/drive_profile.h"
#include "core/store/drive_store.h"

#include <filesystem>

namespace axiscomp {

/// What "Restore previous" brings back.
struct PreviousState {
    AxisBackup backup; ///< the axis's registers and the one table that they name
    std::filesystem::path file;
};

/// The newest backup of the axis that is not what it has now. A write that failed and was undone
/// leaves a backup too, of the state that is still there: restoring that one would do nothing.
/// Errors: FileNotReadable when there is none.
[[nodiscard]] Result<PreviousState> previousState(
    const DriveStore& store, const DriveProfile& profile, const AxisStatus& status);

} // namespace axiscomp
