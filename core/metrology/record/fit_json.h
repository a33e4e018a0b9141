// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/strict_json.h"
#include "core/metrology/record/calibration_record.h"

namespace axiscomp {

// How tables were made and what they promise, as a record holds it (docs/axcal.md).

[[nodiscard]] OrderedJson toJson(const RecordedFit& fit);
[[nodiscard]] RecordedFit recordedFitFromJson(const JsonNode& node);

[[nodiscard]] OrderedJson toJson(const RecordedTable& table);
/// A CRC-32 that is not the one of the values is a problem.
[[nodiscard]] RecordedTable recordedTableFromJson(const JsonNode& node);

[[nodiscard]] OrderedJson toJson(const FigureValues& figures);
[[nodiscard]] FigureValues figureValuesFromJson(const JsonNode& node);

[[nodiscard]] OrderedJson toJson(const RecordedPrediction& prediction);
[[nodiscard]] RecordedPrediction predictionFromJson(const JsonNode& node);

[[nodiscard]] OrderedJson toJson(const RecordedVerdict& verdict);
[[nodiscard]] RecordedVerdict verdictFromJson(const JsonNode& node);

[[nodiscard]] OrderedJson toJson(const RecordedJudging& judging);
[[nodiscard]] RecordedJudging judgingFromJson(const JsonNode& node);

} // namespace axiscomp
