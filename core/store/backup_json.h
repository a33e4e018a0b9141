// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"
#include "core/drive/register_value.h"
#include "core/io/strict_json.h"
#include "core/table/grid.h"
#include "core/table/table_units.h"
#include "core/text/crc_text.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// [{"path": ..., "type": "UInt32", "value": ...}, ...]; numbers that JSON has no form for are
/// texts
/// ("NaN", "Infinity", "-Infinity").
[[nodiscard]] OrderedJson toJson(std::span<const RegisterWrite> registers);
[[nodiscard]] std::vector<RegisterWrite> registersFromJson(const JsonNode& node);

[[nodiscard]] WallTime timeFromJson(const JsonNode& node);

[[nodiscard]] std::uint32_t crcFromJson(const JsonNode& node);

/// [{"start": ..., "distance": ..., "size": ...}, ...]: where a grid lies, without its names.
[[nodiscard]] OrderedJson spansToJson(const Grid& grid);
[[nodiscard]] Grid spansFromJson(const JsonNode& node);

/// {"values": ..., "positions": [...]}
[[nodiscard]] OrderedJson toJson(const TableUnits& units);
[[nodiscard]] TableUnits unitsFromJson(const JsonNode& node);

} // namespace axiscomp
