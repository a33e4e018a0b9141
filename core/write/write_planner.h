// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_reader.h"
#include "core/axis/slot_state.h"
#include "core/base/bytes.h"
#include "core/store/drive_store.h"
#include "core/table/table_units.h"
#include "core/write/slot_choice.h"
#include "core/write/write_plan.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace axiscomp {

/// A plan with what carrying it out needs and what its reader does not.
struct PreparedWrite {
    WritePlan plan;
    Bytes file; ///< the new table file, volatile; empty: the table stays
    TableSlot slot; ///< where it goes
    SlotState slotBefore; ///< what that slot held when it was chosen
    std::uint32_t elementCrc = 0; ///< of the table that the axis has afterwards
    int uncovered = 0; ///< of the plan's flash operations: tables that saving deletes
    /// Saved parameters name the slot that is to be committed, with another table: they are saved
    /// without it first.
    bool releases = false;
    bool saves = false; ///< the parameters, before the table is deleted
};

/// Everything that is decided before a write, without changing anything.
class WritePlanner {
public:
    WritePlanner(const RegisterAccess& access, DriveStore& store, SourceDirectory& sources,
        const DriveIdentity& drive, WallTime now)
        : m_access(access)
        , m_store(store)
        , m_sources(sources)
        , m_drive(drive)
        , m_now(now)
    {
    }

    [[nodiscard]] Result<PreparedWrite> prepare(int axis, const WriteRequest& request);
    /// The same, but for an axis that has all of it already: its compensation may be on.
    [[nodiscard]] Result<PreparedWrite> prepareChanges(int axis, const WriteRequest& request);
    /// What prepare would find if the compensation were off, which it need not be.
    [[nodiscard]] Result<WritePlan> compare(int axis, const WriteRequest& request);

private:
    [[nodiscard]] Result<void> readAxis(int axis);
    [[nodiscard]] Result<PreparedWrite> decide(const WriteRequest& request);
    [[nodiscard]] Result<void> decideSources(const WriteRequest& request);
    [[nodiscard]] Result<PositionFacts> positionFacts(int axis);
    [[nodiscard]] Result<std::vector<std::string>> namesBeside(int axis);
    [[nodiscard]] Result<TableUnits> unitsOf(std::span<const DimSource> sources);
    [[nodiscard]] Result<WriteRequest> inUnitsOfDrive(const WriteRequest& request);
    void noteUnknownUnits(const Grid& grid);
    [[nodiscard]] Result<void> decideTable(const WriteRequest& request);
    [[nodiscard]] Result<void> checkKeptUnits();
    [[nodiscard]] Result<void> checkKeptKind(std::size_t dimension) const;
    [[nodiscard]] Result<bool> isThere(const WriteRequest& request, const CompensationTable& table);
    [[nodiscard]] Result<void> decideNewTable(const WriteRequest& request, Bytes file);
    [[nodiscard]] Result<void> noteStored(const Grid& grid);
    [[nodiscard]] Result<void> decideNoTable(const WriteRequest& request);
    [[nodiscard]] Result<bool> hasNoTable(const WriteRequest& request) const;
    [[nodiscard]] Result<std::string> slotToDelete(const WriteRequest& request);
    [[nodiscard]] Result<std::string> returningSlot() const;
    [[nodiscard]] Result<void> decideDeletion(const WriteRequest& request);
    [[nodiscard]] Result<void> decideRemoval();
    [[nodiscard]] Result<Text> otherUser(const std::string& slot);
    [[nodiscard]] std::string currentTable() const;
    [[nodiscard]] Result<void> decideFlash();
    [[nodiscard]] int flashReserve(bool isStoring) const;
    [[nodiscard]] Result<void> decideSaving();
    [[nodiscard]] Result<void> readOthers();
    [[nodiscard]] Result<std::vector<SlotFacts>> slotFacts(const WriteRequest& request);
    [[nodiscard]] Result<void> lookInto(std::vector<SlotFacts>& slots);
    void listChanges();
    [[nodiscard]] Result<void> decideCoverage();
    [[nodiscard]] Result<void> checkColumns(const WriteRequest& request);
    [[nodiscard]] bool isTargetSettled(TableOrigin origin, bool isThere) const;
    [[nodiscard]] Result<void> checkTargetName(const CompensationTable& table, TableOrigin origin);
    void warn();
    void warnOfKeptTable();
    void warnOfUnknownKinds();
    void warnOfDeletion();
    void warnOfDetaching();
    void warnOfSavedTable();
    [[nodiscard]] std::optional<std::string> volatileSlotOf(const AxisStatus& other) const;
    void warnOfSaving();

    const RegisterAccess& m_access;
    DriveStore& m_store;
    SourceDirectory& m_sources;
    const DriveIdentity& m_drive;
    WallTime m_now;
    int m_axis = 0;
    AxisStatus m_status;
    std::map<int, PositionFacts> m_positionFacts; ///< of other axes
    std::vector<std::string> m_names; ///< of all axes, once one has asked
    OtherWrites m_otherWrites; ///< of the request
    std::vector<AxisStatus> m_others; ///< the other axes, when the parameters will be saved
    SavedState m_saved;
    PreparedWrite m_write;
    std::string m_returningSlot; ///< of an axis that uses no table, and shall use none
    bool m_writesAnyway = false; ///< also where nothing differs: to save, or to end a write
    bool m_keepsTable = false; ///< the axis keeps the table that it uses, as the drive has it
    bool m_isSlotNamed = false; ///< by the request: others may be free
    bool m_isSlotEmpty = false; ///< nothing is overwritten
    bool m_isInSlot = false; ///< the new table is in its slot already
    bool m_isStored = false; ///< the new table is in the flash of its slot already
};

/// The elements are the end of every table file.
[[nodiscard]] std::uint32_t elementCrcOf(ByteView file, const CompensationTable& table);
/// For errors: "Small1 (CRC 00c0ffee), Axes[0]/..., volatile"
[[nodiscard]] Text setupText(const CompensationSetup& setup);
/// That an axis is still as it was when it was planned for, but for the units. Errors:
/// ChangedMeanwhile.
[[nodiscard]] Result<void> checkAsPlanned(const PlannedState& planned, const AxisStatus& now);
/// The same of the units in which its table is: its numbers would mean something else.
[[nodiscard]] Result<void> checkUnitsAsPlanned(
    const PlannedState& planned, const TableUnits& now, const AxisStatus& of);
/// "axis 0 (X)"
[[nodiscard]] Text axisText(int index, const std::string& name);

} // namespace axiscomp
