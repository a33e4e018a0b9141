// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/write/flash_account.h"
#include "core/write/write_planner.h"

namespace axiscomp {

class UnfinishedWrite;
enum class UnfinishedOutcome;

/// Carries a prepared write out in the safe order and puts everything back when a step fails or the
/// user stops (docs/architecture.md, "The safe order of a write"; DECISIONS.md, 3). Used once.
class WriteProcedure {
public:
    /// earlier: the axis's journal, when a write before did not end. This one takes its place, and
    /// gives it back when it has to be undone.
    WriteProcedure(const RegisterAccess& access, DriveStore& store, SourceDirectory& sources,
        std::function<WallTime()> clock, PreparedWrite prepared,
        std::optional<JournalEntry> earlier = {});

    [[nodiscard]] Result<WriteReport> run();
    /// The same, as the end of the earlier write: undoing still leads to the state before that.
    [[nodiscard]] Result<WriteReport> finishEarlier();
    /// Only the way back of the earlier write, whose decisions the prepared write has.
    [[nodiscard]] Result<WriteReport> recoverOldState(const UnfinishedWrite& unfinished);
    /// The flash operations that this costs at most; changes nothing.
    [[nodiscard]] Result<int> costOfRecovery(const UnfinishedWrite& unfinished);

private:
    // In the order in which they run.
    [[nodiscard]] Result<void> keepOldState();
    [[nodiscard]] Result<void> checkUnchanged();
    [[nodiscard]] std::vector<std::string> lastLookPaths() const;
    void noteEraseCounts(const Readings& now);
    [[nodiscard]] Result<void> checkSlot(const Readings& now) const;
    [[nodiscard]] Result<void> checkBackup(const Readings& now) const;
    [[nodiscard]] Result<void> change();
    [[nodiscard]] Result<void> release();
    [[nodiscard]] Result<void> switchOff();
    [[nodiscard]] Result<void> uploadTable();
    [[nodiscard]] Result<void> commitTable();
    [[nodiscard]] Result<void> commitWith(const std::vector<RegisterWrite>& values);
    [[nodiscard]] Result<void> reachFlash(
        const std::vector<RegisterWrite>& values, bool& isCommitted);
    [[nodiscard]] bool mustSpendFlash() const;
    [[nodiscard]] Result<void> recordSpent(int assumed, const Result<void>& outcome);
    [[nodiscard]] Result<void> deleteOldTable();
    [[nodiscard]] Result<void> switchOver();
    [[nodiscard]] Result<void> switchOverOneByOne(const std::vector<RegisterWrite>& values);
    [[nodiscard]] Result<AxisStatus> confirm();
    [[nodiscard]] Result<WriteReport> finish(AxisStatus now);

    // Putting back, in reverse order.
    [[nodiscard]] Error rollBack(const Error& reason);
    [[nodiscard]] Error notUndone(
        const RegisterAccess& access, const Error& reason, const Error& obstacle) const;
    [[nodiscard]] Result<UnfinishedOutcome> heldState(const RegisterAccess& access) const;
    [[nodiscard]] Result<void> checkUndoable() const;
    [[nodiscard]] bool mayBeHalfWay() const;
    [[nodiscard]] Error otherDrive(const Error& reason, const Error& other) const;
    [[nodiscard]] Result<void> undo(const RegisterAccess& access);
    [[nodiscard]] Result<void> putBack(const RegisterAccess& access);
    [[nodiscard]] Result<AxisStatus> confirmOldState(const RegisterAccess& access) const;
    void accountForUndo(const RegisterAccess& access, const Result<void>& undone);
    [[nodiscard]] Result<void> rollBackTable(const RegisterAccess& access);
    [[nodiscard]] Result<void> undoRegisters(const RegisterAccess& access);
    [[nodiscard]] Result<void> undoOtherSlot(const RegisterAccess& access);
    [[nodiscard]] bool mustStay(const RegisterAccess& access) const;
    [[nodiscard]] bool hasOldState(const RegisterAccess& access);
    [[nodiscard]] Result<void> takeUp(const UnfinishedWrite& unfinished);
    [[nodiscard]] Result<int> costOfUndo();
    [[nodiscard]] Result<AxisStatus> inspectBeforeRecovery(const UnfinishedWrite& unfinished);
    [[nodiscard]] Result<AxisBackup> keepPresent(std::vector<std::string> slots);

    [[nodiscard]] Result<void> save(const RegisterAccess& access);
    [[nodiscard]] Result<void> note(const std::string& step, double progress);
    [[nodiscard]] Result<void> closeJournal();
    [[nodiscard]] std::vector<std::string> touchedSlots() const;
    [[nodiscard]] bool isNewTable() const { return !m_write.file.empty(); }
    [[nodiscard]] bool deletes() const { return !m_write.plan.deletedSlot.empty(); }
    /// The table of a slot that the axis does not use now.
    [[nodiscard]] bool deletesUnused() const
    {
        return deletes() && m_write.plan.deletedSlot != m_write.plan.before.slot;
    }
    [[nodiscard]] bool overwritesOwn() const;
    [[nodiscard]] bool switchesOff() const;
    [[nodiscard]] bool wantsPersistent() const;
    [[nodiscard]] bool changesPersistency() const;
    [[nodiscard]] bool commitsOnSwitch() const;
    [[nodiscard]] std::vector<RegisterWrite> persistencyWrites() const;
    [[nodiscard]] const AxisBackup::File* backupOf(const std::string& slot) const;
    [[nodiscard]] Error outcome(ErrorCode code, const Error& reason, Text rollback) const;

    RegisterAccess m_access;
    DriveStore& m_store;
    SourceDirectory& m_sources;
    std::function<WallTime()> m_clock;
    PreparedWrite m_write;
    AxisBackup m_backup;
    std::filesystem::path m_backupFile;
    JournalEntry m_journal;
    std::optional<JournalEntry> m_earlier;
    bool m_finishesEarlier = false;
    FlashAccount m_flash;
    EraseCounts m_eraseCounts; ///< of the touched slots, before the first change

    // What may have been changed on the drive so far, and so has to be put back.
    bool m_slotTouched = false;
    bool m_flashTouched = false;
    bool m_registersTouched = false;
    bool m_savedTouched = false;
    bool m_isComplete = false; ///< every step was taken and read back, and none is put back yet
};

} // namespace axiscomp
