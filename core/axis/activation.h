// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/base/result.h"

namespace axiscomp {

class RegisterAccess;
class SourceDirectory;

/// Switch the compensation of one axis and wait for the resulting state, which is that of this
/// drive. Errors: CompensationError, OtherDrive.
[[nodiscard]] Result<AxisStatus> activateAxis(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources);
[[nodiscard]] Result<AxisStatus> evaluateAxis(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources);
[[nodiscard]] Result<AxisStatus> deactivateAxis(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources);

/// CompensationError with a hint that says what to do about the drive's own error.
[[nodiscard]] Error compensationError(const AxisStatus& status);

} // namespace axiscomp
