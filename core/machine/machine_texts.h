// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/machine/machine_plan.h"

#include <string>

namespace axiscomp {

// What is said of the axes of a machine file, by the command line and the window alike.

/// "Table", "Dim1Source": PlannedChange::field.
[[nodiscard]] Text fieldText(const std::string& field);
/// "differs: Table, Dim1Source", "has all of this", "problem"
[[nodiscard]] Text differenceText(const AxisPlan& axis);
/// "written", "switched, not proved", "nothing to do", "failed", "not written", "not switched"
[[nodiscard]] Text outcomeText(const AxisOutcome& outcome);
/// "Small1, volatile, CRC 1c291ca3"
[[nodiscard]] Text heldText(const AxisStatus& status);

} // namespace axiscomp
