// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/slot_state.h"

#include "core/store/backup_json.h"

namespace axiscomp {

namespace {

/// The tables of all axes, and their cogging tables: the users of slots.
std::vector<std::string> userPaths(
    const RegisterAccess& access, const DriveIdentity& drive, int axis)
{
    std::vector<std::string> paths;
    for (int other = 0; other < drive.axes; ++other) {
        paths.push_back(access.axisPath(access.registers().coggingTable, other));
        if (other != axis)
            paths.push_back(access.axisPath(access.registers().table, other));
    }
    return paths;
}

std::string otherUserOf(const RegisterAccess& access, const DriveIdentity& drive, int axis,
    std::string_view slot, const Readings& readings)
{
    const RegisterPaths& registers = access.registers();
    for (int other = 0; other < drive.axes; ++other) {
        if (textAt(readings, access.axisPath(registers.coggingTable, other)) == slot)
            return "the cogging compensation of axis " + std::to_string(other);
        if (other != axis && textAt(readings, access.axisPath(registers.table, other)) == slot)
            return "axis " + std::to_string(other);
    }
    return {};
}

} // namespace

std::vector<std::string> slotStatePaths(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, std::string_view slot)
{
    const RegisterPaths& registers = access.registers();
    std::vector<std::string> paths = userPaths(access, drive, axis);
    for (const std::string& pattern :
        {registers.tableElements, registers.tableCrc, registers.tablePersistent})
        paths.push_back(access.slotPath(pattern, slot));
    return paths;
}

SlotState slotState(const RegisterAccess& access, const DriveIdentity& drive, int axis,
    std::string_view slot, const Readings& readings)
{
    const RegisterPaths& registers = access.registers();
    SlotState state;
    state.elements = unsignedAt(readings, access.slotPath(registers.tableElements, slot));
    state.crc = unsignedAt(readings, access.slotPath(registers.tableCrc, slot));
    state.persistent = numberAt(readings, access.slotPath(registers.tablePersistent, slot)) == 1.0;
    state.otherUser = otherUserOf(access, drive, axis, slot, readings);
    return state;
}

std::string slotStateText(const SlotState& state)
{
    std::string text = "empty";
    if (!state.isEmpty())
        text = std::to_string(state.elements) + " values (CRC " + crcText(state.crc) + "), "
            + (state.persistent ? "persistent" : "volatile");
    return state.otherUser.empty() ? text : text + ", used by " + state.otherUser;
}

} // namespace axiscomp
