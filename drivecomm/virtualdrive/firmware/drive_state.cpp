// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/virtual_drive_p.h"

#include <algorithm>

namespace axiscomp::drivecomm {

Result<void> VirtualDrive::Private::openState()
{
    Result<std::unique_ptr<StateFolder>> opened = StateFolder::open(options.stateFolder);
    if (!opened)
        return fail(opened.error());
    folder = *std::move(opened);
    Result<std::optional<SavedDrive>> saved = folder->load();
    if (!saved)
        return fail(saved.error());
    return *saved ? restore(**saved) : Result<void>{};
}

Result<void> VirtualDrive::Private::restore(const SavedDrive& saved)
{
    const auto unusable = [&](Text reason) {
        return fail(ErrorCode::FileNotReadable,
            {{"file", folder->mainFile().string()}, {"reason", std::move(reason)}});
    };
    if (saved.serialNumber != options.serialNumber)
        return unusable(AXISCOMP_TEXT(
            "Error", "it is the state of the drive with serial number {found}, not of {expected}")
                            .with("found", saved.serialNumber)
                            .with("expected", options.serialNumber));
    for (const auto& [name, slot] : saved.slots) {
        const auto found = std::ranges::find(profile.tableSlots, name, &TableSlot::name);
        if (found == profile.tableSlots.end())
            return unusable(AXISCOMP_TEXT("Error", "the profile {profile} has no slot {slot}")
                                .with("profile", profile.name)
                                .with("slot", name));
        if (slot.table && slot.table->size() > found->maximumSize)
            return unusable(AXISCOMP_TEXT("Error", "the table in {slot} is larger than the slot")
                                .with("slot", name));
        memory.restore(static_cast<std::size_t>(found - profile.tableSlots.begin()),
            slot.table ? possiblyDamagedTable(*slot.table, profile.layout) : nullptr,
            slot.eraseCount);
    }
    for (const auto& [path, value] : saved.parameters) {
        Register* target = tree.find(path);
        if (target == nullptr || !target->isParameter())
            continue; // of a configuration with other axes or registers
        Result<RegisterValue> kept = fitted(*target, value);
        if (!kept)
            return unusable(textOf(kept.error()));
        target->value = target->saved = *std::move(kept);
    }
    const auto off = std::max<std::chrono::nanoseconds>(
        options.wallClock() - saved.savedAt, std::chrono::nanoseconds(0));
    std::vector<DriveTime> operations;
    for (const std::chrono::nanoseconds age : saved.operationAges)
        operations.push_back(now - off - age);
    memory.restoreOperations(std::move(operations));
    return {};
}

SavedDrive VirtualDrive::Private::snapshot(
    const FlashMemory& trial, const std::vector<Change>& changes) const
{
    SavedDrive result;
    result.serialNumber = options.serialNumber;
    result.savedAt = options.wallClock();
    for (const DriveTime operation : trial.operations())
        result.operationAges.push_back(now - operation);
    for (std::size_t i = 0; i < trial.slotCount(); ++i) {
        const SlotMemory& slot = trial.slot(i);
        SavedDrive::Slot& saved = result.slots[profile.tableSlots[i].name];
        saved.eraseCount = slot.eraseCount;
        if (slot.flash)
            saved.table = {slot.flash, &slot.flash->bytes};
    }
    const bool saves = savesParameters(changes);
    for (const Register& one : tree) {
        if (!one.isParameter())
            continue;
        const auto change = std::ranges::find(changes, &one, &Change::target);
        const RegisterValue& after = change == changes.end() ? one.value : change->value;
        const RegisterValue& kept = saves ? after : one.saved;
        if (kept != one.factory)
            result.parameters.emplace(one.path, kept);
    }
    return result;
}

} // namespace axiscomp::drivecomm
