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

Text otherUserOf(const RegisterAccess& access, const DriveIdentity& drive, int axis,
    std::string_view slot, const Readings& readings)
{
    const RegisterPaths& registers = access.registers();
    for (int other = 0; other < drive.axes; ++other) {
        if (textAt(readings, access.axisPath(registers.coggingTable, other)) == slot)
            return AXISCOMP_TEXT("Error", "the cogging compensation of axis {axis}")
                .with("axis", other);
        if (other != axis && textAt(readings, access.axisPath(registers.table, other)) == slot)
            return AXISCOMP_TEXT("Error", "axis {axis}").with("axis", other);
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

Text slotStateText(const SlotState& state)
{
    const bool isFree = state.otherUser.isEmpty();
    TextPattern pattern =
        isFree ? AXISCOMP_TEXT("Error", "empty") : AXISCOMP_TEXT("Error", "empty, used by {user}");
    if (!state.isEmpty() && state.persistent)
        pattern = isFree
            ? AXISCOMP_TEXT("Error", "{count} values (CRC {crc}), persistent")
            : AXISCOMP_TEXT("Error", "{count} values (CRC {crc}), persistent, used by {user}");
    else if (!state.isEmpty())
        pattern = isFree
            ? AXISCOMP_TEXT("Error", "{count} values (CRC {crc}), volatile")
            : AXISCOMP_TEXT("Error", "{count} values (CRC {crc}), volatile, used by {user}");
    return pattern.with("count", state.elements)
        .with("crc", crcText(state.crc))
        .with("user", state.otherUser);
}

} // namespace axiscomp
