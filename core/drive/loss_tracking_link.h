// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/drive/forwarding_link.h"

#include <atomic>
#include <memory>

namespace axiscomp {

/// A link that notes when the drive was lost, so that its session makes a new one. Once the session
/// is ending, a lost drive is not asked again: what is put back then may take as long as the drive
/// answers, but a drive that hangs is waited for once only.
class GuardedLink final : public ForwardingLink<GuardedLink> {
public:
    GuardedLink(std::unique_ptr<DriveLink> link, const std::atomic<bool>& isEnding)
        : ForwardingLink(std::move(link))
        , m_isEnding(isEnding)
    {
    }

    [[nodiscard]] bool isLost() const { return m_isLost; }

private:
    friend ForwardingLink;
    template <typename Call>
    auto around(const Exchange& exchange, const Call& call) -> decltype(call(exchange))
    {
        if (m_isLost && m_isEnding)
            return fail(ErrorCode::NotConnected,
                {{"endpoint", endpoint()},
                    {"reason", AXISCOMP_TEXT("Error", "the program is ending")}});
        auto result = call(exchange);
        if (!result && isLinkFailure(result.error().code))
            m_isLost = true;
        return result;
    }

    const std::atomic<bool>& m_isEnding;
    bool m_isLost = false;
};

} // namespace axiscomp
