// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/drive_store.h"

#include "core/io/local_file.h"
#include "core/io/system.h"
#include "core/store/backup_folder.h"
#include "core/store/json_import.h"
#include "core/store/store_database.h"
#include "core/store/store_folder.h"
#include "core/store/store_records.h"

#include <algorithm>
#include <utility>

namespace axiscomp {

namespace {

/// Bytes that a kept table may have: several times what the largest slot of a drive holds.
constexpr std::uint64_t maximumKeptTableSize = 16 * 1024 * 1024;

/// Whether the file holds the backup that was written as this text.
Result<void> checkBackup(const std::filesystem::path& file, const std::string& text)
{
    AXISCOMP_TRY(auto bytes, loadFile(file, maximumBackupSize));
    AXISCOMP_TRY(auto readBack, readBackup(asText(bytes), file.string()));
    // As texts, because a register may hold NaN, which differs from itself.
    if (writeBackup(readBack) != text)
        return fail(ErrorCode::FileNotWritable,
            {{"file", file.string()},
                {"reason", AXISCOMP_TEXT("Error", "it does not read back as it was written")}});
    return {};
}

/// unfinished: the axis's journal, whose backup stays however old it is.
Result<std::filesystem::path> keepBackup(const StoreFolder& folder, const DriveBackup& backup,
    WallTime time, std::optional<int> axis, const Result<std::optional<JournalEntry>>& unfinished)
{
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    AXISCOMP_CHECK(makePrivateFolder(folder.backups()));

    const std::filesystem::path file = newBackupFile(folder, time, axis);
    const std::string text = writeBackup(backup);
    AXISCOMP_CHECK(saveFile(file, asBytes(text)));
    if (auto same = checkBackup(file, text); !same) {
        (void)removeFile(file);
        return fail(same.error());
    }
    // A journal that cannot be read may name any of them.
    if (unfinished)
        pruneBackups(
            folder, axis, file, *unfinished ? (*unfinished)->backup : std::filesystem::path());
    return file;
}

} // namespace

DriveStore::DriveStore(std::filesystem::path root, std::chrono::milliseconds lockWait)
    : m_root(std::move(root))
    , m_lockWait(lockWait)
    , m_database(std::make_unique<StoreDatabase>(m_root, lockWait))
{
}

DriveStore::~DriveStore() = default;
DriveStore::DriveStore(DriveStore&& other) noexcept = default;

std::filesystem::path DriveStore::defaultRoot()
{
    return system::stateFolder() / "axiscomp";
}

Result<std::filesystem::path> DriveStore::saveBackup(
    const AxisBackup& backup, const std::vector<AxisBackup::File>& otherFiles)
{
    const StoreFolder folder{m_root, backup.drive.serialNumber, m_lockWait};
    DriveBackup ofAxis;
    ofAxis.axes = {backup};
    ofAxis.otherFiles = otherFiles;
    return keepBackup(
        folder, ofAxis, backup.time, backup.axis, journal(backup.drive.serialNumber, backup.axis));
}

Result<std::filesystem::path> DriveStore::saveBackup(
    const DriveIdentity& drive, WallTime time, const AxisBackup::File& file)
{
    const StoreFolder folder{m_root, drive.serialNumber, m_lockWait};
    DriveBackup ofFile;
    ofFile.drive = drive;
    ofFile.otherFiles = {file};
    return keepBackup(folder, ofFile, time, std::nullopt, std::nullopt);
}

std::vector<std::filesystem::path> DriveStore::backups(std::int32_t serialNumber, int axis) const
{
    return backupFiles(StoreFolder{m_root, serialNumber, m_lockWait}, axis);
}

Result<JournalEntry::KeptTable> DriveStore::keepTable(
    std::int32_t serialNumber, int axis, ByteView bytes)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    JournalEntry::KeptTable table{{}, bytes.size(), crc32(bytes)};
    // Named after its content, so that the table of an entry that is still there stays.
    table.file = folder.keptTable(axis, table.crc);
    AXISCOMP_CHECK(checkOrdinaryFile(table.file));
    AXISCOMP_CHECK(saveFile(table.file, bytes));
    return table;
}

Result<Bytes> DriveStore::keptTable(const JournalEntry::KeptTable& table) const
{
    auto bytes = loadOrdinaryFile(table.file, maximumKeptTableSize);
    if (bytes && (bytes->size() != table.size || crc32(*bytes) != table.crc))
        return fail(ErrorCode::FileNotReadable,
            {{"file", table.file.string()},
                {"reason",
                    AXISCOMP_TEXT("Error",
                        "it is not the table that was kept there: its size or CRC differs")}});
    return bytes;
}

Result<void> DriveStore::openJournal(const JournalEntry& entry)
{
    const StoreFolder folder{m_root, entry.serialNumber, m_lockWait};
    AXISCOMP_CHECK(m_database->change([&](sqlite::Connection& database) {
        records::putJournal(database, entry, folder.path());
    }));
    return dropJournalOfOlderVersion(m_root, entry.serialNumber, entry.axis);
}

Result<void> DriveStore::closeJournal(std::int32_t serialNumber, int axis)
{
    if (!hasStore(m_root))
        return {};
    AXISCOMP_CHECK(m_database->change([&](sqlite::Connection& database) {
        records::removeJournal(database, serialNumber, axis);
    }));
    AXISCOMP_CHECK(dropJournalOfOlderVersion(m_root, serialNumber, axis));
    for (const auto& table : StoreFolder{m_root, serialNumber, m_lockWait}.keptTables(axis))
        (void)removeFile(table);
    return {};
}

Result<std::optional<JournalEntry>> DriveStore::journal(std::int32_t serialNumber, int axis)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    AXISCOMP_TRY(
        auto entry, m_database->get<std::optional<JournalEntry>>([&](sqlite::Connection& database) {
            return records::journal(database, serialNumber, axis, folder.path());
        }));
    if (entry)
        return entry;
    return journalOfOlderVersion(m_root, serialNumber, axis);
}

Result<DriveStore::FlashHistory> DriveStore::flashHistory(std::int32_t serialNumber)
{
    return m_database->get<FlashHistory>([&](sqlite::Connection& database) {
        return records::flashHistory(database, serialNumber, m_root);
    });
}

Result<void> DriveStore::recordFlash(std::int32_t serialNumber, WallTime now, int operations)
{
    if (operations <= 0)
        return {};
    return m_database->change([&](sqlite::Connection& database) {
        records::addFlash(database, serialNumber, now, static_cast<std::uint64_t>(operations));
    });
}

Result<void> DriveStore::recordFlashRefusal(
    std::int32_t serialNumber, WallTime now, std::chrono::seconds wait)
{
    if (wait <= std::chrono::seconds{0})
        return {};
    return m_database->change([&](sqlite::Connection& database) {
        records::setFlashRefusal(database, serialNumber, {now, wait});
    });
}

Result<void> DriveStore::acceptFlashLoss(std::int32_t serialNumber)
{
    return m_database->change(
        [&](sqlite::Connection& database) { records::acceptFlashLoss(database, serialNumber); });
}

FlashWearGuard wearGuard(const FlashWearLimits& limits, const DriveStore::FlashHistory& history)
{
    FlashWearGuard guard(limits, history.recent);
    if (history.refusal)
        guard.recordRefusal(history.refusal->time, history.refusal->wait);
    if (history.damagedRecord)
        guard.recordLoss();
    return guard;
}

Result<std::vector<DriveStore::OwnTable>> DriveStore::ownTables(std::int32_t serialNumber, int axis)
{
    return m_database->get<std::vector<OwnTable>>([&](sqlite::Connection& database) {
        return records::ownTables(database, serialNumber, axis);
    });
}

Result<void> DriveStore::recordOwnTable(std::int32_t serialNumber, int axis, const OwnTable& table)
{
    return m_database->change([&](sqlite::Connection& database) {
        records::addOwnTable(database, serialNumber, axis, table);
    });
}

Result<void> DriveStore::recordMeasured(
    std::int32_t serialNumber, int axis, const MeasuredFigures& measured, Measuring measuring)
{
    return m_database->change([&](sqlite::Connection& database) {
        records::putMeasured(database, serialNumber, axis, measured, measuring);
    });
}

Result<std::optional<MeasuredFigures>> DriveStore::measured(
    std::int32_t serialNumber, int axis, std::uint32_t crc)
{
    return m_database->get<std::optional<MeasuredFigures>>([&](sqlite::Connection& database) {
        return records::measured(database, serialNumber, axis, crc);
    });
}

Result<SavedState> DriveStore::savedState(std::int32_t serialNumber)
{
    return m_database->get<SavedState>(
        [&](sqlite::Connection& database) { return records::savedState(database, serialNumber); });
}

Result<void> DriveStore::recordSaving(
    std::int32_t serialNumber, const std::vector<SavedState::Use>& uses)
{
    return m_database->change(
        [&](sqlite::Connection& database) { records::addUses(database, serialNumber, uses); });
}

Result<void> DriveStore::recordSaved(
    std::int32_t serialNumber, const std::vector<SavedState::Use>& uses)
{
    return m_database->change(
        [&](sqlite::Connection& database) { records::replaceUses(database, serialNumber, uses); });
}

Result<void> DriveStore::recordCovered(
    std::int32_t serialNumber, const std::string& slot, bool isCovered)
{
    return m_database->change([&](sqlite::Connection& database) {
        records::setCovered(database, serialNumber, slot, isCovered);
    });
}

Result<FileLock> DriveStore::lockWrites(std::int32_t serialNumber)
{
    auto lock = StoreFolder{m_root, serialNumber, m_lockWait}.lock(StoreFolder::writeLock);
    if (!lock)
        lock.error().context.set(missingLock, Verbatim{StoreFolder::writeLock});
    return lock;
}

Result<std::optional<FileLock>> DriveStore::tryLockWrites(std::int32_t serialNumber)
{
    return StoreFolder{m_root, serialNumber, m_lockWait}.tryLock(StoreFolder::writeLock);
}

} // namespace axiscomp
