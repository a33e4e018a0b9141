// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/compensation_setup.h"
#include "core/store/drive_store.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <chrono>
#include <cstdint>
#include <string>

namespace axiscomp::test {

/// As if the program had been killed at this step of the persistent write to axis 0 that has
/// brought the setup about.
[[nodiscard]] inline Result<void> openJournalOf(DriveStore store, drivecomm::VirtualDrive& drive,
    std::int32_t serialNumber, const CompensationSetup& setup, const std::string& step)
{
    const std::string base = "Axes[0]/Parameters/Compensations/Axis/";
    JournalEntry entry;
    entry.serialNumber = serialNumber;
    entry.time = WallTime(std::chrono::hours(24 * 365 * 50));
    entry.step = step;
    entry.backup = store.backups(serialNumber, 0).front();
    entry.newRegisters = {{base + "Table", setup.slot}};
    for (std::size_t n = 0; n < setup.sources.size(); ++n)
        entry.newRegisters.push_back(
            {base + "Dim" + std::to_string(n + 1) + "Source", setup.sources[n].address});
    entry.newSlot = setup.slot;
    entry.newCrc = setup.tableCrc;
    entry.persistent = true;
    const TableSlot* slot = drivecomm::genericProfile().slotNamed(setup.slot);
    AXISCOMP_TRY(const auto file, drive.download(slot ? slot->file : std::string()));
    AXISCOMP_TRY(entry.newTable, store.keepTable(serialNumber, entry.axis, file));
    return store.openJournal(entry);
}

} // namespace axiscomp::test
