// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"

#include <optional>
#include <string>
#include <string_view>

namespace axiscomp {

/// RFC 4648 section 4, with padding, without line breaks.
[[nodiscard]] std::string toBase64(ByteView bytes);

/// Only what toBase64 writes: no blanks, no missing padding, no stray bits behind the last byte, so
/// that two texts never mean the same bytes.
[[nodiscard]] std::optional<Bytes> fromBase64(std::string_view text);

} // namespace axiscomp
