// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// IPv4 addresses of computers, from first to last and both included, in host byte order, and the
/// TCP port at which each is asked. 1 to mostRangeAddresses of them.
struct NetworkRange {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint16_t port = 80;

    [[nodiscard]] std::size_t count() const { return std::size_t{last} - first + 1; }
    friend bool operator==(const NetworkRange&, const NetworkRange&) = default;
};

/// A search asks no more of them: whoever means a larger network says which part of it.
inline constexpr std::size_t mostRangeAddresses = 1024;

/// "192.168.1.0/24" (RFC 4632), "192.168.1.10-192.168.1.40", "192.168.1.10-40" or "192.168.1.20",
/// each with ":8080" behind it for another port than 80. Of a network the first and the last
/// address are left out, which are no computers, unless it has no more than two (RFC 3021). Errors:
/// InvalidArgument with what is wrong and what can be written instead.
[[nodiscard]] Result<NetworkRange> parseNetworkRange(std::string_view text);

/// "192.168.1.1-192.168.1.254", "192.168.1.20:8080": parseNetworkRange() gives the range again.
[[nodiscard]] std::string toText(const NetworkRange& range);

/// "192.168.1.20", in order.
[[nodiscard]] std::vector<std::string> addressesIn(const NetworkRange& range);

/// The network of one of this computer's addresses as a range to propose: "192.168.1.0/24". Of a
/// network with more than mostRangeAddresses only the 254 around the address.
[[nodiscard]] std::string networkAround(std::uint32_t address, int prefixLength);

} // namespace axiscomp
