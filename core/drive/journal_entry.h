// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"
#include "core/drive/register_value.h"
#include "core/table/table_units.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

/// A write that has begun: kept from before its first change until it has ended.
struct JournalEntry {
    std::int32_t serialNumber = 0;
    int axis = 0;
    WallTime time{};
    std::string step; ///< the last step that was begun: "upload", "switch", "commit", ...
    std::filesystem::path backup; ///< the AxisBackup file
    std::vector<RegisterWrite> newRegisters; ///< what the axis has when the write is complete
    std::string newSlot;
    std::uint32_t newCrc = 0; ///< of the new table's elements
    bool persistent = false;
    /// The new table's file, kept beside the journal: with it the write can be finished.
    struct KeptTable {
        std::filesystem::path file;
        std::uint64_t size = 0; ///< bytes
        std::uint32_t crc = 0; ///< CRC-32 of all bytes
        friend bool operator==(const KeptTable&, const KeptTable&) = default;
    };
    std::optional<KeptTable>
        newTable{}; ///< none: the write keeps the table, or did not keep a file
    /// The axis's table is deleted: when the write is complete this slot is empty and the axis uses
    /// none; persistent then says that the parameters are saved. Empty: nothing is deleted.
    std::string deletedSlot{};
    /// In which units the drive took the new table; empty: older programs did not note them.
    TableUnits newUnits{};
    /// The registers whose addresses the new sources are, dimension by dimension; empty: not known.
    std::vector<std::string> newSourcePaths{};

    friend bool operator==(const JournalEntry&, const JournalEntry&) = default;
};

} // namespace axiscomp
