// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// Limits of what a drive may send (docs/protocol.md, "Errors"). Longer strings are cut off.
constexpr int deepestTextJson = 8; ///< texts in each other
constexpr std::size_t mostTextJsonArguments = 64; ///< and items of lists, of all texts together
constexpr std::size_t longestTextJsonString = 1000; ///< bytes, also of each text when it is filled
/// Objects and lists in each other that a text of that depth can take.
constexpr std::size_t textJsonNesting = 4 * deepestTextJson;

/// A sentence as a value, so that whoever receives it can say it in another language.
[[nodiscard]] std::string textJson(const Text& text);

/// What textJson wrote; nullopt when it is something else or beyond the limits.
[[nodiscard]] std::optional<Text> parseTextJson(std::string_view json);
/// The same, of a part of a document.
[[nodiscard]] std::optional<Text> textFromJson(const nlohmann::json& json);

} // namespace axiscomp::drivecomm
