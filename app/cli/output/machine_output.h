// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/machine/machine_plan.h"

#include <string>

namespace axiscomp::app {

// What is said of the axes of a machine file, for people and as documents of --json (docs/cli.md).

/// "differs: Table, Dim1Source", "has all of this", "problem"
[[nodiscard]] std::string differenceWords(const AxisPlan& axis);
/// "written", "nothing to do", "failed", "not written"
[[nodiscard]] std::string outcomeWords(const AxisPlan& axis, const AxisOutcome& outcome);
/// "Small1, volatile, CRC 1c291ca3"
[[nodiscard]] std::string heldWords(const AxisStatus& status);

/// {"name", "axis", "differs", "plan", "switch", "unfinished", "obstacle", "problem"}
[[nodiscard]] Json toJson(const AxisPlan& axis);
/// {"written", "backup", "proof", "problem", "status"}
[[nodiscard]] Json toJson(const AxisOutcome& outcome);

} // namespace axiscomp::app
