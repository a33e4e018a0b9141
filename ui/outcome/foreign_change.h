// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "ui/outcome/outcome_text.h"

namespace axiscomp::ui {

/// What has happened to an axis without this window, loud enough to take the place of a message
/// that is no longer true: a restart, a lost table, a compensation that somebody switched, other
/// settings. Empty: nothing that matters.
[[nodiscard]] Outcome foreignChange(const AxisStatus& before, const AxisStatus& now);

} // namespace axiscomp::ui
