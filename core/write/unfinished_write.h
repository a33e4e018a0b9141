// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/error.h"
#include "core/base/result.h"
#include "core/drive/drive_link.h"
#include "core/drive/journal_entry.h"
#include "core/store/backup.h"
#include "core/write/write_plan.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

class RegisterAccess;
class DriveStore;
struct PreparedWrite;
struct SlotState;

/// Which state the drive holds after a write that did not end.
enum class UnfinishedOutcome {
    Old, ///< complete, whatever lies in the slot that the write had chosen
    New,
    NewUnsaved, ///< new, but the parameters may not be saved
    Neither,
    Unknown, ///< not the new one; the backup of the old one cannot be read
};

/// What can be done about it.
struct Recovery {
    /// The backup of the old state: then neither is possible, and only the next write, or restoring
    /// another backup, puts an end to it.
    bool isBackupUnread = false;
    std::optional<Error> finishObstacle; ///< none: finishUnfinished is possible now
    std::optional<Error> undoObstacle; ///< none: undoUnfinished is possible now
    int finishFlashOperations = 0; ///< that finishing costs
    int undoFlashOperations = 0; ///< that undoing costs at most
    std::vector<Text> doubts; ///< of either way: what cannot be told for sure (RestoredAxis)
};

/// A write that did not end, with what was kept before its first change.
class UnfinishedWrite {
public:
    /// Errors: FileNotReadable, FileTooLarge, InvalidBackup.
    [[nodiscard]] static Result<UnfinishedWrite> load(
        const RegisterAccess& access, const JournalEntry& entry);

    [[nodiscard]] const JournalEntry& entry() const { return m_entry; }
    [[nodiscard]] const AxisBackup& before() const { return m_before; }
    /// What the axis has when the write is complete, as a backup would keep it. Errors:
    /// TableNotKept, FileNotReadable.
    [[nodiscard]] Result<AxisBackup> after(const DriveStore& store) const;
    [[nodiscard]] std::string oldSlot() const; ///< empty: the axis had no table
    /// The old table; null: the axis had none.
    [[nodiscard]] const AxisBackup::File* oldFile() const { return fileOf(oldSlot()); }
    [[nodiscard]] std::uint32_t oldCrc() const; ///< of its elements
    /// Otherwise the axis keeps its table, or loses it.
    [[nodiscard]] bool isNewTable() const;

    /// The write that brings the complete new state about, from whatever there is now. Errors:
    /// TableNotKept, FileNotReadable, InvalidTable, SourceMissing; ChangedMeanwhile when what it
    /// would delete is somebody else's by now.
    [[nodiscard]] Result<WriteRequest> request(DriveStore& store, const DriveIdentity& drive) const;
    /// A deletion of what only a reboot would have brought back has overwritten saved parameters
    /// that were never read. Errors: NotUndoable.
    [[nodiscard]] Result<void> checkUndoable() const;
    /// What that write had decided, as far as undoing it needs.
    [[nodiscard]] PreparedWrite prepared(const DriveIdentity& drive) const;

    /// Whether a slot holds what this write found there or put there, or nothing.
    [[nodiscard]] bool isKnown(const SlotState& state, const std::string& slot) const;

private:
    UnfinishedWrite(const RegisterAccess& access, const JournalEntry& entry)
        : m_access(access)
        , m_entry(entry)
    {
    }
    [[nodiscard]] const AxisBackup::File* fileOf(const std::string& slot) const;
    [[nodiscard]] Result<Bytes> newFile(const DriveStore& store) const;
    [[nodiscard]] std::vector<std::string> unitsOfBackup() const;
    [[nodiscard]] Result<void> checkDeletable(const DriveIdentity& drive) const;
    [[nodiscard]] Result<std::optional<std::string>> slotFor(
        DriveStore& store, const DriveIdentity& drive) const;

    const RegisterAccess& m_access;
    JournalEntry m_entry;
    AxisBackup m_before;
};

/// The steps of a write in their order; a journal's step that is not known counts as the last.
[[nodiscard]] int stepRank(std::string_view step);

} // namespace axiscomp
