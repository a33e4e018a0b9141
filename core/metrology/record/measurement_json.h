// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/strict_json.h"
#include "core/metrology/measurement.h"

namespace axiscomp {

/// A measurement as a record holds it (docs/axcal.md), everything that Measurement has: its values
/// as lists, one for each of their members.
[[nodiscard]] OrderedJson toJson(const Measurement& measurement);
/// Problems are recorded at their place: lists of different lengths, targets that do not ascend,
/// numbers of targets and runs that do not exist.
[[nodiscard]] Measurement measurementFromJson(const JsonNode& node);

[[nodiscard]] OrderedJson toJson(const MeasuredState& state);
[[nodiscard]] MeasuredState measuredStateFromJson(const JsonNode& node);

} // namespace axiscomp
