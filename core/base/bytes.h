// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

using Bytes = std::vector<std::byte>;
using ByteView = std::span<const std::byte>;

[[nodiscard]] inline ByteView asBytes(std::string_view text)
{
    return std::as_bytes(std::span(text.data(), text.size()));
}
[[nodiscard]] inline std::string_view asText(ByteView bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// CRC-32 of IEEE 802.3, as in zlib.
[[nodiscard]] std::uint32_t crc32(ByteView bytes);

/// RFC 4648 section 4, with padding, without line breaks.
[[nodiscard]] std::string toBase64(ByteView bytes);

/// Only what toBase64 writes: no blanks, no missing padding, no stray bits behind the last byte, so
/// that two texts never mean the same bytes.
[[nodiscard]] std::optional<Bytes> fromBase64(std::string_view text);

} // namespace axiscomp
