// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "core/table/compensation_table.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

/// Whole operations on one axis, for the window and the command line alike. They block.
namespace axiscomp {

/// What there is at an endpoint.
struct DriveFindings {
    DriveIdentity drive;
    std::vector<AxisInfo> axes;
    std::vector<DimSource> sources; ///< the profile's shortlist, those that exist
};
[[nodiscard]] Result<DriveFindings> exploreDrive(
    AxisCompensator& compensator, const OperationOptions& options);

/// An earlier write that did not end, and what it left behind.
struct SettledWrite {
    JournalEntry entry;
    AxisCompensator::UnfinishedOutcome outcome = AxisCompensator::UnfinishedOutcome::Neither;
    AxisCompensator::Recovery recovery; ///< what can be done about it
};

/// An axis on the drive, and what became of a write to it that did not end.
struct SettledStatus {
    AxisStatus status;
    std::optional<SettledWrite> settled; ///< none while another program is writing
    bool isBeingWritten = false; ///< by another program: its write has not failed, it is going on
    /// Why a write that did not end could not be settled, or, where status names none, why it is
    /// not known whether there is one.
    std::optional<Error> settlingProblem;
    /// Whether the journal could be read.
    [[nodiscard]] bool isJournalKnown() const { return !settlingProblem || status.unfinishedWrite; }
};

/// Reads an axis and settles a write that did not end, both under the drive's write lock. Errors:
/// those of AxisCompensator::watch; what goes wrong while settling is settlingProblem.
[[nodiscard]] Result<SettledStatus> settledStatus(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int axis, const OperationOptions& options);

/// Half of a write must not be activated. Errors: VerifyMismatch (axis, backup, unfinished) when
/// the drive holds neither the old nor the new state of a write that did not end; (axis, backup,
/// unread) when nobody knows which.
[[nodiscard]] Result<void> checkMayActivate(const SettledStatus& now);

/// That nobody is writing to the axis, and that it is known what became of a write that did not
/// end. Errors: ChangedMeanwhile while another program is writing, settlingProblem.
[[nodiscard]] Result<void> checkIsSettled(const SettledStatus& now);

/// Half of a write is not the state of an axis: what is kept as one must not be it. Errors: those
/// of checkIsSettled; VerifyMismatch (axis, backup, half) when the drive holds neither the old nor
/// the new state of a write that did not end, (axis, backup, unread) when nobody knows which.
[[nodiscard]] Result<void> checkIsWhole(const SettledStatus& now);

/// A state of an axis that may be kept. Errors: those of settledStatus, checkIsWhole and
/// AxisCompensator::checkUnchanged.
[[nodiscard]] Result<AxisStatus> wholeStatus(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int axis, const OperationOptions& options);

/// A whole drive, as far as it could be kept.
struct DriveRescue {
    DriveBackup backup;
    /// Why an axis in it may be half of a write, or a table cannot be restored; mostly none.
    std::vector<Error> doubts;
};
/// AxisCompensator::backup of all axes as they are, since whoever rescues what is left must not be
/// refused; what checkIsWhole says of them is doubts, and so are unreadableTables. Errors: those of
/// backup, and ChangedMeanwhile when another program has written to an axis meanwhile.
[[nodiscard]] Result<DriveRescue> backUpDrive(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const OperationOptions& options);

/// A settled status, with what this computer knows about the drive.
struct AxisReading : SettledStatus {
    DriveStore::FlashHistory flashHistory; ///< with what the drive has refused, to any program
    std::optional<FlashUse> flashUse;
    bool hasBackup = false;
};

/// Reads an axis. What this computer remembers may be missing. Errors: those of settledStatus and,
/// of the link, of flashUse.
[[nodiscard]] Result<AxisReading> readAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int axis, const OperationOptions& options);

/// What became of an operation, and what the drive says afterwards, whatever happened.
template <typename T> struct OperationEnd {
    Result<T> outcome;
    Result<AxisReading> now;
};

/// table: none keeps the axis's table.
[[nodiscard]] OperationEnd<WriteReport> writeAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int axis, WriteRequest request,
    const OperationOptions& options);

/// As AxisCompensator::switchTo.
[[nodiscard]] OperationEnd<Activation> switchAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int axis, Switch wanted,
    const OperationOptions& options);

/// Which state an axis got back.
struct Restoration {
    WallTime backupTime{};
    std::filesystem::path backup;
    /// This computer made the backup for a write to this drive; otherwise it is a file that
    /// somebody has kept.
    bool isBeforeWrite = true;
    std::optional<std::int32_t> otherDrive; ///< whose backup it is, by its serial number
};
/// What restoreAxis does, as a person has seen it; changes nothing.
struct PlannedRestoration {
    Restoration state;
    AxisBackup backup; ///< as it was read: the file may be another one later
    bool acceptsOther = false; ///< as in BackupChoice
    WritePlan plan;
};
/// Of the newest backup that differs from what the axis has now. Errors: InvalidArgument when there
/// is none, those of AxisCompensator::planRestore.
[[nodiscard]] Result<PlannedRestoration> planRestoration(AxisCompensator& compensator,
    const DriveProfile& profile, const std::filesystem::path& storeRoot, int axis,
    const OperationOptions& options);

/// A backup that a person has chosen among several.
struct BackupChoice {
    std::filesystem::path file;
    int axis = 0; ///< whose backup it is, and which gets it
    bool acceptsOther = false; ///< it may be of a drive with another serial number
};
/// The same for a backup that was chosen. Errors: InvalidBackup when it is not of that axis, those
/// of AxisCompensator::planRestore.
[[nodiscard]] Result<PlannedRestoration> planRestoration(AxisCompensator& compensator,
    const DriveProfile& profile, const std::filesystem::path& storeRoot, const BackupChoice& choice,
    const OperationOptions& options);

/// The backup that was planned, written and verified as any other write. Errors: ChangedMeanwhile
/// when the axis is not as it was then, OtherDrive, those of AxisCompensator::write.
[[nodiscard]] OperationEnd<Restoration> restoreAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const PlannedRestoration& planned,
    const OperationOptions& options);

/// Finishes or undoes a write that did not end. Errors: those of AxisCompensator.
[[nodiscard]] OperationEnd<WriteReport> recoverAxis(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, const JournalEntry& entry, bool finishes,
    const OperationOptions& options);

/// expected: given back in place of what was downloaded when its numbers are the same, because it
/// has the names and units that the drive does not keep; may be null.
[[nodiscard]] Result<LoadedTable> downloadTable(AxisCompensator& compensator, int axis,
    const LoadedTable& expected, const OperationOptions& options);

} // namespace axiscomp
