// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/network_range.h"

#include "core/base/error.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace axiscomp {

namespace {

/// Of a computer: not "this network" (RFC 1122 3.2.1.3), not multicast, reserved or broadcast.
constexpr std::uint32_t firstHost = 0x01000000;
constexpr std::uint32_t lastHost = 0xdfffffff;

tl::unexpected<Error> invalid(std::string_view text, Text reason)
{
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error", "\"{range}\" is not a range of addresses: {reason}")
                .with("range", Verbatim{std::string(text)})
                .with("reason", std::move(reason))}});
}

Text expectedForms()
{
    return AXISCOMP_TEXT("Error",
        "write it as {network}, {range} or {address}, with {port} behind it for another port")
        .with("network", Verbatim{"192.168.1.0/24"})
        .with("range", Verbatim{"192.168.1.10-192.168.1.40"})
        .with("address", Verbatim{"192.168.1.20"})
        .with("port", Verbatim{":8080"});
}

/// Decimal, without a sign, and without a leading zero, which others take for octal.
std::optional<std::uint32_t> number(std::string_view text, std::uint32_t most)
{
    std::uint32_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool isPlain = !text.empty() && (text.size() == 1 || text.front() != '0');
    if (error != std::errc{} || stop != end || !isPlain || value > most)
        return std::nullopt;
    return value;
}

std::optional<std::uint32_t> address(std::string_view text)
{
    std::uint32_t value = 0;
    for (int part = 0; part < 4; ++part) {
        const std::size_t dot = part < 3 ? text.find('.') : text.size();
        if (dot == std::string_view::npos)
            return std::nullopt;
        const auto byte = number(text.substr(0, dot), 255);
        if (!byte)
            return std::nullopt;
        value = value << 8 | *byte;
        text.remove_prefix(std::min(dot + 1, text.size()));
    }
    return value;
}

std::string addressText(std::uint32_t address)
{
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8)
        text += std::to_string(address >> shift & 255) + (shift > 0 ? "." : "");
    return text;
}

std::uint32_t hostBits(std::uint32_t prefixLength)
{
    return prefixLength == 0 ? 0xffffffff : (1U << (32 - prefixLength)) - 1;
}

NetworkRange network(std::uint32_t address, std::uint32_t prefixLength)
{
    const std::uint32_t hosts = hostBits(prefixLength);
    NetworkRange range{address & ~hosts, address | hosts};
    if (prefixLength < 31) {
        ++range.first;
        --range.last;
    }
    return range;
}

/// "40" behind "192.168.1.10-" is 192.168.1.40.
std::optional<std::uint32_t> lastAddress(std::string_view text, std::uint32_t first)
{
    if (const auto byte = number(text, 255))
        return (first & 0xffffff00) | *byte;
    return address(text);
}

/// Without the port.
std::optional<NetworkRange> addresses(std::string_view text)
{
    const std::size_t slash = text.find('/');
    const std::size_t dash = text.find('-');
    const bool isBoth = slash != std::string_view::npos && dash != std::string_view::npos;
    const auto first = address(text.substr(0, std::min(slash, dash)));
    if (!first || isBoth)
        return std::nullopt;
    if (slash != std::string_view::npos) {
        const auto prefixLength = number(text.substr(slash + 1), 32);
        return prefixLength ? std::optional(network(*first, *prefixLength)) : std::nullopt;
    }
    if (dash == std::string_view::npos)
        return NetworkRange{*first, *first};
    const auto last = lastAddress(text.substr(dash + 1), *first);
    return last ? std::optional(NetworkRange{*first, *last}) : std::nullopt;
}

} // namespace

Result<NetworkRange> parseNetworkRange(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    const std::string_view whole = text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
    const std::size_t colon = whole.find(':');
    auto range = addresses(whole.substr(0, colon));
    if (!range)
        return invalid(whole, expectedForms());
    if (colon != std::string_view::npos) {
        const auto port = number(whole.substr(colon + 1), 65535);
        if (!port || *port == 0)
            return invalid(whole, AXISCOMP_TEXT("Error", "a port is a number from 1 to 65535"));
        range->port = static_cast<std::uint16_t>(*port);
    }
    if (range->last < range->first)
        return invalid(whole, AXISCOMP_TEXT("Error", "its last address is before the first"));
    if (range->count() > mostRangeAddresses)
        return invalid(whole,
            AXISCOMP_TEXT("Error",
                "it has {count} addresses, and a search asks {limit} at most: name a part of it")
                .with("count", static_cast<std::int64_t>(range->count()))
                .with("limit", static_cast<std::int64_t>(mostRangeAddresses)));
    if (range->first < firstHost || range->last > lastHost)
        return invalid(whole, AXISCOMP_TEXT("Error", "these are no addresses of computers"));
    return *range;
}

std::string toText(const NetworkRange& range)
{
    std::string text = addressText(range.first);
    if (range.last != range.first)
        text += "-" + addressText(range.last);
    return range.port == NetworkRange{}.port ? text : text + ":" + std::to_string(range.port);
}

std::vector<std::string> addressesIn(const NetworkRange& range)
{
    std::vector<std::string> all;
    for (std::size_t n = 0; n < range.count(); ++n)
        all.push_back(addressText(range.first + static_cast<std::uint32_t>(n)));
    return all;
}

std::string networkAround(std::uint32_t address, int prefixLength)
{
    constexpr int around = 24;
    const auto given = static_cast<std::uint32_t>(std::clamp(prefixLength, 0, 32));
    const bool isTooLarge = network(address, given).count() > mostRangeAddresses;
    const std::uint32_t shown = isTooLarge ? around : given;
    return addressText(address & ~hostBits(shown)) + "/" + std::to_string(shown);
}

} // namespace axiscomp
