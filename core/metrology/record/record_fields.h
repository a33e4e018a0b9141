// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/strict_json.h"
#include "core/metrology/record/calibration_record.h"

#include <algorithm>
#include <span>

// How single values stand in a record. For the files of this folder.
namespace axiscomp::record_json {

/// The names of an enum's values, in their order. A record keeps them for ever.
using Names = std::span<const std::string_view>;

template <typename Enum> std::string_view nameOf(Enum value, Names names)
{
    return names[static_cast<std::size_t>(value)];
}
[[nodiscard]] std::size_t indexFromJson(const JsonNode& node, Names names);
template <typename Enum> Enum enumFromJson(const JsonNode& node, Names names)
{
    return static_cast<Enum>(indexFromJson(node, names));
}

/// Members that are left out, or null, are empty.
[[nodiscard]] bool isThere(const JsonNode& object, std::string_view key);
[[nodiscard]] std::string maybeText(const JsonNode& object, std::string_view key);
[[nodiscard]] bool maybeTrue(const JsonNode& object, std::string_view key);
[[nodiscard]] std::optional<double> maybeNumber(const JsonNode& object, std::string_view key);
[[nodiscard]] std::vector<std::string> textsFromJson(const JsonNode& list);
[[nodiscard]] std::vector<std::string> maybeTexts(const JsonNode& object, std::string_view key);

template <typename Value>
void putIfThere(OrderedJson& object, const char* key, const std::optional<Value>& value)
{
    if (value)
        object[key] = *value;
}
void putIfThere(OrderedJson& object, const char* key, const std::string& value);
void putIfThere(OrderedJson& object, const char* key, const std::vector<std::string>& value);

/// What stands in the file beside `known`, which is what would be written for what was read. Lists
/// of another length are left alone: their elements keep their own.
[[nodiscard]] OtherMembers otherMembers(const JsonNode& node, const OrderedJson& known);
void putBack(OrderedJson& object, const OtherMembers& others);

/// The shortest digits that are this float32 again, as a double.
[[nodiscard]] double shortDouble(float value);

} // namespace axiscomp::record_json
