// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/flash_wear.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace axiscomp {

namespace {

// Keeps the arithmetic of 64-bit nanoseconds away from its ends, whatever a profile or a drive
// says.
constexpr std::chrono::seconds longest = std::chrono::hours{24 * 365};

std::chrono::seconds secondsUntil(WallTime moment, WallTime now)
{
    return std::max(std::chrono::seconds{0}, std::chrono::ceil<std::chrono::seconds>(moment - now));
}

} // namespace

FlashWearGuard::FlashWearGuard(FlashWearLimits limits, std::vector<WallTime> operations)
    : m_limits(limits)
    , m_operations(std::move(operations))
{
    m_limits.window = std::clamp(m_limits.window, std::chrono::seconds{0}, longest);
    std::ranges::sort(m_operations);
}

bool FlashWearGuard::counts(WallTime operation, WallTime now) const
{
    return operation > now - m_limits.window && operation < now + m_limits.window;
}

FlashBudget FlashWearGuard::budget(WallTime now, int wanted) const
{
    FlashBudget result{std::numeric_limits<int>::max()};
    if (m_limits.operations > 0) {
        const std::vector<WallTime> counted = operations(now);
        const auto limit = static_cast<std::size_t>(m_limits.operations);
        result.left = static_cast<int>(limit - std::min(limit, counted.size()));
        const auto needed = static_cast<std::size_t>(std::clamp(wanted, 1, m_limits.operations));
        // They are possible when only limit - needed of those before still count.
        if (counted.size() + needed > limit)
            result.wait =
                secondsUntil(counted[counted.size() + needed - limit - 1] + m_limits.window, now);
    }
    const bool refusalIsPlausible = now > m_refusedAt - std::max(m_limits.window, m_refusalWait);
    if (refusalIsPlausible && now < m_refusedAt + m_refusalWait)
        result = {0, std::max(result.wait, secondsUntil(m_refusedAt + m_refusalWait, now))};
    if (m_isRecordLost && m_limits.operations > 0) {
        result.left = 0;
        result.isRecordLost = true;
    }
    return result;
}

void FlashWearGuard::record(WallTime now, int operations)
{
    std::erase_if(m_operations, [&](WallTime operation) { return !counts(operation, now); });
    const auto position = std::ranges::upper_bound(m_operations, now);
    m_operations.insert(position, static_cast<std::size_t>(std::max(operations, 0)), now);
}

void FlashWearGuard::recordRefusal(WallTime now, std::chrono::seconds wait)
{
    m_refusedAt = now;
    m_refusalWait = std::clamp(wait, std::chrono::seconds{0}, longest);
}

std::vector<WallTime> FlashWearGuard::operations(WallTime now) const
{
    std::vector<WallTime> result;
    std::ranges::copy_if(m_operations, std::back_inserter(result),
        [&](WallTime operation) { return counts(operation, now); });
    return result;
}

} // namespace axiscomp
