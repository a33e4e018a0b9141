// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/slot_state.h"

namespace axiscomp {

/// What is known of one slot before a table is put into one.
struct SlotFacts {
    TableSlot slot;
    std::uint32_t size = 0; ///< bytes now in it, 0 = empty
    bool isCurrent = false; ///< the axis uses it now
    bool isOwnPrevious = false; ///< holds the axis's own previous table
    std::string otherUser; ///< "axis 1", "the cogging compensation of axis 0"; empty: none
    SlotState state{}; ///< read after size
};

struct SlotChoice {
    TableSlot slot;
    SlotReason reason = SlotReason::Empty;
    SlotState state{}; ///< of the chosen one
};

/// DESIGN.md, "Slots are taken in turn": the axis's own previous slot, else the smallest empty one
/// that is large enough, else the axis's own slot is overwritten. A slot that something else uses,
/// or whose content is unknown, is taken only when it is named. Errors: TableTooLarge,
/// SlotNotFound, SlotInUse, NoFreeSlot.
[[nodiscard]] Result<SlotChoice> chooseSlot(std::size_t tableBytes,
    const std::optional<std::string>& named, const std::vector<SlotFacts>& slots);

} // namespace axiscomp
