// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/base/wall_time.h"
#include "core/drive/flash_wear.h"
#include "core/drive/journal_entry.h"
#include "core/io/file_lock.h"
#include "core/store/backup.h"
#include "core/store/measured_figures.h"
#include "core/store/saved_state.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

class StoreDatabase;

/// What the program remembers about drives across runs and programs: backups, journal, flash
/// history, which table it put into which slot, and what a reboot brings back. The database
/// axiscomp.db of the state folder, shared by several programs, and files beside it: backups and
/// the tables of unfinished writes, in a folder for each drive's serial number. All of it is made
/// when something is kept; files of versions before the database are taken over. Times come from
/// the caller.
///
/// A damaged database is set aside (axiscomp.db.damaged-TIME), and what can be read of it stays:
/// see FlashHistory::damagedRecord.
///
/// Errors of all: FileNotReadable, FileNotWritable (also when another program is using it for
/// longer than lockWait). A change that failed has changed nothing.
class DriveStore {
public:
    /// lockWait: how long an operation waits for another program's.
    explicit DriveStore(
        std::filesystem::path root, std::chrono::milliseconds lockWait = std::chrono::seconds{5});
    ~DriveStore();
    DriveStore(DriveStore&& other) noexcept;
    /// $XDG_STATE_HOME/axiscomp, ~/.local/state/axiscomp
    [[nodiscard]] static std::filesystem::path defaultRoot();

    /// One dated file per call, parsed back before it counts. The newest 50 of the axis are kept,
    /// and always this one and the one that the axis's journal names. otherFiles: restored into
    /// their slots, as those of DriveBackup.
    [[nodiscard]] Result<std::filesystem::path> saveBackup(
        const AxisBackup& backup, const std::vector<AxisBackup::File>& otherFiles = {});
    /// The same for a file that no axis uses: a DriveBackup with that file alone.
    [[nodiscard]] Result<std::filesystem::path> saveBackup(
        const DriveIdentity& drive, WallTime time, const AxisBackup::File& file);
    /// The files that saveBackup left for the axis, newest first; empty when there are none.
    [[nodiscard]] std::vector<std::filesystem::path> backups(
        std::int32_t serialNumber, int axis) const;

    /// Keeps a table file for the axis's journal, until that is closed.
    [[nodiscard]] Result<JournalEntry::KeptTable> keepTable(
        std::int32_t serialNumber, int axis, ByteView bytes);
    /// Errors: FileNotReadable, also when it is not what was kept.
    [[nodiscard]] Result<Bytes> keptTable(const JournalEntry::KeptTable& table) const;
    /// Replaces the axis's entry.
    [[nodiscard]] Result<void> openJournal(const JournalEntry& entry);
    /// Removes the tables that were kept for it too.
    [[nodiscard]] Result<void> closeJournal(std::int32_t serialNumber, int axis);
    /// A damaged journal of an older version is FileNotReadable with what to do about it: what it
    /// knew about a write that did not end must not be lost unnoticed.
    [[nodiscard]] Result<std::optional<JournalEntry>> journal(std::int32_t serialNumber, int axis);

    /// The drive's last 1000 flash operations in the order in which they were recorded (which of
    /// them still count is for FlashWearGuard to say), and the number ever recorded.
    struct FlashHistory {
        std::vector<WallTime> recent;
        std::uint64_t total = 0;
        /// The last time that the drive itself reported wear.
        struct Refusal {
            WallTime time{};
            std::chrono::seconds wait{0};
            friend bool operator==(const Refusal&, const Refusal&) = default;
        };
        std::optional<Refusal> refusal{};
        /// The record was damaged and is kept in this file: operations may be missing above, and
        /// count as used up until acceptFlashLoss.
        std::optional<std::filesystem::path> damagedRecord{};
        friend bool operator==(const FlashHistory&, const FlashHistory&) = default;
    };
    [[nodiscard]] Result<FlashHistory> flashHistory(std::int32_t serialNumber);
    [[nodiscard]] Result<void> recordFlash(std::int32_t serialNumber, WallTime now, int operations);
    /// So that neither another program nor the next start runs into it again.
    [[nodiscard]] Result<void> recordFlashRefusal(
        std::int32_t serialNumber, WallTime now, std::chrono::seconds wait);
    /// The user has decided that what is missing in the drive's damaged record counts no more.
    [[nodiscard]] Result<void> acceptFlashLoss(std::int32_t serialNumber);

    /// The slot and element CRC of tables that this program wrote for an axis, newest first: such a
    /// slot may be taken again when its content is still the same (docs/architecture.md,
    /// "Slots are taken in turn"). The last 4 of each slot are remembered, so that a slot is still
    /// known when a write was undone; the same table in the same slot belongs to the axis that
    /// wrote it last.
    struct OwnTable {
        std::string slot;
        std::uint32_t crc = 0;
        friend bool operator==(const OwnTable&, const OwnTable&) = default;
    };
    [[nodiscard]] Result<std::vector<OwnTable>> ownTables(std::int32_t serialNumber, int axis);
    [[nodiscard]] Result<void> recordOwnTable(
        std::int32_t serialNumber, int axis, const OwnTable& table);

    /// Kept by the CRC of the table: the last 50 of each axis. Replaces what was kept for it, where
    /// takesPlaceOf says so.
    [[nodiscard]] Result<void> recordMeasured(std::int32_t serialNumber, int axis,
        const MeasuredFigures& measured, Measuring measuring = Measuring::New);
    /// nullopt: nothing was measured with this table, as far as this computer knows.
    [[nodiscard]] Result<std::optional<MeasuredFigures>> measured(
        std::int32_t serialNumber, int axis, std::uint32_t crc);

    [[nodiscard]] Result<SavedState> savedState(std::int32_t serialNumber);
    /// The parameters are about to be saved: what they named before stays until recordSaved.
    [[nodiscard]] Result<void> recordSaving(
        std::int32_t serialNumber, const std::vector<SavedState::Use>& uses);
    [[nodiscard]] Result<void> recordSaved(
        std::int32_t serialNumber, const std::vector<SavedState::Use>& uses);
    [[nodiscard]] Result<void> recordCovered(
        std::int32_t serialNumber, const std::string& slot, bool isCovered);

    /// For the time of a whole write: keeps two programs from writing to one drive at once. None of
    /// the functions above waits for it. Errors: FileNotWritable with missingLock in its context:
    /// nothing was read or written.
    static constexpr std::string_view missingLock = "lock";
    [[nodiscard]] Result<FileLock> lockWrites(std::int32_t serialNumber);
    /// The same without waiting; nullopt while another program is writing.
    [[nodiscard]] Result<std::optional<FileLock>> tryLockWrites(std::int32_t serialNumber);

private:
    std::filesystem::path m_root;
    std::chrono::milliseconds m_lockWait;
    std::unique_ptr<StoreDatabase> m_database;
};

/// What the history says about now.
[[nodiscard]] FlashWearGuard wearGuard(
    const FlashWearLimits& limits, const DriveStore::FlashHistory& history);

} // namespace axiscomp
