// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"
#include "core/drive/register_value.h"
#include "core/io/strict_json.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// Written in the order in which the members were added, as a person would read them.
using OrderedJson = nlohmann::ordered_json;

/// Indented, with a line break at the end. Text that is not UTF-8 (a drive's name may be any bytes)
/// gets replacement characters.
[[nodiscard]] std::string jsonText(const OrderedJson& document);

/// {"format": format, "version": 1}, to which the rest is added.
[[nodiscard]] OrderedJson newDocument(std::string_view format);
/// Refuses another format or version.
void expectFormat(const JsonNode& document, std::string_view format);

/// [{"path": ..., "type": "UInt32", "value": ...}, ...]; numbers that JSON has no form for are
/// texts
/// ("NaN", "Infinity", "-Infinity").
[[nodiscard]] OrderedJson toJson(std::span<const RegisterWrite> registers);
[[nodiscard]] std::vector<RegisterWrite> registersFromJson(const JsonNode& node);

[[nodiscard]] WallTime timeFromJson(const JsonNode& node);

/// "1c291ca3"
[[nodiscard]] std::string crcText(std::uint32_t crc);
[[nodiscard]] std::uint32_t crcFromJson(const JsonNode& node);

} // namespace axiscomp
