// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/slot_choice.h"

#include "core/write/write_plan.h"

#include <algorithm>

namespace axiscomp {

namespace {

tl::unexpected<Error> tooLarge(std::size_t tableBytes, const TableSlot& slot)
{
    return fail(ErrorCode::TableTooLarge,
        {{"size", tableBytes}, {"slot", slot.name}, {"largest", slot.maximumSize}});
}

Result<SlotChoice> namedSlot(
    std::size_t tableBytes, const std::string& name, const std::vector<SlotFacts>& slots)
{
    const auto found = std::ranges::find_if(
        slots, [&](const SlotFacts& facts) { return facts.slot.name == name; });
    if (found == slots.end()) {
        std::vector<std::string> known;
        for (const SlotFacts& facts : slots)
            known.push_back(facts.slot.name);
        return fail(ErrorCode::SlotNotFound, {{"slot", name}, {"known", known}});
    }
    if (tableBytes > found->slot.maximumSize)
        return tooLarge(tableBytes, found->slot);
    if (!found->otherUser.isEmpty())
        return fail(ErrorCode::SlotInUse,
            {{"slot", name}, {"user", found->otherUser}, {"named", Verbatim{"slot"}}});
    return SlotChoice{found->slot, found->isCurrent ? SlotReason::OverwriteOwn : SlotReason::Named,
        found->state, found->size == 0};
}

Text whyNot(const SlotFacts& facts, std::size_t tableBytes)
{
    TextPattern pattern = AXISCOMP_TEXT("Error", "{slot} holds a table that is not this axis's");
    if (facts.slot.maximumSize < tableBytes)
        pattern = AXISCOMP_TEXT("Error", "{slot} holds only {size} bytes");
    else if (!facts.otherUser.isEmpty())
        pattern = AXISCOMP_TEXT("Error", "{slot} is used by {user}");
    return pattern.with("slot", facts.slot.name)
        .with("size", facts.slot.maximumSize)
        .with("user", facts.otherUser);
}

} // namespace

void markKept(
    std::vector<SlotFacts>& slots, const std::vector<DriveStore::OwnTable>& own, bool isPersistent)
{
    for (const DriveStore::OwnTable& table : own) {
        const auto facts = std::ranges::find_if(
            slots, [&](const SlotFacts& each) { return each.slot.name == table.slot; });
        if (facts == slots.end() || !(facts->isOwnPrevious || facts->isCurrent))
            continue;
        facts->isKept = facts->state.persistent;
        if (facts->isKept && isPersistent)
            return;
    }
}

Result<SlotChoice> chooseSlot(std::size_t tableBytes, const std::optional<std::string>& named,
    const std::vector<SlotFacts>& slots)
{
    if (named)
        return namedSlot(tableBytes, *named, slots);

    const auto largest = std::ranges::max_element(
        slots, {}, [](const SlotFacts& facts) { return facts.slot.maximumSize; });
    if (largest == slots.end() || tableBytes > largest->slot.maximumSize)
        return tooLarge(tableBytes, largest == slots.end() ? TableSlot{} : largest->slot);

    const auto smallest = [&](auto&& isWanted) {
        const SlotFacts* best = nullptr;
        for (const SlotFacts& facts : slots) {
            const bool fits = facts.slot.maximumSize >= tableBytes && facts.otherUser.isEmpty();
            if (fits && isWanted(facts)
                && (!best || facts.slot.maximumSize < best->slot.maximumSize))
                best = &facts;
        }
        return best;
    };
    const auto isPrevious = [](const SlotFacts& facts) {
        return facts.isOwnPrevious && !facts.isCurrent;
    };
    for (const bool mayBeKept : {false, true}) {
        if (const SlotFacts* own = smallest([&](const SlotFacts& facts) {
                return isPrevious(facts) && (mayBeKept || !facts.isKept);
            }))
            return SlotChoice{own->slot, SlotReason::OwnPrevious, own->state, own->size == 0};
        if (const SlotFacts* empty = smallest(
                [](const SlotFacts& facts) { return facts.size == 0 && !facts.isCurrent; }))
            return SlotChoice{empty->slot, SlotReason::Empty, empty->state, true};
        if (const SlotFacts* current = smallest([&](const SlotFacts& facts) {
                return facts.isCurrent && (mayBeKept || !facts.isKept);
            }))
            return SlotChoice{
                current->slot, SlotReason::OverwriteOwn, current->state, current->size == 0};
    }

    std::vector<Text> reasons;
    for (const SlotFacts& facts : slots)
        reasons.push_back(whyNot(facts, tableBytes));
    return fail(ErrorCode::NoFreeSlot, {{"size", tableBytes}, {"slots", std::move(reasons)}});
}

} // namespace axiscomp
