// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/drive_store.h"

#include "core/store/backup_folder.h"
#include "core/store/store_folder.h"
#include "core/store/store_json.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include <pwd.h>
#include <unistd.h>

namespace axiscomp {

namespace {

constexpr std::size_t keptFlashOperations = 1000;
constexpr std::ptrdiff_t keptTablesPerSlot = 4;
constexpr const char* writeLock = "write.lock";

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

Result<std::filesystem::path> keepBackup(
    const StoreFolder& folder, const DriveBackup& backup, WallTime time, std::optional<int> axis)
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
    pruneBackups(folder, axis, file);
    return file;
}

} // namespace

DriveStore::DriveStore(std::filesystem::path root, std::chrono::milliseconds lockWait)
    : m_root(std::move(root))
    , m_lockWait(lockWait)
{
}

std::filesystem::path DriveStore::defaultRoot()
{
    // The XDG specification wants relative paths to be ignored.
    const auto absolutePath = [](const char* name) {
        const char* const value = std::getenv(name);
        return value != nullptr && *value == '/' ? std::filesystem::path(value)
                                                 : std::filesystem::path();
    };
    if (const std::filesystem::path state = absolutePath("XDG_STATE_HOME"); !state.empty())
        return state / "axiscomp";
    std::filesystem::path home = absolutePath("HOME");
    if (home.empty()) {
        std::array<char, 16384> buffer{};
        struct passwd entry { };
        struct passwd* found = nullptr;
        if (::getpwuid_r(::geteuid(), &entry, buffer.data(), buffer.size(), &found) == 0 && found)
            home = entry.pw_dir;
    }
    return home / ".local" / "state" / "axiscomp";
}

Result<std::filesystem::path> DriveStore::saveBackup(const AxisBackup& backup)
{
    const StoreFolder folder{m_root, backup.drive.serialNumber, m_lockWait};
    DriveBackup ofAxis;
    ofAxis.axes = {backup};
    return keepBackup(folder, ofAxis, backup.time, backup.axis);
}

Result<std::filesystem::path> DriveStore::saveBackup(
    const DriveIdentity& drive, WallTime time, const AxisBackup::File& file)
{
    const StoreFolder folder{m_root, drive.serialNumber, m_lockWait};
    DriveBackup ofFile;
    ofFile.drive = drive;
    ofFile.otherFiles = {file};
    return keepBackup(folder, ofFile, time, std::nullopt);
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
    AXISCOMP_CHECK(saveFile(table.file, bytes));
    return table;
}

Result<Bytes> DriveStore::keptTable(const JournalEntry::KeptTable& table) const
{
    auto bytes = loadFile(table.file, maximumKeptTableSize);
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
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    return saveFile(folder.journal(entry.axis), asBytes(writeJournal(entry, folder.path())));
}

Result<void> DriveStore::closeJournal(std::int32_t serialNumber, int axis)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    if (isMissing(folder.journal(axis)))
        return {};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    if (auto removed = removeFile(folder.journal(axis)); !removed)
        return removed;
    for (const std::filesystem::path& table : folder.keptTables(axis))
        (void)removeFile(table);
    return {};
}

Result<std::optional<JournalEntry>> DriveStore::journal(std::int32_t serialNumber, int axis)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    const std::filesystem::path file = folder.journal(axis);
    const auto broken = [&](const Text& why) {
        return fail(ErrorCode::FileNotReadable,
            {{"file", file.string()},
                {"reason",
                    AXISCOMP_TEXT("Error",
                        "it was kept about a write that did not end, but is damaged ({reason}). "
                        "Look at what the drive holds, then delete the file")
                        .with("reason", why)}});
    };
    if (isMissing(file))
        return std::nullopt;
    auto bytes = loadFile(file, maximumDocumentSize);
    if (!bytes && isMissing(file)) // closed by another program just now
        return std::nullopt;
    if (!bytes)
        return broken(textOf(bytes.error()));
    auto entry = readJournal(asText(*bytes), folder.path());
    if (!entry)
        return broken(entry.error());
    if (entry->serialNumber != serialNumber || entry->axis != axis)
        return broken(AXISCOMP_TEXT("Error", "it is about axis {axis} of drive {drive}")
                          .with("axis", entry->axis)
                          .with("drive", entry->serialNumber));
    return *std::move(entry);
}

Result<DriveStore::FlashHistory> DriveStore::flashHistory(std::int32_t serialNumber)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    return folder.look<FlashHistory>(folder.flashHistory(), readFlashHistory);
}

template <typename Change>
Result<void> DriveStore::changeFlashHistory(std::int32_t serialNumber, const Change& change)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    AXISCOMP_TRY(auto history, folder.take<FlashHistory>(folder.flashHistory(), readFlashHistory));
    change(history);
    return saveFile(folder.flashHistory(), asBytes(writeFlashHistory(history)));
}

Result<void> DriveStore::recordFlash(std::int32_t serialNumber, WallTime now, int operations)
{
    if (operations <= 0)
        return {};
    return changeFlashHistory(serialNumber, [&](FlashHistory& history) {
        const auto count = static_cast<std::size_t>(operations);
        std::vector<WallTime>& recent = history.recent;
        recent.insert(recent.end(), std::min(count, keptFlashOperations), now);
        if (recent.size() > keptFlashOperations)
            recent.erase(recent.begin(), recent.end() - keptFlashOperations);
        history.total += count;
    });
}

Result<void> DriveStore::recordFlashRefusal(
    std::int32_t serialNumber, WallTime now, std::chrono::seconds wait)
{
    if (wait <= std::chrono::seconds{0})
        return {};
    return changeFlashHistory(serialNumber, [&](FlashHistory& history) {
        history.refusal = FlashHistory::Refusal{now, wait};
    });
}

FlashWearGuard wearGuard(const FlashWearLimits& limits, const DriveStore::FlashHistory& history)
{
    FlashWearGuard guard(limits, history.recent);
    if (history.refusal)
        guard.recordRefusal(history.refusal->time, history.refusal->wait);
    return guard;
}

Result<std::vector<DriveStore::OwnTable>> DriveStore::ownTables(std::int32_t serialNumber, int axis)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    AXISCOMP_TRY(auto written, folder.look<std::vector<WrittenTable>>(folder.tables(), readTables));
    std::vector<OwnTable> own;
    for (const WrittenTable& table : written)
        if (table.axis == axis)
            own.push_back(table.table);
    return own;
}

Result<void> DriveStore::recordOwnTable(std::int32_t serialNumber, int axis, const OwnTable& table)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    AXISCOMP_TRY(auto written, folder.take<std::vector<WrittenTable>>(folder.tables(), readTables));

    std::vector<WrittenTable> tables{{axis, table}};
    for (const WrittenTable& older : written) {
        const bool isSame = older.table == table;
        const auto ofSlot = std::ranges::count(
            tables, older.table.slot, [](const WrittenTable& kept) { return kept.table.slot; });
        if (!isSame && ofSlot < keptTablesPerSlot)
            tables.push_back(older);
    }
    return saveFile(folder.tables(), asBytes(writeTables(tables)));
}

Result<SavedState> DriveStore::savedState(std::int32_t serialNumber)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    return folder.look<SavedState>(folder.saved(), readSavedState);
}

template <typename Change>
Result<void> DriveStore::changeSavedState(std::int32_t serialNumber, const Change& change)
{
    const StoreFolder folder{m_root, serialNumber, m_lockWait};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    AXISCOMP_TRY(auto state, folder.take<SavedState>(folder.saved(), readSavedState));
    const SavedState before = state;
    change(state);
    if (state == before)
        return {};
    return saveFile(folder.saved(), asBytes(writeSavedState(state)));
}

Result<void> DriveStore::recordSaving(
    std::int32_t serialNumber, const std::vector<SavedState::Use>& uses)
{
    return changeSavedState(serialNumber, [&](SavedState& state) {
        for (const SavedState::Use& use : uses)
            if (std::ranges::find(state.uses, use) == state.uses.end())
                state.uses.push_back(use);
    });
}

Result<void> DriveStore::recordSaved(
    std::int32_t serialNumber, const std::vector<SavedState::Use>& uses)
{
    return changeSavedState(serialNumber, [&](SavedState& state) {
        state.isKnown = true;
        state.uses = uses;
    });
}

Result<void> DriveStore::recordCovered(
    std::int32_t serialNumber, const std::string& slot, bool isCovered)
{
    return changeSavedState(serialNumber, [&](SavedState& state) {
        std::erase(state.covered, slot);
        if (isCovered)
            state.covered.push_back(slot);
    });
}

Result<FileLock> DriveStore::lockWrites(std::int32_t serialNumber)
{
    return StoreFolder{m_root, serialNumber, m_lockWait}.lock(writeLock);
}

Result<std::optional<FileLock>> DriveStore::tryLockWrites(std::int32_t serialNumber)
{
    return StoreFolder{m_root, serialNumber, m_lockWait}.tryLock(writeLock);
}

} // namespace axiscomp
