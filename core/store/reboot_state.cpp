// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/reboot_state.h"

#include <algorithm>

namespace axiscomp {

bool RebootState::isCovered(std::string_view slot) const
{
    return std::ranges::find(covered, slot) != covered.end();
}

std::optional<int> RebootState::otherUser(std::string_view slot, int axis) const
{
    const auto other = std::ranges::find_if(
        uses, [&](const Use& use) { return use.slot == slot && use.axis != axis; });
    return other == uses.end() ? std::nullopt : std::optional(other->axis);
}

bool RebootState::isInTheWay(std::string_view slot, int axis, std::uint32_t crc) const
{
    return std::ranges::any_of(uses,
        [&](const Use& use) { return use.slot == slot && (use.axis != axis || use.crc != crc); });
}

} // namespace axiscomp
