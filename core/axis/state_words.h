// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/drive/drive_profile.h"

#include <string_view>

namespace axiscomp {

/// What the drive's words mean, by its profile.
[[nodiscard]] CompensationState compensationState(
    const RegisterEnums& enums, std::string_view word);
[[nodiscard]] CompensationFault compensationFault(
    const RegisterEnums& enums, std::string_view word);

} // namespace axiscomp
