// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/compensator/axis_compensator.h"
#include "core/csv/calibration_csv.h"

namespace axiscomp::app {

// The documents of --json: stable, described in docs/cli.md. Numbers are exact.

/// Indented, with a line end. Text that is not UTF-8 is repaired rather than refused.
[[nodiscard]] std::string dump(const Json& json);

/// {"code", "line", "column", "message"}
[[nodiscard]] std::vector<std::string> englishOf(const std::vector<Text>& texts);
[[nodiscard]] Json toJson(const Diagnostic& diagnostic);
/// [{"name", "unit", "start", "distance", "size"}]
[[nodiscard]] Json toJson(const Grid& grid);
/// [[2, 0], ...]: the points that were made up, by their indices in each dimension, from 0
[[nodiscard]] Json filledJson(
    const std::vector<std::uint32_t>& filled, const std::vector<std::size_t>& sizes);
/// {"name", "target", "unit", "min", "max", "rms", "filled"}
[[nodiscard]] Json toJson(const CompensationTable& table);
/// {"code", "message", "context", "diagnostics"}
[[nodiscard]] Json toJson(const Error& error, const Json& diagnostics);
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
