// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/slot_file.h"

#include "core/axis/axis_reader.h"
#include "core/axis/shown_grid.h"
#include "core/axis/slot_state.h"
#include "core/table/tam_table.h"
#include "core/text/crc_text.h"
#include "core/write/write_planner.h"

#include <utility>

namespace axiscomp {

namespace {

/// What the slot's registers say; nobody who uses it.
SlotState shownState(const RegisterAccess& access, const Readings& readings, const TableSlot& slot)
{
    const RegisterPaths& registers = access.registers();
    const auto at = [&](const std::string& pattern) { return access.slotPath(pattern, slot.name); };
    SlotState state;
    state.elements = unsignedAt(readings, at(registers.tableElements));
    state.crc = unsignedAt(readings, at(registers.tableCrc));
    state.persistent = numberAt(readings, at(registers.tablePersistent)) == 1.0;
    return state;
}

/// The elements are the end of every table file.
bool hasElements(ByteView bytes, const SlotState& shown)
{
    const std::size_t size = sizeof(float) * shown.elements;
    return size <= bytes.size() && crc32(bytes.last(size)) == shown.crc;
}

Text tableIn(const TableSlot& slot)
{
    return AXISCOMP_TEXT("Error", "the table in {slot}").with("slot", slot.name);
}

Text fileText(ByteView bytes, const Result<TamTable>& decoded)
{
    if (bytes.empty())
        return slotStateText({});
    if (!decoded)
        return AXISCOMP_TEXT("Error", "{size} bytes").with("size", bytes.size());
    SlotState state;
    state.elements = static_cast<std::uint32_t>(decoded->table.values.size());
    state.crc = elementCrcOf(bytes, decoded->table);
    state.persistent = decoded->persistent;
    return slotStateText(state);
}

/// True: the file is the table that the drive shows. False: it is no table, and nothing that the
/// drive shows says that it is another one. A CRC of 0 is none.
Result<bool> isAsShown(
    const RegisterAccess& access, const Readings& readings, const TableSlot& slot, ByteView bytes)
{
    const SlotState shown = shownState(access, readings, slot);
    if (bytes.empty() && shown.isEmpty())
        return true;
    const auto decoded = decodeTamTable(bytes, access.profile().layout);
    const auto isOther = [&] {
        if (bytes.empty())
            return true;
        if (!decoded)
            return !shown.isEmpty() && shown.crc != 0 && !hasElements(bytes, shown);
        if (shown.crc != 0)
            return elementCrcOf(bytes, decoded->table) != shown.crc;
        return decoded->table.values.size() != shown.elements
            && readings.contains(access.slotPath(access.registers().tableElements, slot.name));
    };
    if (isOther())
        return fail(ErrorCode::ChangedMeanwhile,
            {{"what", tableIn(slot)}, {"before", slotStateText(shown)},
                {"now", fileText(bytes, decoded)}});
    if (!decoded)
        return false;
    if (const auto header = headerFrom(access, readings, slot.name))
        AXISCOMP_CHECK(
            checkShownGrid(ErrorCode::InvalidTable, slot.name, header->grid, decoded->table.grid));
    return true;
}

/// No bytes: the drive has no such file.
Result<Bytes> contentsOf(
    const RegisterAccess& access, const TableSlot& slot, const Exchange& exchange)
{
    auto bytes = access.link().download(slot.file, exchange);
    if (!bytes && bytes.error().code == ErrorCode::UnknownFile)
        return Bytes{};
    return bytes;
}

Error differentEachTime(const TableSlot& slot, ByteView first, ByteView second)
{
    const auto text = [](ByteView bytes) {
        return AXISCOMP_TEXT("Error", "CRC {crc}").with("crc", crcText(crc32(bytes)));
    };
    return {ErrorCode::ChangedMeanwhile,
        {{"what", tableIn(slot)}, {"before", text(first)}, {"now", text(second)}}, {}};
}

} // namespace

Result<AxisBackup::File> readSlotFile(const RegisterAccess& access, const TableSlot& slot)
{
    AxisBackup::File file;
    file.slot = slot.name;
    file.path = slot.file;
    Bytes first;
    // Not every way to a drive notices a byte that changes on it, and some answer with what was
    // there before: then the file is read again.
    for (const bool isAgain : {false, true}) {
        AXISCOMP_TRY(auto bytes, contentsOf(access, slot, access.exchange()));
        AXISCOMP_TRY(const auto readings, access.readAvailable(headerPaths(access, slot.name)));
        const auto isShown = isAsShown(access, readings, slot, bytes);
        if (!isShown && isAgain)
            return fail(isShown.error());
        const bool isSame = isAgain && bytes == file.bytes;
        first = std::exchange(file.bytes, std::move(bytes));
        file.persistent = !file.bytes.empty() && shownState(access, readings, slot).persistent;
        if (isShown && (*isShown || isSame))
            return file;
    }
    return fail(differentEachTime(slot, first, file.bytes));
}

Result<Bytes> downloadSlotFile(
    const RegisterAccess& access, const TableSlot& slot, const Exchange& exchange)
{
    AXISCOMP_TRY(auto first, contentsOf(access, slot, exchange));
    if (first.empty())
        return first;
    const std::string crc = access.slotPath(access.registers().tableCrc, slot.name);
    const std::vector<std::string> paths{
        crc, access.slotPath(access.registers().tableElements, slot.name)};
    const auto isRight = [&](ByteView bytes) -> Result<bool> {
        AXISCOMP_TRY(const auto readings, access.readAvailable(paths));
        return !readings.contains(crc) || hasElements(bytes, shownState(access, readings, slot));
    };
    AXISCOMP_TRY(const bool isFirstRight, isRight(first));
    if (isFirstRight)
        return first;
    AXISCOMP_TRY(auto second, contentsOf(access, slot, exchange));
    if (second.empty() || second == first)
        return second;
    AXISCOMP_TRY(const bool isSecondRight, isRight(second));
    if (isSecondRight)
        return second;
    return fail(differentEachTime(slot, first, second));
}

bool isShownTable(
    const DriveProfile& profile, const std::optional<TableHeader>& shown, ByteView file)
{
    const auto decoded = decodeTamTable(file, profile.layout);
    if (!decoded)
        return true;
    return shown && (shown->crc == 0 || shown->crc == elementCrcOf(file, decoded->table))
        && isShownAs(shown->grid, decoded->table.grid);
}

} // namespace axiscomp
