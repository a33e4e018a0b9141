// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/compensation_setup.h"
#include "core/drive/drive_link.h"
#include "core/drive/drive_profile.h"
#include "core/drive/flash_wear.h"
#include "core/store/drive_store.h"
#include "core/table/compensation_table.h"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace axiscomp {

struct AxisInfo {
    int index = 0;
    std::string name; ///< may be empty
    std::string unit; ///< the drive's PositionUnit: "Millimeter"
    std::string homing; ///< "HomingDone"
    std::string state; ///< compensation state; empty when the axis has no compensation registers
};

/// The header of the table in the axis's slot, as the drive shows it.
struct TableHeader {
    Grid grid;
    std::uint32_t elements = 0;
    std::uint32_t crc = 0;
    bool persistent = false;
};

/// Everything the drive says about one axis, read at one instant where the profile allows.
struct AxisStatus {
    DriveIdentity drive;
    AxisInfo axis;
    CompensationSetup setup;
    std::optional<TableHeader> table; ///< none: no slot chosen, or the slot is empty
    std::string activation;
    std::string error; ///< the drive's compensation error, "None"
    double output = 0.0; ///< value now added to the encoder position, in position units
    std::array<double, 3> indices{};
    std::array<double, 3> sourceValues{}; ///< of the set sources
    std::string driveError;
    std::optional<JournalEntry> unfinishedWrite; ///< an earlier write that did not end
};

/// How far an operation is: a step in words and a fraction of the whole.
struct Progress {
    std::string step; ///< "verify": an id, translated by the window
    double fraction = 0.0;
};

struct OperationOptions {
    std::chrono::milliseconds timeout{5000}; ///< of each exchange
    std::stop_token stop;
    std::function<void(const Progress&)> progress;
};

/// What a write shall bring about for one axis.
struct WriteRequest {
    int dimensionality = 1;
    std::vector<std::string>
        sources; ///< path, tam:// URI or hex address, one per dimension; empty: keep
    std::optional<CompensationTable> table; ///< none: keep the table that the axis uses
    std::optional<Persistency> persistency; ///< none: keep (a new table is volatile)
    std::optional<std::string> slot; ///< none: chosen
    bool withoutTable = false; ///< the axis shall use none: sources, which may be gaps (""), remain
    std::optional<CompensationSetup> expected; ///< when set: refuse if the drive no longer has this
};

enum class SlotReason { Named, Empty, OwnPrevious, KeepTable, OverwriteOwn };

/// One line of the list shown before a write.
struct PlannedChange {
    std::string field; ///< "Table", "Dim1Source" ..., "Persistency"
    std::string before;
    std::string after;
};

struct WritePlan {
    DriveIdentity drive;
    int axis = 0;
    CompensationSetup before;
    CompensationSetup after;
    SlotReason slotReason = SlotReason::KeepTable;
    std::size_t tableBytes = 0;
    std::vector<PlannedChange> changes; ///< empty: nothing to write
    int flashOperations = 0; ///< that the write costs
    int flashReserve = 0; ///< more that must be possible, so that it can be put back
    FlashBudget flashBudget; ///< before the write
    std::vector<std::string> warnings; ///< sentences
};

struct WriteReport {
    WritePlan plan;
    AxisStatus now; ///< read back after the write
    std::filesystem::path backup;
};

/// What a drive's flash has gone through, and what it may still do now. Wear is per slot.
struct FlashUse {
    FlashBudget budget;
    std::uint64_t operationsRecorded = 0; ///< by this computer, all slots together
    std::string mostUsedSlot; ///< empty: the drive does not count
    std::uint32_t mostCycles = 0; ///< of that slot, whoever spent them
    std::uint64_t allCycles = 0; ///< of all slots that are counted
    std::uint32_t ratedCycles = 0; ///< usual life of one slot, 0: not known
};

/// The drive's own numbers against core's lookup at the same sources.
struct Proof {
    struct Sample {
        std::array<double, 3> sources{};
        double output = 0.0; ///< the drive's
        double expected = 0.0; ///< computed here
        std::array<double, 3> indices{};
        std::array<double, 3> expectedIndices{};
    };
    std::vector<Sample> samples;
    double largestDifference = 0.0; ///< |output - expected|
    double tolerance = 0.0; ///< float32 rounding of the table's largest value
};

/// The service: reads and changes the compensation of a drive's axes in the safe order (DESIGN.md,
/// "The safe order of a write"). Blocking; one instance per link, used on the link's thread. All
/// operations report link errors as DriveLink does; theirs are named at each.
class AxisCompensator {
public:
    /// clock: the wall clock, replaceable for tests. All references must outlive this.
    AxisCompensator(
        DriveLink& link, const DriveProfile& profile, DriveStore& store,
        std::function<WallTime()> clock = [] { return std::chrono::system_clock::now(); });
    ~AxisCompensator();

    [[nodiscard]] Result<DriveIdentity> identify(const OperationOptions& options = {});
    [[nodiscard]] Result<std::vector<AxisInfo>> axes(const OperationOptions& options = {});
    /// An index or a name. Errors: AxisNotFound, AxisAmbiguous.
    [[nodiscard]] Result<int> findAxis(
        const std::string& indexOrName, const OperationOptions& options = {});
    /// Errors: AxisNotFound, NoCompensation.
    [[nodiscard]] Result<AxisStatus> status(int axis, const OperationOptions& options = {});

    /// Path, tam:// URI or hex address to a register that exists on this drive and may be a
    /// DimSource. Errors: SourceNotFound (nearest), SourceWrongType, SourceOtherDrive.
    [[nodiscard]] Result<DimSource> resolveSource(
        const std::string& source, const OperationOptions& options = {});
    /// The profile's shortlist for this drive, those that exist.
    [[nodiscard]] Result<std::vector<DimSource>> sourceShortlist(
        const OperationOptions& options = {});

    /// Reads and checks, changes nothing. Errors: SourceMissing, SourceSurplus, SourceRepeated,
    /// DimensionMismatch, TableTooLarge, SlotNotFound, SlotInUse, NoTable, CompensationActive,
    /// FlashWear, ChangedMeanwhile.
    [[nodiscard]] Result<WritePlan> plan(
        int axis, const WriteRequest& request, const OperationOptions& options = {});
    /// Plans, backs up, writes, verifies; puts everything back when a step fails or the user stops.
    /// Errors: those of plan, NothingToWrite, VerifyMismatch, RollbackFailed. After any error but
    /// OutcomeUnknown and RollbackFailed the drive holds the old state.
    [[nodiscard]] Result<WriteReport> write(
        int axis, const WriteRequest& request, const OperationOptions& options = {});
    [[nodiscard]] Result<WriteReport> setPersistency(
        int axis, Persistency persistency, const OperationOptions& options = {});

    /// Wait for the resulting state. Errors: CompensationError, NotHomed, NoTable.
    [[nodiscard]] Result<AxisStatus> evaluate(int axis, const OperationOptions& options = {});
    [[nodiscard]] Result<AxisStatus> activate(int axis, const OperationOptions& options = {});
    [[nodiscard]] Result<AxisStatus> deactivate(int axis, const OperationOptions& options = {});

    /// The end-to-end proof, while Active (output and indices) or Evaluating (indices). Errors:
    /// ProofFailed with both numbers, CompensationError when the axis is in neither state.
    [[nodiscard]] Result<Proof> prove(
        int axis, int samples = 5, const OperationOptions& options = {});

    /// The table that the axis uses. Errors: NoTable, InvalidTable.
    [[nodiscard]] Result<CompensationTable> readTable(
        int axis, const OperationOptions& options = {});

    [[nodiscard]] Result<std::vector<DriveFile>> files(const OperationOptions& options = {});
    [[nodiscard]] Result<Bytes> download(
        const std::string& path, const OperationOptions& options = {});
    /// The plain file transfer of AN140 5.2: keeps a backup of the old file, uploads, reads back,
    /// compares every byte; puts the old file back when that fails. Gives the backup; an empty path
    /// when the drive held exactly this file already. Errors: UnknownFile when the profile has no
    /// slot there, ChangedMeanwhile, FlashWear, VerifyMismatch, RollbackFailed.
    [[nodiscard]] Result<std::filesystem::path> upload(
        const std::string& path, ByteView bytes, const OperationOptions& options = {});

    /// EraseCount of all slots, and what this computer has recorded.
    [[nodiscard]] Result<FlashUse> flashUse(const OperationOptions& options = {});

    /// Errors: ChangedMeanwhile when another program writes to an axis while it is read.
    [[nodiscard]] Result<DriveBackup> backup(const OperationOptions& options = {});
    /// A normal verified write per axis, then the tables that no axis uses, as upload does it; at
    /// the end all of it is compared once more. Errors: OtherDrive unless force; those of write and
    /// upload; SlotInUse, also by an axis after a reboot.
    [[nodiscard]] Result<std::vector<WriteReport>> restore(
        const DriveBackup& backup, bool force, const OperationOptions& options = {});

    /// Which state the drive holds after an unfinished write; forgets that write when it is the new
    /// one completely. Errors: OtherDrive, FileNotReadable, InvalidBackup.
    enum class UnfinishedOutcome {
        Old, ///< complete, whatever lies in the slot that the write had chosen
        New,
        NewUnsaved, ///< new, but the parameters may not be saved
        Neither,
    };
    [[nodiscard]] Result<UnfinishedOutcome> settleUnfinished(
        const JournalEntry& entry, const OperationOptions& options = {});

    /// What can be done about an unfinished write; changes nothing.
    struct Recovery {
        std::optional<Error> finishObstacle; ///< none: finishUnfinished is possible now
        std::optional<Error> undoObstacle; ///< none: undoUnfinished is possible now
        int flashOperations = 0; ///< that finishing costs
    };
    [[nodiscard]] Result<Recovery> recovery(
        const JournalEntry& entry, const OperationOptions& options = {});
    /// A normal write that brings about the complete new state, from whatever the interruption
    /// left. After an error the write is still unfinished, and can still be undone. Errors: those
    /// of write, OtherDrive, NothingUnfinished, TableNotKept, ChangedMeanwhile when the journal is
    /// not this entry any more.
    [[nodiscard]] Result<WriteReport> finishUnfinished(
        const JournalEntry& entry, const OperationOptions& options = {});
    /// Brings back the complete state before the unfinished write, verified, with a backup of what
    /// there is now. Errors: as finishUnfinished; SlotInUse when something has come to use the old
    /// table's slot.
    [[nodiscard]] Result<WriteReport> undoUnfinished(
        const JournalEntry& entry, const OperationOptions& options = {});

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp
