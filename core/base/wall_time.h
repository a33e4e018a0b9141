// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace axiscomp {

/// The computer's clock: may be set back or forth at any moment.
using WallTime = std::chrono::system_clock::time_point;

/// ISO 8601 in UTC, "2026-11-21T08:02:23Z", with as many digits after the second as the time needs.
[[nodiscard]] std::string utcText(WallTime time);

/// What utcText writes, up to nine digits after the second; nothing else.
[[nodiscard]] std::optional<WallTime> utcFromText(std::string_view text);

} // namespace axiscomp
