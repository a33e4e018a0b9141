// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/axis/proof.h"
#include "core/capture/capture_request.h"
#include "core/drive/drive_link.h"
#include "core/drive/drive_profile.h"
#include "core/drive/operation.h"
#include "core/store/drive_store.h"
#include "core/table/compensation_table.h"
#include "core/write/flash_account.h"
#include "core/write/unfinished_write.h"
#include "core/write/write_plan.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

struct AxisWrite;

enum class Switch { Activate, Evaluate, Deactivate };

/// An axis, and registers beside it.
struct WatchedStatus {
    AxisStatus status;
    std::map<std::string, double> values; ///< by path
    /// Why it is not known whether a write did not end: status.unfinishedWrite is empty then.
    std::optional<Error> journalProblem;
};

struct Activation {
    AxisStatus status; ///< in the end
    std::optional<Result<Proof>> proof; ///< none when the compensation was switched off
    bool isPutBack = false; ///< the proof failed, and status is again what it was before

    /// Why nothing is proved although nothing differs, and what to do about it, as a sentence to
    /// warn with; none: it is proved, or the indices are, which is all while it evaluates, or there
    /// is no proof.
    [[nodiscard]] std::optional<Text> notProved() const;
};

/// A table that no axis used when the backup was made, and what bringing it back costs.
struct PlannedFile {
    AxisBackup::File file;
    bool isThere = false; ///< the drive has exactly this file already
    int flashOperations = 0; ///< as in WritePlan
    int flashReserve = 0;
};

/// What restoring a whole drive would write.
struct RestorePlan {
    std::vector<WritePlan> axes; ///< one for each axis of the backup
    std::vector<PlannedFile> files; ///< written after the axes
};

/// What restoring a whole drive has written.
struct RestoreReport {
    std::vector<WriteReport> axes; ///< without those that had everything already
    std::vector<AxisBackup::File> files; ///< likewise
};

/// A table as the drive holds it.
struct HeldTable {
    CompensationTable table; ///< its own name; axis names and units are empty
    Bytes file; ///< the same, byte by byte
};

/// The service: reads and changes the compensation of a drive's axes in the safe order
/// (docs/architecture.md, "The safe order of a write"). Blocking; one instance per link, used on
/// the link's thread. All operations report link errors as DriveLink does; theirs are named at
/// each.
class AxisCompensator {
public:
    /// clock: the wall clock, replaceable for tests. All references must outlive this.
    AxisCompensator(
        DriveLink& link, const DriveProfile& profile, DriveStore& store,
        std::function<WallTime()> clock = [] { return std::chrono::system_clock::now(); });
    ~AxisCompensator();

    [[nodiscard]] const DriveProfile& profile() const;
    [[nodiscard]] Result<DriveIdentity> identify(const OperationOptions& options = {});
    [[nodiscard]] Result<std::vector<AxisInfo>> axes(const OperationOptions& options = {});
    /// An index or a name, as axisAmong takes it. Errors: AxisNotFound, AxisAmbiguous.
    [[nodiscard]] Result<int> findAxis(
        const std::string& indexOrName, const OperationOptions& options = {});
    /// Errors: AxisNotFound, NoCompensation, those of DriveStore::journal.
    [[nodiscard]] Result<AxisStatus> status(int axis, const OperationOptions& options = {});

    /// The same with the values of more registers, read at the same instant as far as the profile
    /// allows; NaN where the drive has no such number. An error of the journal is part of it: who
    /// changes nothing, or only switches off, needs none.
    [[nodiscard]] Result<WatchedStatus> watch(
        int axis, const std::vector<std::string>& registers, const OperationOptions& options = {});

    /// Path, tam:// URI or hex address to a register that exists on this drive and may be a
    /// DimSource. Errors: SourceNotFound (nearest), SourceWrongType, SourceOtherDrive.
    [[nodiscard]] Result<DimSource> resolveSource(
        const std::string& source, const OperationOptions& options = {});
    /// The profile's shortlist for this drive, those that exist.
    [[nodiscard]] Result<std::vector<DimSource>> sourceShortlist(
        const OperationOptions& options = {});

    /// Reads and checks, changes nothing. Errors: SourceMissing, SourceSurplus, SourceRepeated,
    /// SourceMismatch, TargetMismatch, DimensionMismatch, TableTooLarge, SlotNotFound, SlotInUse,
    /// NoTable, FlashWear, ChangedMeanwhile; CompensationActive unless the axis has all of it.
    [[nodiscard]] Result<WritePlan> plan(
        int axis, const WriteRequest& request, const OperationOptions& options = {});
    /// The same while the compensation is active, too: how the axis differs from what was asked
    /// for. Errors: those of plan without CompensationActive.
    [[nodiscard]] Result<WritePlan> compare(
        int axis, const WriteRequest& request, const OperationOptions& options = {});
    /// Plans, backs up, writes, verifies; puts everything back when a step fails or the user stops.
    /// Errors: those of plan, OtherDrive, NothingToWrite, VerifyMismatch, RollbackFailed. After any
    /// error but OutcomeUnknown and RollbackFailed the drive holds the old state.
    [[nodiscard]] Result<WriteReport> write(
        int axis, const WriteRequest& request, const OperationOptions& options = {});
    [[nodiscard]] Result<WriteReport> setPersistency(
        int axis, Persistency persistency, const OperationOptions& options = {});

    /// Wait for the resulting state. The table is read whole and checked before it is used. Errors:
    /// CompensationError, NotHomed, NoTable, InvalidTable; of the first two those of status, too.
    [[nodiscard]] Result<AxisStatus> evaluate(int axis, const OperationOptions& options = {});
    [[nodiscard]] Result<AxisStatus> activate(int axis, const OperationOptions& options = {});
    [[nodiscard]] Result<AxisStatus> deactivate(int axis, const OperationOptions& options = {});

    /// The end-to-end proof, while Active (output and indices) or Evaluating (indices). Errors:
    /// ProofFailed with both numbers, CompensationError when the axis is in neither state.
    [[nodiscard]] Result<Proof> prove(
        int axis, int samples = 5, const OperationOptions& options = {});

    /// Switches the compensation, and proves it unless it is switched off. When the proof fails, or
    /// the user stops it, the state from before is put back, also when it was Evaluating. An error
    /// has "compensation": "unknown" when the drive may have switched and cannot be asked.
    [[nodiscard]] Result<Activation> switchTo(
        int axis, Switch wanted, int samples = 5, const OperationOptions& options = {});

    /// Begins to take the values of a plan, or goes on in their file; what comes of it may be used
    /// with the next instance for the same drive, after a lost connection. The profile must outlive
    /// it. Errors: InvalidArgument, NotHomed, MeasurementState, those of AxisReadings::open,
    /// resolveSource, RunFile::open and of the request's instrument.
    [[nodiscard]] Result<CaptureRun> beginCapture(
        int axis, const CaptureRequest& request, const OperationOptions& options = {});
    /// One reading. now: as CaptureClock has it. Errors: those of CaptureRun::read.
    [[nodiscard]] Result<CaptureNews> readCapture(CaptureRun& run,
        const std::function<std::chrono::nanoseconds()>& now, const OperationOptions& options = {});

    /// That the axis still has the slot, the table and the sources that were read. Errors:
    /// ChangedMeanwhile, OtherDrive, those of status but for the journal, which is not read.
    [[nodiscard]] Result<void> checkUnchanged(
        const AxisStatus& read, const OperationOptions& options = {});

    /// The table that the axis uses, and no mixture of two. Errors: NoTable, those of
    /// checkUnchanged; InvalidTable, also when the drive shows other positions than the layout of
    /// the profile has.
    [[nodiscard]] Result<CompensationTable> readTable(
        int axis, const OperationOptions& options = {});
    /// The table that belongs to a state that was read before; whoever shows or keeps both must
    /// have it from here. Errors: the same, when the axis is not in that state any more.
    [[nodiscard]] Result<CompensationTable> readTable(
        const AxisStatus& status, const OperationOptions& options = {});
    [[nodiscard]] Result<HeldTable> readHeldTable(
        const AxisStatus& status, const OperationOptions& options = {});
    /// The same with its units and its target, as the drive states them (table_of_axis.h). The
    /// journal is not read.
    [[nodiscard]] Result<CompensationTable> readDescribedTable(
        int axis, const OperationOptions& options = {});
    [[nodiscard]] Result<CompensationTable> readDescribedTable(
        const AxisStatus& status, const OperationOptions& options = {});

    [[nodiscard]] Result<std::vector<DriveFile>> files(const OperationOptions& options = {});
    [[nodiscard]] Result<Bytes> download(
        const std::string& path, const OperationOptions& options = {});
    /// The plain file transfer of AN140 5.2: keeps a backup of the old file, uploads, reads back,
    /// compares every byte; puts the old file back when that fails. Gives the backup; an empty path
    /// when the drive held exactly this file already. Errors: UnknownFile when the profile has no
    /// slot there, ChangedMeanwhile, FlashWear, VerifyMismatch, RollbackFailed; OtherDrive when
    /// another serial number answers than the plan's, expectedDrive.
    [[nodiscard]] Result<std::filesystem::path> upload(const std::string& path, ByteView bytes,
        const OperationOptions& options = {}, std::optional<std::int32_t> expectedDrive = {});

    /// What that costs; changes nothing. Errors: UnknownFile.
    [[nodiscard]] Result<UploadPlan> planUpload(
        const std::string& path, ByteView bytes, const OperationOptions& options = {});

    /// What deleting a table that no axis uses costs; changes nothing. The table of an axis is
    /// deleted by write() with deletionRequest(). Errors: SlotNotFound, NoTable when the slot is
    /// empty, SlotInUse, also by an axis after a reboot, FlashWear.
    [[nodiscard]] Result<SlotDeletion> planSlotDeletion(
        const std::string& slot, const OperationOptions& options = {});
    /// Keeps a backup, which it gives, empties the slot, and looks whether it is empty. It is one
    /// command to the drive: whenever it is interrupted, the table is there or not. Errors: those
    /// of planSlotDeletion, ChangedMeanwhile, VerifyMismatch, RollbackFailed; OtherDrive as of
    /// upload.
    [[nodiscard]] Result<std::filesystem::path> deleteSlot(const std::string& slot,
        const OperationOptions& options = {}, std::optional<std::int32_t> expectedDrive = {});

    /// EraseCount of all slots, and what this computer has recorded.
    [[nodiscard]] Result<FlashUse> flashUse(const OperationOptions& options = {});
    /// Whether so many flash operations are possible now, and beside them those that putting back
    /// may cost. Errors: FlashWear.
    [[nodiscard]] Result<void> checkFlash(
        int operations, int reserve, const OperationOptions& options = {});
    /// The user has decided that flash operations which are missing in a damaged record count no
    /// more (DriveStore::FlashHistory::damagedRecord).
    [[nodiscard]] Result<void> resetFlashCount(const OperationOptions& options = {});

    /// Errors: ChangedMeanwhile when another program writes to an axis while it is read, or a file
    /// is not the table that the drive shows; InvalidTable when the drive shows its positions
    /// elsewhere.
    [[nodiscard]] Result<DriveBackup> backup(const OperationOptions& options = {});
    /// The tables of a backup that the profile cannot read, one InvalidTable for each: they are
    /// kept as they are, and restored for no axis. Asks the drive nothing.
    [[nodiscard]] std::vector<Error> unreadableTables(const DriveBackup& backup) const;
    /// All of it is planned first (planRestore). Then a normal verified write per axis, and the
    /// tables that no axis uses, as upload does it; at the end all of it is compared once more.
    /// Errors: those of planRestore, write and upload; SlotInUse, also by an axis after a reboot.
    /// Of one in the middle the context has `written` and `notWritten`, the names of axes and the
    /// slots of those tables, and the axis (`ofAxis`); `lost`: all was written, and is not there.
    [[nodiscard]] Result<RestoreReport> restore(
        const DriveBackup& backup, bool force, const OperationOptions& options = {});

    /// The writes of restore(), one for each axis of the backup; changes nothing. Errors:
    /// OtherDrive unless force, UnknownFile for a table in a slot that the profile does not have.
    [[nodiscard]] Result<std::vector<WriteRequest>> restoreRequests(
        const DriveBackup& backup, bool force, const OperationOptions& options = {});
    /// The tables that no axis uses, as restore() does it after the axes, compared at the end.
    [[nodiscard]] Result<void> restoreFiles(
        const std::vector<AxisBackup::File>& files, const OperationOptions& options = {});

    /// What restoring a whole drive would write; changes nothing. Nothing of it has to be
    /// confirmed, since the drive had it. Errors: those of restoreRequests and planMultiAxis.
    [[nodiscard]] Result<RestorePlan> planRestore(
        const DriveBackup& backup, bool force, const OperationOptions& options = {});

    /// What restoring one axis would write; changes nothing. Nothing of it has to be confirmed,
    /// since the drive had it. Errors: OtherDrive unless force, and those of plan.
    [[nodiscard]] Result<WritePlan> planRestore(
        const AxisBackup& backup, bool force, const OperationOptions& options = {});

    using UnfinishedOutcome = axiscomp::UnfinishedOutcome;
    using Recovery = axiscomp::Recovery;
    /// Which state the drive holds after an unfinished write; forgets that write when it is the new
    /// one completely. Errors: OtherDrive.
    [[nodiscard]] Result<UnfinishedOutcome> settleUnfinished(
        const JournalEntry& entry, const OperationOptions& options = {});

    /// What can be done about an unfinished write; changes nothing.
    [[nodiscard]] Result<Recovery> recovery(
        const JournalEntry& entry, const OperationOptions& options = {});
    /// A normal write that brings about the complete new state, from whatever the interruption
    /// left. After an error the write is still unfinished, and can still be undone. Errors: those
    /// of write, OtherDrive, NothingUnfinished, TableNotKept, ChangedMeanwhile when the journal is
    /// not this entry any more; TargetMismatch and UnitMismatch when the axis has another name, or
    /// it or a source another unit, than when the write began.
    [[nodiscard]] Result<WriteReport> finishUnfinished(
        const JournalEntry& entry, const OperationOptions& options = {});
    /// Brings back the complete state before the unfinished write, verified, with a backup of what
    /// there is now. Errors: as finishUnfinished; SlotInUse when something has come to use the old
    /// table's slot.
    [[nodiscard]] Result<WriteReport> undoUnfinished(
        const JournalEntry& entry, const OperationOptions& options = {});

private:
    [[nodiscard]] Result<RestorePlan> planRestorations(const DriveBackup& backup,
        std::span<const AxisWrite> writes, const OperationOptions& options);
    /// Files of slots that no axis uses are stored after the tables of the axes.
    [[nodiscard]] Result<std::vector<PlannedFile>> planFiles(const DriveBackup& backup,
        const std::vector<WritePlan>& plans, const OperationOptions& options);

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp
