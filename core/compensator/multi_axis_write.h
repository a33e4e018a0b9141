// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_operations.h"
#include "core/store/backup.h"
#include "core/write/write_sequence.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

/// Several axes of a drive in one go, as functions that run on the session's thread.
namespace axiscomp {

/// One of several writes that belong together: the columns of one file, each for an axis.
struct AxisWrite {
    int axis = 0;
    WriteRequest request;
};

[[nodiscard]] WriteSequence sequenceOf(std::span<const AxisWrite> writes);

/// The plan of each, so that nothing is begun that cannot be ended; changes nothing. No two put a
/// table into the same slot, as it will be when one is written after the other. Errors: those of
/// AxisCompensator::plan, their context names the axis (`ofAxis`); InvalidArgument when an axis is
/// named twice; FlashWear also when all together cost more flash operations than are possible now.
[[nodiscard]] Result<std::vector<WritePlan>> planMultiAxis(AxisCompensator& compensator,
    std::span<const AxisWrite> writes, const OperationOptions& options = {});

/// Carries out writes that were planned together, one after the other, up to the first that fails
/// (holdsNewState): as many results as were begun. write: does one of them, by its place, with what
/// the others are to it.
[[nodiscard]] std::vector<Result<WriteReport>> writeInTurn(std::span<const AxisWrite> writes,
    std::span<const WritePlan> plans,
    const std::function<Result<WriteReport>(std::size_t, const WriteRequest&)>& write);

/// The error of one of several changes that are made one after the other, with what the others have
/// come to: `written` and `notWritten`, by their names. One that may have left anything is in
/// neither. failed: its place in names; as many as there are: an error after all of them.
[[nodiscard]] Error ofSeveral(Error error, std::span<const std::string> names, std::size_t failed);

/// Flash operations of changes that are made one after the other.
class FlashSum {
public:
    /// reserve: what putting this change back may cost, if it is the one that fails.
    void add(int operations, int reserve);
    /// Refuses changes that together need more than are possible now. Errors: FlashWear.
    [[nodiscard]] Result<void> check(
        AxisCompensator& compensator, const OperationOptions& options) const;

private:
    int m_changes = 0; ///< that cost something
    int m_operations = 0;
    int m_needed = 0;
};

/// A table, and the axis that shall have it.
struct AxisTable {
    int axis = 0;
    /// Copied into the request on the session's thread, as it may be large; none: the request says
    /// what happens to the table.
    LoadedTable table;
    WriteRequest request; ///< without its table
};

/// Tables and what writing them would change, in their order.
struct PlannedTables {
    std::vector<AxisTable> tables;
    std::vector<WritePlan> plans;
    std::vector<AxisBackup::File> files{}; ///< of slots that no axis uses, written after the tables
};

/// Changes nothing. Errors: those of planMultiAxis.
[[nodiscard]] Result<std::vector<WritePlan>> planTables(AxisCompensator& compensator,
    std::span<const AxisTable> tables, const OperationOptions& options);

/// One result per axis, in their order, up to the first that failed; NothingToWrite is no failure:
/// the axis has everything already.
struct MultiAxisReport {
    std::vector<Result<WriteReport>> writes;
    std::optional<Error> filesProblem{}; ///< why not all files were written; the axes were
};

/// The writes that bring a whole drive back to a backup, planned together; changes nothing. Errors:
/// those of AxisCompensator::planRestore.
[[nodiscard]] Result<PlannedTables> planDriveRestoration(AxisCompensator& compensator,
    const DriveBackup& backup, bool force, const OperationOptions& options);

/// Whether a write left its axis in the state that was asked for.
[[nodiscard]] bool holdsNewState(const Result<WriteReport>& write);

/// Plans all of them again, so that none is begun when one is refused; then one normal verified
/// write after the other, and the files when none of these failed. turn: which of the tables is
/// being written. shownAxis is read afterwards. Errors: those of planTables, and nothing was
/// written.
[[nodiscard]] OperationEnd<MultiAxisReport> writeTables(AxisCompensator& compensator,
    const std::filesystem::path& storeRoot, int shownAxis, std::span<const AxisTable> tables,
    std::atomic<std::size_t>& turn, const OperationOptions& options,
    const std::vector<AxisBackup::File>& files = {});

} // namespace axiscomp
