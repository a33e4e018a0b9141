// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/unfinished_write.h"

#include "core/axis/axis_reader.h"
#include "core/axis/slot_state.h"
#include "core/io/local_file.h"
#include "core/store/backup_json.h"
#include "core/store/drive_store.h"
#include "core/table/tam_table.h"
#include "core/write/backup_restore.h"
#include "core/write/write_planner.h"

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

/// The elements are the end of every table file.
std::uint32_t elementCrc(const Bytes& file, std::size_t elements)
{
    const std::size_t bytes = elements * sizeof(float);
    return bytes <= file.size() ? crc32(ByteView(file).last(bytes)) : 0;
}

} // namespace

int stepRank(std::string_view step)
{
    constexpr std::array<std::string_view, 7> steps{
        "switch off", "release", "upload", "commit", "switch", "save", "delete"};
    const auto found = std::ranges::find(steps, step);
    return static_cast<int>(std::min<std::ptrdiff_t>(found - steps.begin(), steps.size() - 1));
}

Result<UnfinishedWrite> UnfinishedWrite::load(
    const RegisterAccess& access, const JournalEntry& entry)
{
    AXISCOMP_TRY(auto text, loadOrdinaryFile(entry.backup, maximumBackupSize));
    AXISCOMP_TRY(auto backup, readBackup(asText(text), entry.backup.string()));
    UnfinishedWrite write(access, entry);
    for (AxisBackup& axis : backup.axes) {
        if (axis.axis != entry.axis || axis.drive.serialNumber != entry.serialNumber)
            continue;
        write.m_before = std::move(axis);
        return write;
    }
    return fail(ErrorCode::InvalidBackup,
        {{"file", entry.backup.string()},
            {"reason",
                AXISCOMP_TEXT("Error", "it is not of axis {axis} of this drive")
                    .with("axis", entry.axis)}});
}

std::string UnfinishedWrite::oldSlot() const
{
    const std::string path = m_access.axisPath(m_access.registers().table, m_entry.axis);
    const auto table = std::ranges::find(m_before.registers, path, &RegisterWrite::path);
    const std::string slot = table == m_before.registers.end() ? "" : toText(table->value);
    return slot == m_access.enums().tableDisabled ? "" : slot;
}

const AxisBackup::File* UnfinishedWrite::fileOf(const std::string& slot) const
{
    const auto file = std::ranges::find(m_before.files, slot, &AxisBackup::File::slot);
    return file == m_before.files.end() || file->bytes.empty() ? nullptr : &*file;
}

std::uint32_t UnfinishedWrite::oldCrc() const
{
    const AxisBackup::File* file = oldFile();
    if (!file)
        return 0;
    const auto decoded = decodeTamTable(file->bytes, m_access.profile().layout);
    return decoded ? elementCrc(file->bytes, decoded->table.values.size()) : 0;
}

bool UnfinishedWrite::isNewTable() const
{
    return !m_entry.newSlot.empty()
        && (m_entry.newTable || m_entry.newSlot != oldSlot() || m_entry.newCrc != oldCrc());
}

bool UnfinishedWrite::isKnown(const SlotState& state, const std::string& slot) const
{
    if (state.isEmpty())
        return true;
    if (slot == m_entry.newSlot && state.crc == m_entry.newCrc)
        return true;
    const AxisBackup::File* found = fileOf(slot);
    return found && elementCrc(found->bytes, state.elements) == state.crc;
}

Result<Bytes> UnfinishedWrite::newFile(const DriveStore& store) const
{
    if (m_entry.newTable)
        return store.keptTable(*m_entry.newTable);
    if (const AxisBackup::File* file = oldFile(); file && !isNewTable())
        return file->bytes;
    return fail(ErrorCode::TableNotKept, {{"axis", m_entry.axis}});
}

/// Of the new sources, as far as they are those that the axis had: older programs noted no others.
std::vector<std::string> UnfinishedWrite::unitsOfBackup() const
{
    std::vector<std::string> units;
    for (int n = 1; n <= dimensionsOfBackup; ++n) {
        const auto address = sourceAddress(m_access, m_entry.newRegisters, m_entry.axis, n);
        std::string& unit = units.emplace_back();
        for (std::size_t old = 0; old < m_before.sourceUnits.size(); ++old)
            if (address != 0
                && address
                    == sourceAddress(
                        m_access, m_before.registers, m_entry.axis, static_cast<int>(old) + 1))
                unit = m_before.sourceUnits[old];
    }
    return units;
}

Result<AxisBackup> UnfinishedWrite::after(const DriveStore& store) const
{
    AxisBackup after = m_before;
    after.registers = m_entry.newRegisters;
    after.files.clear();
    if (!m_entry.newSlot.empty()) {
        AXISCOMP_TRY(auto bytes, newFile(store));
        after.files.push_back({m_entry.newSlot, {}, std::move(bytes), m_entry.persistent});
    }
    const bool isNoted = !(m_entry.newUnits == TableUnits{});
    if (isNoted)
        after.unit = m_entry.newUnits.values;
    after.sourceUnits = isNoted ? m_entry.newUnits.positions : unitsOfBackup();
    after.sourcePaths = m_entry.newSourcePaths;
    return after;
}

/// The slot that the write had chosen, unless somebody else has come to use it.
Result<std::optional<std::string>> UnfinishedWrite::slotFor(
    DriveStore& store, const DriveIdentity& drive) const
{
    const std::string& slot = m_entry.newSlot;
    AXISCOMP_TRY(
        auto readings, m_access.readAvailable(slotStatePaths(m_access, drive, m_entry.axis, slot)));
    const SlotState state = slotState(m_access, drive, m_entry.axis, slot, readings);
    AXISCOMP_TRY(auto saved, store.savedState(drive.serialNumber));
    const bool isOurs =
        state.otherUser.isEmpty() && !saved.otherUser(slot, m_entry.axis) && isKnown(state, slot);
    return isOurs ? std::optional(slot) : std::nullopt;
}

/// What has come into the slot since is not this write's to delete.
Result<void> UnfinishedWrite::checkDeletable(const DriveIdentity& drive) const
{
    const std::string& slot = m_entry.deletedSlot;
    AXISCOMP_TRY(
        auto readings, m_access.readAvailable(slotStatePaths(m_access, drive, m_entry.axis, slot)));
    const SlotState state = slotState(m_access, drive, m_entry.axis, slot, readings);
    if (isKnown(state, slot))
        return {};
    return fail(ErrorCode::ChangedMeanwhile,
        {{"what", AXISCOMP_TEXT("Error", "the table in {slot}").with("slot", slot)},
            {"before", AXISCOMP_TEXT("Error", "CRC {crc}").with("crc", crcText(oldCrc()))},
            {"now", slotStateText(state)}});
}

Result<WriteRequest> UnfinishedWrite::request(DriveStore& store, const DriveIdentity& drive) const
{
    WriteRequest request;
    request.origin = TableOrigin::Axis;
    request.withoutTable = m_entry.newSlot.empty();
    request.dimensionality = dimensionsOfBackup;
    if (!m_entry.deletedSlot.empty()) {
        AXISCOMP_CHECK(checkDeletable(drive));
        request.deletesTable = true;
        request.slot = m_entry.deletedSlot;
    }
    AXISCOMP_TRY(const auto wanted, after(store));
    if (!request.withoutTable) {
        AXISCOMP_TRY(
            auto decoded, decodeTamTable(wanted.files.front().bytes, m_access.profile().layout));
        request.dimensionality = decoded.table.grid.dimensions();
        request.table = std::move(decoded.table);
        request.persistency = m_entry.persistent ? Persistency::Persistent : Persistency::Volatile;
        AXISCOMP_TRY(auto slot, slotFor(store, drive));
        request.slot = std::move(slot);
    }
    auto sources = sourceTexts(m_access, wanted, request.dimensionality);
    if (!request.withoutTable) {
        const auto missing = std::ranges::find(sources, std::string());
        if (missing != sources.end())
            return fail(ErrorCode::SourceMissing, {{"dimension", missing - sources.begin() + 1}});
    }
    request.sources = std::move(sources);
    return request;
}

Result<void> UnfinishedWrite::checkUndoable() const
{
    const std::string& slot = m_entry.deletedSlot;
    if (slot.empty() || slot == oldSlot() || stepRank(m_entry.step) < stepRank("save"))
        return {};
    return fail(ErrorCode::NotUndoable, {{"axis", m_entry.axis}, {"slot", slot}});
}

PreparedWrite UnfinishedWrite::prepared(const DriveIdentity& drive) const
{
    PreparedWrite write;
    WritePlan& plan = write.plan;
    plan.drive = drive;
    plan.axis = m_entry.axis;
    plan.before.slot = oldSlot();
    plan.after.slot = m_entry.newSlot;
    const bool deletes = !m_entry.deletedSlot.empty();
    plan.after.persistency =
        m_entry.persistent && !deletes ? Persistency::Persistent : Persistency::Volatile;
    const AxisBackup::File* old = oldFile();
    const bool wasPersistent = old && old->persistent;
    plan.flashOperations = isNewTable() ? m_entry.persistent : wasPersistent != m_entry.persistent;
    if (m_entry.newSlot.empty())
        plan.flashOperations = deletes && wasPersistent ? 1 : 0;
    plan.deletedSlot = m_entry.deletedSlot;
    write.saves = deletes && m_entry.persistent;
    if (isNewTable())
        write.file.resize(1); // that there is one is all that undoing needs
    const std::string& touched = deletes ? m_entry.deletedSlot : m_entry.newSlot;
    const TableSlot* slot = m_access.profile().slotNamed(touched);
    if (slot && (deletes || isNewTable()))
        write.slot = *slot;
    write.elementCrc = m_entry.newCrc;
    return write;
}

} // namespace axiscomp
