// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/backup_restore.h"

#include "core/axis/verified_transfer.h"
#include "core/store/drive_store.h"
#include "core/table/tam_table.h"
#include "core/write/restored_axis.h"
#include "core/write/slot_file.h"

#include <algorithm>
#include <charconv>

namespace axiscomp {

namespace {

std::string hexAddress(std::uint32_t address)
{
    char digits[8];
    const auto end = std::to_chars(digits, digits + 8, address, 16).ptr;
    return "0x" + std::string(digits, end);
}

const RegisterWrite* registerAt(const AxisBackup& backup, const std::string& path)
{
    const auto found = std::ranges::find(backup.registers, path, &RegisterWrite::path);
    return found == backup.registers.end() ? nullptr : &*found;
}

Error invalidBackup(Text reason)
{
    return {ErrorCode::InvalidBackup,
        {{"file", AXISCOMP_TEXT("Error", "the backup")}, {"reason", std::move(reason)}}, {}};
}

/// That the backup says which table the axis had. An empty slot has a file without bytes in it: one
/// that has no file at all was edited, and says nothing of the table.
Result<void> checkTableKept(const RegisterAccess& access, const AxisBackup& backup)
{
    const RegisterWrite* table =
        registerAt(backup, access.axisPath(access.registers().table, backup.axis));
    if (!table)
        return fail(invalidBackup(
            AXISCOMP_TEXT("Error", "axis {axis} has no Table register").with("axis", backup.axis)));
    const std::string name = toText(table->value);
    if (!access.profile().slotNamed(name)
        || std::ranges::find(backup.files, name, &AxisBackup::File::slot) != backup.files.end())
        return {};
    return fail(invalidBackup(
        AXISCOMP_TEXT("Error", "axis {axis} used {slot}, and the file of this slot is missing")
            .with("axis", backup.axis)
            .with("slot", name)));
}

/// The table file that the axis used when the backup was made.
const AxisBackup::File* usedFile(const RegisterAccess& access, const AxisBackup& backup)
{
    const RegisterWrite* table =
        registerAt(backup, access.axisPath(access.registers().table, backup.axis));
    if (!table)
        return nullptr;
    const auto file =
        std::ranges::find(backup.files, toText(table->value), &AxisBackup::File::slot);
    return file == backup.files.end() || file->bytes.empty() ? nullptr : &*file;
}

Result<AxisBackup> readAxisBackup(const RegisterAccess& access, const DriveIdentity& drive,
    SourceDirectory& sources, int axis, WallTime now)
{
    AxisBackup backup;
    backup.drive = drive;
    backup.axis = axis;
    backup.time = now;
    AXISCOMP_TRY(auto registers, readAxisRegisters(access, axis));
    backup.registers = std::move(registers);
    AXISCOMP_CHECK(describeAxis(access, sources, backup));
    const TableSlot* slot = access.profile().slotNamed(toText(backup.registers.front().value));
    if (!slot)
        return backup;
    AXISCOMP_TRY(auto file, readSlotFile(access, *slot));
    backup.files.push_back(std::move(file));
    // Another program may have written in between: registers and file must be of one state.
    auto same = compareRegisters(access, backup.registers);
    if (!same && same.error().code == ErrorCode::VerifyMismatch) {
        const auto& context = same.error().context;
        return fail(ErrorCode::ChangedMeanwhile,
            {{"what", *context.find("what")}, {"before", *context.find("expected")},
                {"now", *context.find("found")}});
    }
    if (!same)
        return fail(same.error());
    return backup;
}

bool isUsedBy(const DriveBackup& backup, const std::string& slot)
{
    return std::ranges::any_of(backup.axes, [&](const AxisBackup& axis) {
        return std::ranges::find(axis.files, slot, &AxisBackup::File::slot) != axis.files.end();
    });
}

/// Not where a source is not there any more.
Result<bool> holdsRegisters(
    const RegisterAccess& access, SourceDirectory& sources, const AxisBackup& wanted)
{
    const auto registers = keptRegisters(access, sources, wanted);
    if (!registers && registers.error().code == ErrorCode::SourceNotFound)
        return false;
    if (!registers)
        return fail(registers.error());
    auto same = compareRegisters(access, *registers);
    if (!same && same.error().code != ErrorCode::VerifyMismatch)
        return fail(same.error());
    return same.has_value();
}

Result<bool> holdsTable(const RegisterAccess& access, const TableSlot& slot, ByteView wanted)
{
    const auto bytes = access.link().download(slot.file, access.exchange());
    if (!bytes && bytes.error().code != ErrorCode::UnknownFile)
        return fail(bytes.error());
    return bytes && sameTable(*bytes, wanted, access.profile().layout);
}

/// Whether the slot that a write had chosen holds its table, of which the CRC is there already: a
/// table of the same values on another grid has the same CRC.
Result<bool> holdsNewTable(
    const RegisterAccess& access, const DriveStore& store, const JournalEntry& entry)
{
    const TableSlot* slot = access.profile().slotNamed(entry.newSlot);
    if (!slot)
        return true; // the axis uses none then
    if (entry.newTable)
        if (const auto kept = store.keptTable(*entry.newTable))
            return holdsTable(access, *slot, *kept);
    const auto write = UnfinishedWrite::load(access, entry);
    if (!write)
        return true;
    // What was not kept is told from the old table by the CRC alone.
    if (write->isNewTable())
        return write->oldSlot() != entry.newSlot || write->oldCrc() != entry.newCrc;
    const AxisBackup::File* stays = write->oldFile();
    return stays ? holdsTable(access, *slot, stays->bytes) : Result<bool>(true);
}

} // namespace

std::vector<AxisBackup::File> filesBesides(
    const DriveBackup& backup, std::span<const WritePlan> plans)
{
    std::vector<AxisBackup::File> files;
    for (const AxisBackup::File& file : backup.otherFiles)
        if (std::ranges::none_of(
                plans, [&](const WritePlan& plan) { return plan.after.slot == file.slot; }))
            files.push_back(file);
    return files;
}

Result<DriveBackup> readBackupOf(const RegisterAccess& access, const DriveIdentity& drive,
    SourceDirectory& sources, WallTime now)
{
    AXISCOMP_TRY(auto axes, readAxes(access, drive));
    DriveBackup backup;
    for (const AxisInfo& info : axes) {
        if (info.stateWord.empty())
            continue;
        access.report("backup",
            static_cast<double>(info.index) / static_cast<double>(std::max(drive.axes, 1)));
        AXISCOMP_TRY(auto axis, readAxisBackup(access, drive, sources, info.index, now));
        backup.axes.push_back(std::move(axis));
    }
    if (backup.axes.empty())
        backup.drive = drive;
    for (const TableSlot& slot : access.profile().tableSlots) {
        if (isUsedBy(backup, slot.name))
            continue;
        AXISCOMP_TRY(auto file, readSlotFile(access, slot));
        if (!file.bytes.empty())
            backup.otherFiles.push_back(std::move(file));
    }
    return backup;
}

Result<void> checkRestorable(
    const RegisterAccess& access, const DriveBackup& backup, const DriveIdentity& drive, bool force)
{
    const auto isOther = [&](const DriveIdentity& kept) {
        return kept.serialNumber != drive.serialNumber && !force;
    };
    const auto other = [&](const DriveIdentity& kept) {
        return fail(ErrorCode::OtherDrive,
            {{"expected", kept.serialNumber}, {"found", drive.serialNumber}});
    };
    if (backup.drive && isOther(*backup.drive))
        return other(*backup.drive);
    for (const AxisBackup& axis : backup.axes) {
        if (isOther(axis.drive))
            return other(axis.drive);
        if (axis.axis < 0 || axis.axis >= drive.axes)
            return fail(ErrorCode::AxisNotFound,
                {{"axis", axis.axis},
                    {"known",
                        AXISCOMP_TEXT("Error", "{number} to {number2}")
                            .with("number", 0)
                            .with("number2", drive.axes - 1)}});
        AXISCOMP_CHECK(checkTableKept(access, axis));
    }
    return {};
}

Result<WriteRequest> restoreRequest(
    const RegisterAccess& access, SourceDirectory& sources, const AxisBackup& backup)
{
    WriteRequest request;
    AXISCOMP_TRY(auto axis, checkSameAxis(access, sources, backup));
    request.doubts = std::move(axis.doubts);
    request.origin = axis.hasSameName ? TableOrigin::Axis : TableOrigin::Drive;
    const AxisBackup::File* file = usedFile(access, backup);
    if (file) {
        AXISCOMP_TRY(auto decoded, decodeTamTable(file->bytes, access.profile().layout));
        request.dimensionality = decoded.table.grid.dimensions();
        request.table = std::move(decoded.table);
        request.persistency = file->persistent ? Persistency::Persistent : Persistency::Volatile;
    } else {
        // The slot that the axis named held nothing, and may hold somebody else's table by now.
        request.withoutTable = true;
        request.dimensionality = dimensionsOfBackup;
        AXISCOMP_TRY(request.leavesEmptySlot, holdsRegisters(access, sources, backup));
    }
    request.sources = sourceTexts(access, backup, request.dimensionality);
    const auto missing = std::ranges::find(request.sources, std::string());
    if (file && missing != request.sources.end())
        return fail(
            ErrorCode::SourceMissing, {{"dimension", missing - request.sources.begin() + 1}});
    return request;
}

std::uint32_t sourceAddress(
    const RegisterAccess& access, const std::vector<RegisterWrite>& registers, int axis, int n)
{
    const auto source = std::ranges::find(
        registers, access.axisPath(access.registers().source, axis, n), &RegisterWrite::path);
    const double address = source == registers.end() ? 0.0 : toDouble(source->value);
    return address >= 1.0 && address <= 4294967295.0 ? static_cast<std::uint32_t>(address) : 0;
}

std::string sourcePath(const AxisBackup& backup, int n)
{
    const auto dimension = static_cast<std::size_t>(n) - 1;
    return dimension < backup.sourcePaths.size() ? backup.sourcePaths[dimension] : std::string();
}

std::vector<std::string> sourceTexts(
    const RegisterAccess& access, const AxisBackup& backup, int count)
{
    std::vector<std::string> texts;
    for (int n = 1; n <= count; ++n) {
        const std::uint32_t address = sourceAddress(access, backup.registers, backup.axis, n);
        const std::string path = sourcePath(backup, n);
        texts.push_back(address == 0 ? "" : path.empty() ? hexAddress(address) : path);
    }
    return texts;
}

Result<UnfinishedOutcome> unfinishedOutcome(const RegisterAccess& access, const DriveStore& store,
    const DriveIdentity& drive, const JournalEntry& entry, SourceDirectory& sources)
{
    using Outcome = UnfinishedOutcome;
    AXISCOMP_TRY(auto status, readStatus(access, drive, entry.axis, sources));
    const bool deletes = !entry.deletedSlot.empty();
    bool hasNewTable = status.setup.slot == entry.newSlot && status.setup.tableCrc == entry.newCrc
        && (deletes || (status.setup.persistency == Persistency::Persistent) == entry.persistent);
    AxisBackup wanted{drive, entry.axis, {}, {}, entry.newRegisters, {}};
    wanted.sourcePaths = entry.newSourcePaths;
    AXISCOMP_TRY(auto hasNewRegisters, holdsRegisters(access, sources, wanted));
    if (hasNewTable && hasNewRegisters) {
        AXISCOMP_TRY(hasNewTable, holdsNewTable(access, store, entry));
    }
    if (hasNewTable && hasNewRegisters && deletes) {
        AXISCOMP_TRY(const bool isDeleted, isSlotEmpty(access, entry.deletedSlot));
        const bool isSaved = !entry.persistent || stepRank(entry.step) >= stepRank("delete");
        if (isDeleted)
            return isSaved ? Outcome::New : Outcome::NewUnsaved;
        return UnfinishedWrite::load(access, entry) ? Outcome::Neither : Outcome::Unknown;
    }
    if (hasNewTable && hasNewRegisters)
        return entry.persistent ? Outcome::NewUnsaved : Outcome::New;

    const auto write = UnfinishedWrite::load(access, entry);
    if (!write)
        return Outcome::Unknown;
    AXISCOMP_TRY(auto hasOldRegisters, holdsRegisters(access, sources, write->before()));
    if (!hasOldRegisters)
        return Outcome::Neither;
    const AxisBackup::File* old = usedFile(access, write->before());
    if (!old)
        return Outcome::Old;
    // The file alone may be one that somebody on the way has kept.
    if (!isShownTable(access.profile(), status.table, old->bytes))
        return Outcome::Neither;
    auto bytes = access.link().download(old->path, access.exchange());
    if (!bytes && bytes.error().code != ErrorCode::UnknownFile)
        return fail(bytes.error());
    return bytes && compareFiles(old->path, *bytes, old->bytes) ? Outcome::Old : Outcome::Neither;
}

} // namespace axiscomp
