// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/drive/compensation_setup.h"
#include "core/drive/flash_wear.h"
#include "core/neutral/lookup_note.h"
#include "core/table/compensation_table.h"
#include "core/table/table_units.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace axiscomp {

/// Where the table of a request comes from. A table of the drive keeps the name of its column, but
/// not what a person has said of its target.
enum class TableOrigin {
    File, ///< or a person, who can state the target
    Drive, ///< or a backup: the name has to fit the axis, unless the axis has all of this already
    InUse, ///< the same, of the table that the axis uses: its new sources have to fit it too
    Axis, ///< this axis had it, or was being written it: its target was settled then
};

/// What is known of the other axes where several are written one after the other (WriteSequence).
struct OtherWrites {
    std::map<int, CompensationSetup> written = {}; ///< before this one, and what each has then
    std::set<int> stored = {}; ///< after this one, with a table that is persistent then
};

/// What a plan was made for, as whoever confirms it has seen it. With nothing in a member that was
/// not looked at.
struct PlannedState {
    CompensationSetup setup; ///< that the axis has
    /// Of the table that it has: two tables of the same values have the same CRC. Empty: none.
    std::optional<Grid> grid = {};
    std::optional<TableUnits> units = {}; ///< of the table that it has afterwards
    std::optional<std::string> axisName = {};
};

/// What a write shall bring about for one axis.
struct WriteRequest {
    int dimensionality = 1;
    std::vector<std::string>
        sources; ///< path, tam:// URI or hex address, one per dimension; empty: keep
    std::optional<CompensationTable> table; ///< none: keep the table that the axis uses
    std::optional<Persistency> persistency; ///< none: keep (a new table is volatile)
    std::optional<std::string> slot; ///< none: chosen
    /// For others that are planned together with this one, each with who that is.
    std::map<std::string, Text> takenSlots = {};
    OtherWrites others = {};
    bool withoutTable = false; ///< the axis shall use none: sources, which may be gaps (""), remain
    /// withoutTable: an axis that names an empty slot, as after a reboot that took a volatile
    /// table, has no table already.
    bool leavesEmptySlot = false;
    bool deletesTable =
        false; ///< withoutTable, and its slot (or `slot`) is emptied: deletionRequest
    /// The side of the compensation for which the table was made; none: not known. A source on the
    /// other side is refused.
    std::optional<LookupAt> lookupAt = {};
    /// Serial number of the drive whose measurement the table was made of (measuredDriveInNotes);
    /// none: not known. Another drive is refused.
    std::optional<std::int32_t> measuredDrive = {};
    /// It is known that its largest value is not what a reference said there, but has been
    /// computed.
    bool isComputed = false;
    UnstatedUnit unstatedUnit = UnstatedUnit::OfPositions; ///< of the table's values
    TableOrigin origin = TableOrigin::File;
    std::vector<Text> doubts = {}; ///< of whoever asks; they become warnings of the plan
    bool acceptsLarge = false; ///< corrections of WritePlan::largeCorrections are meant so
    std::optional<PlannedState> expected = {}; ///< when set: refuse if the drive no longer has this
    /// Serial number of the drive that was planned for; when set: another one is refused.
    std::optional<std::int32_t> expectedDrive = {};
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
    std::string deletedSlot; ///< emptied, in memory and in flash; empty: none
    std::vector<PlannedChange> changes; ///< empty: nothing to write
    int flashOperations = 0; ///< that the write costs
    int flashReserve = 0; ///< more that must be possible, so that it can be put back
    FlashBudget flashBudget; ///< before the write
    std::vector<Text> warnings;
    std::optional<CompensationTable> table; ///< in the drive's units; none: the table stays
    bool isComputed = false; ///< as in WriteRequest
    std::optional<LookupAt>
        lookupAt; ///< where the axis looks its table up then; nothing: not known
    std::optional<std::size_t>
        ownDimension; ///< whose source is the position of the axis itself; nothing: none is
    std::vector<Text> largeCorrections; ///< what has to be confirmed (WriteRequest::acceptsLarge)
    std::vector<DimensionCoverage> coverage; ///< where the drive says how far an axis travels
    std::vector<Text> unitRemarks; ///< what was converted and assumed of the table's units
    std::string axisName = {}; ///< on the drive
    Grid gridBefore = {}; ///< of the table that the axis has; empty: none
    TableUnits units = {}; ///< in which its table is afterwards; empty: there is none
};

[[nodiscard]] PlannedState plannedState(const WritePlan& plan);
/// Of an axis that keeps its sources.
[[nodiscard]] PlannedState plannedState(const AxisStatus& now);
/// The request carries out that plan, or is refused: what was confirmed is what is written.
void expectAsPlanned(WriteRequest& request, const WritePlan& plan);

/// Deletes the table that the axis uses; its sources stay.
[[nodiscard]] WriteRequest deletionRequest();

/// That what is unusually large has been confirmed. Errors: LargeCorrection.
[[nodiscard]] Result<void> checkLargeAccepted(const WritePlan& plan, const WriteRequest& request);

/// The table stays and becomes volatile: that costs flash as storing it does.
[[nodiscard]] bool removesFromFlash(const WritePlan& plan);

/// The deletion of a table that no axis uses.
struct SlotDeletion {
    DriveIdentity drive;
    std::string slot;
    std::string file; ///< its path on the drive
    std::size_t bytes = 0;
    bool persistent = false;
    int flashOperations = 0; ///< as in WritePlan
    int flashReserve = 0;
    FlashBudget flashBudget;
};

/// What storing a file as it is costs.
struct UploadPlan {
    DriveIdentity drive;
    bool persistent = false; ///< the file is a table for flash
    int flashOperations = 0; ///< none where the drive holds exactly this file already
    FlashBudget flashBudget; ///< before it
};

struct WriteReport {
    WritePlan plan;
    AxisStatus now; ///< read back after the write
    std::filesystem::path backup;
};

} // namespace axiscomp
