// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json_output.h"
#include "core/compensator/axis_compensator.h"

namespace axiscomp::app {

// What documents of --json say of drives and of writing to them.

/// {"index", "name", "unit", "homing", "state"}
[[nodiscard]] Json toJson(const AxisInfo& axis);
[[nodiscard]] Json toJson(const AxisStatus& status);
[[nodiscard]] Json toJson(const FlashUse& use);
/// {"crc", "noted", "date", "unit", "figures": [{"figure", "before", "predicted", "after",
/// "tolerance", "verdict"}]}, what is not known null
[[nodiscard]] Json toJson(const MeasuredFigures& measured);
[[nodiscard]] Json unfinishedToJson(
    const JournalEntry& entry, AxisCompensator::UnfinishedOutcome outcome);
[[nodiscard]] Json toJson(const WritePlan& plan);
[[nodiscard]] Json toJson(const SlotDeletion& plan);
[[nodiscard]] Json toJson(const WriteReport& report);
[[nodiscard]] Json toJson(const Proof& proof, int dimensions);
/// {"path", "size", "maximumSize"}
[[nodiscard]] Json toJson(const DriveFile& file);

/// "tam://mc/..." of the set sources; the address where the drive has no such register.
[[nodiscard]] std::vector<std::string> sourceTexts(
    const std::string& drive, const CompensationSetup& setup);
/// "Named", "Empty", ...
[[nodiscard]] std::string_view slotReasonName(SlotReason reason);

} // namespace axiscomp::app
