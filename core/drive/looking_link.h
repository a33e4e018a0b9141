// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/forwarding_link.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <chrono>
#include <memory>

namespace axiscomp {

/// A link that only looks, and only for so long: all of its exchanges together have one deadline,
/// and nothing is written through it (NotAllowedNow).
class LookingLink final : public ForwardingLink<LookingLink> {
public:
    LookingLink(std::unique_ptr<DriveLink> link, std::chrono::milliseconds together)
        : ForwardingLink(std::move(link))
        , m_together(together)
        , m_deadline(Clock::now() + together)
    {
    }

    [[nodiscard]] Result<void> writeRegisters(
        std::span<const RegisterWrite>, const Exchange&) override
    {
        return onlyLooks();
    }
    [[nodiscard]] Result<void> upload(const std::string&, ByteView, const Exchange&) override
    {
        return onlyLooks();
    }

private:
    friend ForwardingLink;
    using Clock = std::chrono::steady_clock;

    static tl::unexpected<Error> onlyLooks()
    {
        return fail(ErrorCode::NotAllowedNow,
            {{"reason", AXISCOMP_TEXT("Error", "the drive is only looked at")}});
    }

    /// A timeout says the whole time, since what was left of it says nothing.
    template <typename Call>
    auto around(const Exchange& exchange, const Call& call) -> decltype(call(exchange))
    {
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(m_deadline - Clock::now());
        const Quantity seconds{toText(static_cast<double>(m_together.count()) / 1000.0)};
        if (left <= std::chrono::milliseconds{0})
            return fail(ErrorCode::Timeout, {{"endpoint", endpoint()}, {"seconds", seconds}});
        Exchange rest = exchange;
        rest.timeout = std::min(exchange.timeout, left);
        auto result = call(rest);
        if (!result && result.error().code == ErrorCode::Timeout && left < exchange.timeout)
            result.error().context.set("seconds", seconds);
        return result;
    }

    std::chrono::milliseconds m_together;
    Clock::time_point m_deadline;
};

} // namespace axiscomp
