// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/slot_state.h"
#include "core/store/drive_store.h"
#include "core/write/write_plan.h"

namespace axiscomp {

/// What is known of one slot before a table is put into one.
struct SlotFacts {
    TableSlot slot;
    std::uint32_t size = 0; ///< bytes now in it, 0 = empty
    bool isCurrent = false; ///< the axis uses it now
    bool isOwnPrevious = false; ///< holds the axis's own previous table
    /// Flash holds a table of the axis in it that a reboot may bring back: to replace it there, or
    /// to hide it under a volatile one, may leave that table with the sources of another.
    bool isKept = false;
    Text otherUser; ///< "axis 1", "the cogging compensation of axis 0"; empty: none
    SlotState state{}; ///< read after size
};

/// Marks what an axis may need after a reboot that does not use its saved table now. A reboot
/// brings back the saved parameters and the tables in flash, and every persistent write, of any
/// axis, saves the parameters of all axes. So a volatile table must not stand in a slot that has
/// another one in flash; and a persistent one must not replace that which the saved parameters
/// still name: the newest. own: newest first.
void markKept(
    std::vector<SlotFacts>& slots, const std::vector<DriveStore::OwnTable>& own, bool isPersistent);

struct SlotChoice {
    TableSlot slot;
    SlotReason reason = SlotReason::Empty;
    SlotState state{}; ///< of the chosen one
    bool isEmpty = true; ///< nothing is overwritten
};

/// docs/architecture.md, "Slots are taken in turn": the axis's own previous slot, else the smallest
/// empty one that is large enough, else the axis's own slot is overwritten; one that is kept only
/// when there is no other. A slot that something else uses, or whose content is unknown, is taken
/// only when it is named. Errors: TableTooLarge, SlotNotFound, SlotInUse, NoFreeSlot.
[[nodiscard]] Result<SlotChoice> chooseSlot(std::size_t tableBytes,
    const std::optional<std::string>& named, const std::vector<SlotFacts>& slots);

} // namespace axiscomp
