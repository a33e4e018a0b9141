// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// The first characters of what came, printable and in quotation marks, for the quote of a Protocol
/// error; "nothing" when it is empty.
[[nodiscard]] Text quoteOf(std::string_view text);

/// Protocol with expected and the quote of text; the link that asked adds its endpoint.
[[nodiscard]] tl::unexpected<Error> notExpected(Text expected, std::string_view text);

/// Parses JSON that a stranger sent: nothing nested deeper than maximumDepth, no exception.
/// A discarded value when it is not JSON.
[[nodiscard]] nlohmann::json parseJson(std::string_view text, std::size_t maximumDepth = 8);

/// A JSON string with its quotation marks; bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string jsonString(std::string_view text);

} // namespace axiscomp::drivecomm
