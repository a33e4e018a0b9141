// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/kept_backup.h"

#include "core/io/local_file.h"
#include "core/store/backup_folder.h"
#include "core/table/tam_table.h"

#include <algorithm>

namespace axiscomp {

namespace {

std::string usedSlot(const AxisBackup& backup, const DriveProfile& profile)
{
    const std::string path =
        expandPath(profile.registers.table, {.axis = backup.axis, .slot = {}, .n = {}});
    const auto found = std::ranges::find(backup.registers, path, &RegisterWrite::path);
    return found == backup.registers.end() ? std::string() : toText(found->value);
}

KeptBackup toChoose(
    const std::filesystem::path& file, AxisBackup&& backup, const DriveProfile& profile)
{
    KeptBackup kept;
    kept.file = file;
    kept.axis = backup.axis;
    kept.time = backup.time;
    kept.drive = std::move(backup.drive);
    kept.axisName = std::move(backup.axisName);
    kept.unit = std::move(backup.unit);
    kept.registers = std::move(backup.registers);
    if (backup.files.empty() || backup.files.front().bytes.empty())
        return kept;
    const AxisBackup::File& used = backup.files.front();
    auto decoded = decodeTamTable(used.bytes, profile.layout);
    if (!decoded) {
        kept.problem = std::move(decoded.error());
        return kept;
    }
    kept.slot = used.slot;
    kept.isPersistent = used.persistent;
    const std::size_t elements = decoded->table.values.size() * sizeof(float);
    kept.tableCrc = crc32(ByteView(used.bytes).last(elements));
    kept.table = std::make_shared<const CompensationTable>(std::move(decoded->table));
    return kept;
}

/// The slot may be another one: an axis uses two in turn.
bool sameTable(const KeptBackup& one, const KeptBackup& other)
{
    if (!one.table || !other.table)
        return !one.table && !other.table;
    return one.tableCrc == other.tableCrc && sameSpans(one.table->grid, other.table->grid);
}

/// The register Table differs from slot to slot, also with the same table in both.
bool sameSettings(const KeptBackup& one, const KeptBackup& other, const DriveProfile& profile)
{
    const std::string table =
        expandPath(profile.registers.table, {.axis = one.axis, .slot = {}, .n = {}});
    const auto sources = [&](const KeptBackup& backup) {
        std::vector<RegisterWrite> registers = backup.registers;
        std::erase_if(registers, [&](const RegisterWrite& r) { return r.path == table; });
        return registers;
    };
    return one.isPersistent == other.isPersistent && sources(one) == sources(other);
}

/// A backup shows what the write before it has left.
void sayWrites(std::vector<KeptBackup>& newestFirst, const DriveProfile& profile)
{
    using Write = KeptBackup::Write;
    for (std::size_t i = 1; i < newestFirst.size(); ++i) {
        const KeptBackup& after = newestFirst[i - 1];
        KeptBackup& before = newestFirst[i];
        if (before.problem || after.problem)
            continue;
        before.write = !sameTable(before, after)   ? after.table ? Write::NewTable : Write::NoTable
            : sameSettings(before, after, profile) ? Write::Nothing
                                                   : Write::Settings;
    }
}

} // namespace

Result<std::vector<AxisBackup>> axisBackupsIn(
    const std::filesystem::path& file, const DriveProfile& profile)
{
    AXISCOMP_TRY(const auto bytes, loadOrdinaryFile(file, maximumBackupSize));
    AXISCOMP_TRY(auto backup, readBackup(asText(bytes), file.string()));
    for (AxisBackup& axis : backup.axes) {
        const std::string used = usedSlot(axis, profile);
        std::erase_if(axis.files, [&](const AxisBackup::File& kept) { return kept.slot != used; });
    }
    return std::move(backup.axes);
}

std::vector<KeptBackup> backupsToChoose(
    const std::filesystem::path& file, const DriveProfile& profile)
{
    auto axes = axisBackupsIn(file, profile);
    std::vector<KeptBackup> backups;
    if (!axes) {
        backups.emplace_back();
        backups.front().file = file;
        backups.front().problem = std::move(axes.error());
        return backups;
    }
    for (AxisBackup& axis : *axes)
        backups.push_back(toChoose(file, std::move(axis), profile));
    return backups;
}

std::vector<KeptBackup> backupsToChoose(
    const DriveStore& store, const DriveIdentity& drive, const DriveProfile& profile)
{
    std::vector<KeptBackup> all;
    for (int axis = 0; axis < drive.axes; ++axis) {
        std::vector<KeptBackup> ofAxis;
        for (const std::filesystem::path& file : store.backups(drive.serialNumber, axis)) {
            for (KeptBackup& backup : backupsToChoose(file, profile)) {
                if (backup.problem) {
                    backup.axis = axis;
                    backup.time = timeOfBackup(file, axis);
                }
                ofAxis.push_back(std::move(backup));
            }
        }
        sayWrites(ofAxis, profile);
        std::ranges::move(ofAxis, std::back_inserter(all));
    }
    std::ranges::stable_sort(all, std::greater<>{}, &KeptBackup::time);
    return all;
}

} // namespace axiscomp
