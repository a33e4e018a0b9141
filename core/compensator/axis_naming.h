// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/base/result.h"

#include <span>
#include <string>
#include <string_view>

/// How an axis of a drive is said, on the command line and in machine files: by its index or its
/// name, or by "index:1" or "name:1" where a number is both.
namespace axiscomp {

/// The index of the axis that is meant. Errors: AxisNotFound; AxisAmbiguous when several axes have
/// this name, or when it is the name of one axis and the index of another.
[[nodiscard]] Result<int> axisAmong(std::span<const AxisInfo> axes, std::string_view asked);

/// The index as axisAmong takes it: "1", or "index:1" where another axis is called 1.
[[nodiscard]] std::string axisIndexText(std::span<const AxisInfo> axes, int index);

} // namespace axiscomp
