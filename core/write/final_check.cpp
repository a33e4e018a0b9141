// SPDX-License-Identifier: GPL-3.0-or-later
//
// The last look at the drive before the first change of a write.
#include "core/axis/axis_reader.h"
#include "core/axis/slot_state.h"
#include "core/base/bytes.h"
#include "core/write/write_procedure.h"

namespace axiscomp {

/// It must still be the one that was planned for.
Result<void> WriteProcedure::checkUnchanged()
{
    const WritePlan& plan = m_write.plan;
    AXISCOMP_CHECK(m_access.checkDrive());
    // All of it at one instant, where the profile allows, and nothing is asked after it: who
    // changes something between this reading and the first change cannot be noticed any more.
    AXISCOMP_TRY(
        auto reading, readStatusWith(m_access, plan.drive, plan.axis, m_sources, lastLookPaths()));
    const AxisStatus& now = reading.status;
    if (now.isOn())
        return fail(compensationActive(now));
    AXISCOMP_CHECK(checkAsPlanned(plannedState(plan), now));
    noteEraseCounts(reading.readings);
    if (auto same = checkSlot(reading.readings); !same)
        return same;
    return checkBackup(reading.readings);
}

/// The touched slots, their users and their flash cycles.
std::vector<std::string> WriteProcedure::lastLookPaths() const
{
    std::vector<std::string> paths;
    for (const std::string& slot : touchedSlots()) {
        for (std::string& path :
            slotStatePaths(m_access, m_write.plan.drive, m_write.plan.axis, slot))
            paths.push_back(std::move(path));
        paths.push_back(m_access.slotPath(m_access.registers().tableEraseCount, slot));
    }
    return paths;
}

void WriteProcedure::noteEraseCounts(const Readings& now)
{
    for (const std::string& slot : touchedSlots()) {
        const std::string path = m_access.slotPath(m_access.registers().tableEraseCount, slot);
        if (now.contains(path))
            m_eraseCounts[slot] = unsignedAt(now, path);
    }
}

/// The slot that is about to be overwritten or emptied, in flash alone too, must be as it was when
/// it was chosen.
Result<void> WriteProcedure::checkSlot(const Readings& now) const
{
    const WritePlan& plan = m_write.plan;
    const bool isRemoved = removesFromFlash(plan);
    if (!isNewTable() && !deletes() && !isRemoved)
        return {};
    const std::string& slot = isRemoved ? plan.after.slot : m_write.slot.name;
    const SlotState state = slotState(m_access, plan.drive, plan.axis, slot, now);
    if (state == m_write.slotBefore)
        return {};
    return fail(ErrorCode::ChangedMeanwhile,
        {{"what", AXISCOMP_TEXT("Error", "slot {slot}").with("slot", slot)},
            {"before", slotStateText(m_write.slotBefore)}, {"now", slotStateText(state)}});
}

/// What was kept is what is there: somebody may have changed it and changed it back.
Result<void> WriteProcedure::checkBackup(const Readings& now) const
{
    for (const RegisterWrite& kept : m_backup.registers) {
        if (textAt(now, kept.path) != toText(kept.value))
            return fail(ErrorCode::ChangedMeanwhile,
                {{"what", kept.path}, {"before", toText(kept.value)},
                    {"now", textAt(now, kept.path)}});
    }
    for (const AxisBackup::File& kept : m_backup.files) {
        const SlotState state =
            slotState(m_access, m_write.plan.drive, m_write.plan.axis, kept.slot, now);
        const std::size_t elementBytes = state.elements * sizeof(float);
        const bool isSame = kept.bytes.size() >= elementBytes
            && (state.isEmpty() || crc32(ByteView(kept.bytes).last(elementBytes)) == state.crc);
        if (!isSame)
            return fail(ErrorCode::ChangedMeanwhile,
                {{"what", AXISCOMP_TEXT("Error", "the table in {slot}").with("slot", kept.slot)},
                    {"before",
                        AXISCOMP_TEXT("Error", "{size} bytes").with("size", kept.bytes.size())},
                    {"now", slotStateText(state)}});
    }
    return {};
}

} // namespace axiscomp
