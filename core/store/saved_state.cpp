// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the DriveStore knows of what a reboot brings back.
#include "core/store/drive_store.h"
#include "core/store/store_folder.h"
#include "core/store/store_json.h"

#include <algorithm>

namespace axiscomp {

bool DriveStore::SavedState::isCovered(std::string_view slot) const
{
    return std::ranges::find(covered, slot) != covered.end();
}

std::optional<int> DriveStore::SavedState::otherUser(std::string_view slot, int axis) const
{
    const auto other = std::ranges::find_if(
        uses, [&](const Use& use) { return use.slot == slot && use.axis != axis; });
    return other == uses.end() ? std::nullopt : std::optional(other->axis);
}

bool DriveStore::SavedState::isInTheWay(std::string_view slot, int axis, std::uint32_t crc) const
{
    return std::ranges::any_of(uses,
        [&](const Use& use) { return use.slot == slot && (use.axis != axis || use.crc != crc); });
}

Result<DriveStore::SavedState> DriveStore::savedState(std::int32_t serialNumber)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    return folder.look<SavedState>(folder.saved(), readSavedState);
}

template <typename Change>
Result<void> DriveStore::changeSavedState(std::int32_t serialNumber, const Change& change)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    auto state = folder.take<SavedState>(folder.saved(), readSavedState);
    if (!state)
        return fail(state.error());
    const SavedState before = *state;
    change(*state);
    if (*state == before)
        return {};
    return saveFile(folder.saved(), asBytes(writeSavedState(*state)));
}

Result<void> DriveStore::recordSaving(
    std::int32_t serialNumber, const std::vector<SavedState::Use>& uses)
{
    return changeSavedState(serialNumber, [&](SavedState& state) {
        for (const SavedState::Use& use : uses)
            if (std::ranges::find(state.uses, use) == state.uses.end())
                state.uses.push_back(use);
    });
}

Result<void> DriveStore::recordSaved(
    std::int32_t serialNumber, const std::vector<SavedState::Use>& uses)
{
    return changeSavedState(serialNumber, [&](SavedState& state) {
        state.isKnown = true;
        state.uses = uses;
    });
}

Result<void> DriveStore::recordCovered(
    std::int32_t serialNumber, const std::string& slot, bool isCovered)
{
    return changeSavedState(serialNumber, [&](SavedState& state) {
        std::erase(state.covered, slot);
        if (isCovered)
            state.covered.push_back(slot);
    });
}

} // namespace axiscomp
