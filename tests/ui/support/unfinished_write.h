// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/controller_fixture.h"

namespace axiscomp::test {

/// As if the program had been killed before the last step of the persistent 2D write that has just
/// ended: the drive has the new state, the journal is open.
[[nodiscard]] inline Result<void> reopenWrite(ControllerFixture& bench)
{
    const CompensationSetup setup = bench->setup().baseline();
    const std::string base = "Axes[0]/Parameters/Compensations/Axis/";
    DriveStore store = bench.store();
    JournalEntry entry;
    entry.serialNumber = 4711;
    entry.time = WallTime(std::chrono::hours(24 * 365 * 50));
    entry.step = "save";
    entry.backup = store.backups(4711, 0).front();
    entry.newRegisters = {{base + "Table", setup.slot},
        {base + "Dim1Source", setup.sources[0].address},
        {base + "Dim2Source", setup.sources[1].address}, {base + "Dim3Source", std::uint32_t{0}}};
    entry.newSlot = setup.slot;
    entry.newCrc = setup.tableCrc;
    entry.persistent = true;
    const TableSlot* slot = drivecomm::genericProfile().slotNamed(setup.slot);
    const auto file = bench.drive().drive.download(slot ? slot->file : std::string());
    if (!file)
        return fail(file.error());
    auto kept = store.keepTable(entry.serialNumber, entry.axis, *file);
    if (!kept)
        return fail(kept.error());
    entry.newTable = *kept;
    return store.openJournal(entry);
}

} // namespace axiscomp::test
