// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/machine/machine_plan.h"

namespace axiscomp::app {

// What is said of the axes of a machine file as documents of --json (docs/cli.md).

/// {"name", "axis", "differs", "plan", "switch", "unfinished", "obstacle", "problem"}
[[nodiscard]] Json toJson(const AxisPlan& axis);
/// {"written", "backup", "proof", "problem", "status"}
[[nodiscard]] Json toJson(const AxisOutcome& outcome);

} // namespace axiscomp::app
