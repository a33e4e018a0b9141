// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_profile.h"
#include "core/table/lookup.h"
#include "core/table/tam_table.h"

#include <chrono>
#include <memory>
#include <vector>

namespace axiscomp::drivecomm {

/// Simulated time since power-on.
using DriveTime = std::chrono::nanoseconds;

/// A table file as the drive holds it; never changed, so that copies are cheap and a lookup keeps
/// the table it began with.
struct StoredTable {
    Bytes bytes;
    std::uint32_t crc = 0; ///< of the element bytes
    CompensationTable table;
    std::optional<Lookup> lookup; ///< none: the file is damaged
};

/// A file that decodes. Errors: those of decodeTamTable.
[[nodiscard]] Result<std::shared_ptr<const StoredTable>> storedTable(
    Bytes bytes, const TableLayout& layout);
/// A file from flash, which may be damaged.
[[nodiscard]] std::shared_ptr<const StoredTable> possiblyDamagedTable(
    Bytes bytes, const TableLayout& layout);

/// What one table slot holds.
struct SlotMemory {
    std::shared_ptr<const StoredTable> ram; ///< null: empty
    std::shared_ptr<const StoredTable> flash; ///< null: empty
    bool persistent = false; ///< as the header in RAM says
    std::uint32_t eraseCount = 0;
};

/// RAM and flash of all table slots, and the wear of the flash. Cheap to copy: a request is tried
/// on a copy and taken over when all of it went well.
class FlashMemory {
public:
    /// profile must outlive this.
    explicit FlashMemory(const DriveProfile& profile);

    [[nodiscard]] std::size_t slotCount() const { return m_slots.size(); }
    [[nodiscard]] const SlotMemory& slot(std::size_t index) const { return m_slots.at(index); }

    /// A file that was written: into RAM, and into flash too when its header says persistent.
    /// Errors: FlashWear.
    [[nodiscard]] Result<void> upload(std::size_t index, std::shared_ptr<const StoredTable> table,
        bool persistent, DriveTime now);
    /// Changes the header in RAM. Errors: DriveRejected for an empty slot.
    [[nodiscard]] Result<void> setPersistent(std::size_t index, bool persistent);
    /// Brings flash in line with RAM: stored when persistent, erased when not. Costs no operation
    /// when flash is so already. Errors: DriveRejected for an empty slot, FlashWear.
    [[nodiscard]] Result<void> commit(std::size_t index, DriveTime now);
    /// Empties RAM and flash. Errors: FlashWear.
    [[nodiscard]] Result<void> erase(std::size_t index, DriveTime now);
    /// RAM is lost, flash is loaded.
    void reboot();

    /// When one more operation is possible.
    [[nodiscard]] DriveTime availableFrom(DriveTime now) const;
    /// Changes with every flash operation.
    [[nodiscard]] std::uint64_t operationCount() const { return m_operationCount; }
    /// Those that still count, oldest first.
    [[nodiscard]] const std::vector<DriveTime>& operations() const { return m_operations; }

    /// Flash as it was saved in an earlier run; RAM is loaded from it.
    void restore(
        std::size_t index, std::shared_ptr<const StoredTable> flash, std::uint32_t eraseCount);
    void restoreOperations(std::vector<DriveTime> operations);

private:
    [[nodiscard]] Result<void> useFlash(SlotMemory& slot, DriveTime now);

    const DriveProfile* m_profile;
    std::vector<SlotMemory> m_slots;
    std::vector<DriveTime> m_operations;
    std::uint64_t m_operationCount = 0;
};

} // namespace axiscomp::drivecomm
