// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/parameter_saving.h"

#include "core/axis/verified_transfer.h"

#include <algorithm>

namespace axiscomp {

namespace {

using Use = SavedState::Use;

/// What the parameters name, and which of those slots hold a volatile table.
struct NamedSlots {
    std::vector<Use> uses;
    std::vector<std::string> volatileSlots;
};

Result<NamedSlots> readNamed(const RegisterAccess& access, const DriveIdentity& drive)
{
    const RegisterPaths& registers = access.registers();
    std::vector<std::string> paths;
    for (int axis = 0; axis < drive.axes; ++axis)
        paths.push_back(access.axisPath(registers.table, axis));
    for (const TableSlot& slot : access.profile().tableSlots)
        for (const std::string& pattern :
            {registers.tableElements, registers.tableCrc, registers.tablePersistent})
            paths.push_back(access.slotPath(pattern, slot.name));
    AXISCOMP_TRY(auto readings, access.readAvailable(std::move(paths)));
    NamedSlots named;
    for (int axis = 0; axis < drive.axes; ++axis) {
        const std::string slot = textAt(readings, access.axisPath(registers.table, axis));
        if (!access.profile().slotNamed(slot))
            continue;
        const auto at = [&](const std::string& pattern) { return access.slotPath(pattern, slot); };
        const bool isEmpty = unsignedAt(readings, at(registers.tableElements)) == 0;
        const std::uint32_t crc = isEmpty ? 0 : unsignedAt(readings, at(registers.tableCrc));
        named.uses.push_back({axis, slot, crc});
        if (!isEmpty && numberAt(readings, at(registers.tablePersistent)) != 1.0)
            named.volatileSlots.push_back(slot);
    }
    return named;
}

bool hasEqual(const EraseCounts& before, const EraseCounts& after)
{
    return std::ranges::any_of(before, [&](const auto& count) {
        const auto now = after.find(count.first);
        return now != after.end() && now->second == count.second;
    });
}

/// Committing a volatile table empties its slot's flash.
Result<void> uncover(const RegisterAccess& access, DriveStore& store, const DriveIdentity& drive,
    FlashAccount& flash, EraseCounts& counts, const std::vector<std::string>& slots)
{
    AXISCOMP_TRY(auto before, readEraseCounts(access, slots));
    std::vector<RegisterWrite> commits;
    for (const std::string& slot : slots)
        commits.push_back({access.slotPath(access.registers().tableCommand, slot),
            access.enums().tableCommandCommit});
    auto done = writeVerified(access, {}, commits);
    if (!done) {
        flash.noteRefusal(done.error());
        if (!mayHaveSpentFlash(done.error()))
            return done;
    }
    auto after = readEraseCounts(access.withoutStop(), slots);
    // A commit that did nothing is repeated, which costs nothing when there was nothing to do.
    if (done && after && hasEqual(before, *after)) {
        done = writeVerified(access, {}, commits);
        after = readEraseCounts(access.withoutStop(), slots);
    }
    flash.record(before, after.value_or(EraseCounts{}), 1);
    for (const std::string& slot : slots) {
        // What was spent before this is still to be recorded by the caller.
        if (after && after->contains(slot) && before.contains(slot) && counts.contains(slot))
            counts[slot] += after->at(slot) - before.at(slot);
        if (done)
            if (auto forgot = store.recordCovered(drive.serialNumber, slot, false); !forgot)
                return forgot;
    }
    return done;
}

} // namespace

Result<int> costOfSaving(
    const RegisterAccess& access, DriveStore& store, const DriveIdentity& drive)
{
    AXISCOMP_TRY(auto named, readNamed(access, drive));
    AXISCOMP_TRY(auto state, store.savedState(drive.serialNumber));
    return static_cast<int>(std::ranges::count_if(
        named.volatileSlots, [&](const std::string& slot) { return state.isCovered(slot); }));
}

Result<void> saveParameters(const RegisterAccess& access, DriveStore& store,
    const DriveIdentity& drive, FlashAccount& flash, EraseCounts& counts)
{
    AXISCOMP_TRY(auto named, readNamed(access, drive));
    AXISCOMP_TRY(auto state, store.savedState(drive.serialNumber));
    std::vector<std::string> covering = std::move(named.volatileSlots);
    std::erase_if(covering, [&](const std::string& slot) { return !state.isCovered(slot); });
    if (!covering.empty())
        if (auto done = uncover(access, store, drive, flash, counts, covering); !done)
            return done;
    if (auto recorded = store.recordSaving(drive.serialNumber, named.uses); !recorded)
        return recorded;
    if (auto saved = saveParameters(access); !saved)
        return saved;
    // A drive that restarted in between has saved what it had saved before: then nothing of it is
    // forgotten. Not to forget costs a slot, not more.
    const auto after = readNamed(access.withoutStop(), drive);
    if (after && after->uses == named.uses)
        (void)store.recordSaved(drive.serialNumber, named.uses);
    return {};
}

} // namespace axiscomp
