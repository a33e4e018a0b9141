// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensation_setup.h"
#include "core/drive_link.h"
#include "core/flash_wear.h"
#include "core/local_file.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

/// What one axis had before a write: its registers, and the files of the slots that the write
/// touches.
struct AxisBackup {
    DriveIdentity drive;
    int axis = 0;
    std::string axisName;
    WallTime time{};
    std::vector<RegisterWrite> registers; ///< Table, Dim1Source .. Dim3Source
    struct File {
        std::string slot;
        std::string path;
        Bytes bytes; ///< empty: the slot was empty
        bool persistent = false;
        friend bool operator==(const File&, const File&) = default;
    };
    std::vector<File> files;
};

/// Everything the program can change on a drive (`axiscomp backup`): one AxisBackup per axis.
struct DriveBackup {
    std::vector<AxisBackup> axes;
};
/// JSON, tables as base64; InvalidBackup names the JSON path of a fault.
[[nodiscard]] std::string writeBackup(const DriveBackup& backup);
[[nodiscard]] Result<DriveBackup> readBackup(std::string_view text, const std::string& fileName);

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
};

/// What the program remembers about drives across runs and programs: backups, journal, flash
/// history and which table it put into which slot. One folder per drive serial number, files saved
/// atomically, shared by several programs under a lock file.
class DriveStore {
public:
    explicit DriveStore(std::filesystem::path root);
    /// $XDG_STATE_HOME/axiscomp, ~/.local/state/axiscomp
    [[nodiscard]] static std::filesystem::path defaultRoot();

    /// One dated file per call, parsed back before it counts; the newest 50 of the axis are kept.
    [[nodiscard]] Result<std::filesystem::path> saveBackup(const AxisBackup& backup);

    [[nodiscard]] Result<void> openJournal(const JournalEntry& entry);
    [[nodiscard]] Result<void> closeJournal(std::int32_t serialNumber, int axis);
    [[nodiscard]] Result<std::optional<JournalEntry>> journal(std::int32_t serialNumber, int axis);

    /// Flash operations of a drive that still count, and the number ever recorded.
    struct FlashHistory {
        std::vector<WallTime> recent;
        std::uint64_t total = 0;
    };
    [[nodiscard]] Result<FlashHistory> flashHistory(std::int32_t serialNumber);
    [[nodiscard]] Result<void> recordFlash(std::int32_t serialNumber, WallTime now, int operations);

    /// The slot and element CRC of tables that this program wrote for an axis, newest first: such a
    /// slot may be taken again when its content is still the same (DESIGN, "Slots are taken in
    /// turn").
    struct OwnTable {
        std::string slot;
        std::uint32_t crc = 0;
    };
    [[nodiscard]] Result<std::vector<OwnTable>> ownTables(std::int32_t serialNumber, int axis);
    [[nodiscard]] Result<void> recordOwnTable(
        std::int32_t serialNumber, int axis, const OwnTable& table);

private:
    std::filesystem::path m_root;
};

} // namespace axiscomp
