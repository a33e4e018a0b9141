// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/flash_memory.h"

#include <algorithm>

namespace axiscomp::drivecomm {

namespace {

std::shared_ptr<StoredTable> withBytes(Bytes bytes, const TableLayout& layout)
{
    auto result = std::make_shared<StoredTable>();
    result->bytes = std::move(bytes);
    if (result->bytes.size() >= layout.headerSize)
        result->crc = crc32(ByteView(result->bytes).subspan(layout.headerSize));
    return result;
}

void decodeInto(StoredTable& stored, CompensationTable table)
{
    stored.table = std::move(table);
    stored.lookup.emplace(stored.table, Outside::Hold);
}

} // namespace

Result<std::shared_ptr<const StoredTable>> storedTable(Bytes bytes, const TableLayout& layout)
{
    Result<TamTable> decoded = decodeTamTable(bytes, layout);
    if (!decoded)
        return fail(decoded.error());
    const std::shared_ptr<StoredTable> result = withBytes(std::move(bytes), layout);
    decodeInto(*result, std::move(decoded->table));
    return result;
}

std::shared_ptr<const StoredTable> possiblyDamagedTable(Bytes bytes, const TableLayout& layout)
{
    Result<TamTable> decoded = decodeTamTable(bytes, layout);
    const std::shared_ptr<StoredTable> result = withBytes(std::move(bytes), layout);
    if (decoded)
        decodeInto(*result, std::move(decoded->table));
    return result;
}

FlashMemory::FlashMemory(const DriveProfile& profile)
    : m_profile(&profile)
    , m_slots(profile.tableSlots.size())
{
}

Result<void> FlashMemory::upload(
    std::size_t index, std::shared_ptr<const StoredTable> table, bool persistent, DriveTime now)
{
    SlotMemory& slot = m_slots.at(index);
    slot.ram = std::move(table);
    slot.persistent = persistent;
    return persistent ? commit(index, now) : Result<void>{};
}

Result<void> FlashMemory::setPersistent(std::size_t index, bool persistent)
{
    SlotMemory& slot = m_slots.at(index);
    if (persistent == slot.persistent)
        return {};
    if (!slot.ram)
        return fail(ErrorCode::DriveRejected,
            {{"reason",
                AXISCOMP_TEXT("Error", "there is no table in {slot} that could be persistent")
                    .with("slot", m_profile->tableSlots[index].name)}});
    Bytes bytes = slot.ram->bytes;
    axiscomp::setPersistent(bytes, persistent, m_profile->layout);
    slot.ram = possiblyDamagedTable(std::move(bytes), m_profile->layout);
    slot.persistent = persistent;
    return {};
}

Result<void> FlashMemory::commit(std::size_t index, DriveTime now)
{
    SlotMemory& slot = m_slots.at(index);
    if (!slot.ram)
        return fail(ErrorCode::DriveRejected,
            {{"reason",
                AXISCOMP_TEXT("Error", "there is no table in {slot} that could be committed")
                    .with("slot", m_profile->tableSlots[index].name)}});
    if (!slot.persistent)
        return slot.flash ? useFlash(slot, now).map([&] { slot.flash.reset(); }) : Result<void>{};
    if (slot.flash && sameTable(slot.flash->bytes, slot.ram->bytes, m_profile->layout))
        return {};
    return useFlash(slot, now).map([&] { slot.flash = slot.ram; });
}

Result<void> FlashMemory::erase(std::size_t index, DriveTime now)
{
    SlotMemory& slot = m_slots.at(index);
    if (slot.flash)
        if (Result<void> used = useFlash(slot, now); !used)
            return used;
    slot.flash.reset();
    slot.ram.reset();
    slot.persistent = false;
    return {};
}

void FlashMemory::reboot()
{
    for (SlotMemory& slot : m_slots) {
        slot.ram = slot.flash;
        slot.persistent = slot.flash != nullptr;
    }
}

DriveTime FlashMemory::availableFrom(DriveTime now) const
{
    const FlashWearLimits& limits = m_profile->flashWear;
    if (limits.operations <= 0)
        return now;
    const auto allowed = static_cast<std::size_t>(limits.operations);
    const auto counts = [&](DriveTime operation) { return now - operation < limits.window; };
    const auto recent = static_cast<std::size_t>(std::ranges::count_if(m_operations, counts));
    return recent < allowed ? now : m_operations[m_operations.size() - allowed] + limits.window;
}

Result<void> FlashMemory::useFlash(SlotMemory& slot, DriveTime now)
{
    if (const DriveTime from = availableFrom(now); from > now)
        return fail(ErrorCode::FlashWear,
            {{"seconds", std::chrono::ceil<std::chrono::seconds>(from - now).count()}});
    std::erase_if(m_operations,
        [&](DriveTime operation) { return now - operation >= m_profile->flashWear.window; });
    m_operations.push_back(now);
    ++m_operationCount;
    ++slot.eraseCount;
    return {};
}

void FlashMemory::restore(
    std::size_t index, std::shared_ptr<const StoredTable> flash, std::uint32_t eraseCount)
{
    SlotMemory& slot = m_slots.at(index);
    slot.flash = std::move(flash);
    slot.eraseCount = eraseCount;
    slot.ram = slot.flash;
    slot.persistent = slot.flash != nullptr;
}

void FlashMemory::restoreOperations(std::vector<DriveTime> operations)
{
    m_operations = std::move(operations);
    std::ranges::sort(m_operations);
}

} // namespace axiscomp::drivecomm
