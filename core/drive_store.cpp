// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_store.h"

#include "core/store_documents.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <system_error>
#include <utility>

#include <cerrno>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

namespace axiscomp {

namespace {

constexpr std::size_t keptBackups = 50;
constexpr std::size_t keptFlashOperations = 1000;
constexpr std::ptrdiff_t keptTablesPerSlot = 4;

/// Only for the user: who may change these files could make the program write to the wrong slot.
Result<void> makeFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    if (folder.empty() || std::filesystem::is_directory(folder, error))
        return {};
    if (auto parent = makeFolder(folder.parent_path()); !parent)
        return parent;
    if (::mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
        return fail(ErrorCode::FileNotWritable,
            {{"file", folder.string()}, {"reason", fileErrorReason(errno)}});
    return {};
}

std::string axisSuffix(int axis)
{
    return "-axis" + std::to_string(axis);
}

/// "2026-11-21T08-02-23.5Z-axis0.json", "...-axis0-2.json": sorts by time, colons are not welcome
/// on every file system.
std::string backupName(WallTime time, int axis, int number)
{
    std::string stamp = utcText(time);
    std::ranges::replace(stamp, ':', '-');
    return stamp + axisSuffix(axis) + (number > 1 ? "-" + std::to_string(number) : "") + ".json";
}

struct BackupFile {
    WallTime time{};
    int number = 1;
    std::filesystem::path path;
};

/// The file as one of saveBackup's for the axis, if it is one.
std::optional<BackupFile> asBackupFile(const std::filesystem::path& path, int axis)
{
    const std::string name = path.filename().string();
    const std::size_t end = name.find(axisSuffix(axis));
    if (end == std::string::npos || end < 19)
        return std::nullopt;
    std::string stamp = name.substr(0, end);
    stamp[13] = stamp[16] = ':';
    const auto time = utcFromText(stamp);
    if (!time)
        return std::nullopt;

    BackupFile file{*time, 1, path};
    const std::size_t number = end + axisSuffix(axis).size();
    if (name.substr(number).starts_with("-"))
        std::from_chars(name.data() + number + 1, name.data() + name.size(), file.number);
    return name == backupName(file.time, axis, file.number) ? std::optional(file) : std::nullopt;
}

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::directory_iterator i{folder, error}, end; i != end && !error;
         i.increment(error))
        files.push_back(i->path());
    return files;
}

bool isMissing(const std::filesystem::path& file)
{
    std::error_code error;
    return std::filesystem::symlink_status(file, error).type()
        == std::filesystem::file_type::not_found;
}

} // namespace

/// The folder of one drive.
class DriveStore::Folder {
public:
    Folder(const DriveStore& store, std::int32_t serialNumber)
        : m_path(store.m_root / std::to_string(serialNumber))
        , m_lockWait(store.m_lockWait)
    {
    }

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    [[nodiscard]] std::filesystem::path backups() const { return m_path / "backups"; }
    [[nodiscard]] std::filesystem::path journal(int axis) const
    {
        return m_path / ("journal" + axisSuffix(axis) + ".json");
    }
    [[nodiscard]] std::filesystem::path flashHistory() const { return m_path / "flash.json"; }
    [[nodiscard]] std::filesystem::path tables() const { return m_path / "tables.json"; }

    /// Makes the folder too.
    [[nodiscard]] Result<FileLock> lock(const char* name = "lock") const
    {
        if (auto made = makeFolder(m_path); !made)
            return fail(made.error());
        return FileLock::acquire(m_path / name, m_lockWait, m_path);
    }

    /// What the file says; nothing when it does not exist; a broken one is moved aside. To be
    /// called under the lock.
    template <typename T, typename Parse>
    [[nodiscard]] Result<T> take(const std::filesystem::path& file, const Parse& parse) const
    {
        auto value = read<T>(file, parse);
        if (!value)
            return fail(value.error());
        if (*value)
            return **std::move(value);
        if (auto moved = moveAside(file); !moved)
            return fail(moved.error());
        return T{};
    }

    /// The same, taking the lock only when there is something to move.
    template <typename T, typename Parse>
    [[nodiscard]] Result<T> look(const std::filesystem::path& file, const Parse& parse) const
    {
        auto value = read<T>(file, parse);
        if (!value)
            return fail(value.error());
        if (*value)
            return **std::move(value);
        auto held = lock();
        if (!held)
            return fail(held.error());
        return take<T>(file, parse);
    }

    void clean(int axis, const std::filesystem::path& newest) const;

private:
    /// Nothing: the file is broken.
    template <typename T, typename Parse>
    [[nodiscard]] static Result<std::optional<T>> read(
        const std::filesystem::path& file, const Parse& parse)
    {
        if (isMissing(file))
            return T{};
        auto bytes = loadFile(file, maximumDocumentSize);
        if (!bytes && !isBroken(file, bytes.error()))
            return fail(bytes.error());
        if (bytes)
            if (auto value = parse(asText(*bytes)))
                return *std::move(value);
        return std::nullopt;
    }

    [[nodiscard]] static Result<void> moveAside(const std::filesystem::path& file)
    {
        std::filesystem::path aside = file;
        aside += ".broken";
        std::error_code error;
        std::filesystem::remove_all(aside, error);
        std::filesystem::rename(file, aside, error);
        if (!error)
            return {};
        return fail(ErrorCode::FileNotWritable,
            {{"file", file.string()},
                {"reason",
                    "it is damaged and cannot be moved aside (" + fileErrorReason(error.value())
                        + "); delete it"}});
    }

    static bool isBroken(const std::filesystem::path& file, const Error& error)
    {
        std::error_code ignored;
        return error.code == ErrorCode::FileTooLarge
            || std::filesystem::is_directory(file, ignored);
    }

    std::filesystem::path m_path;
    std::chrono::milliseconds m_lockWait;
};

/// Deletes old backups of the axis and what a crash left behind. What cannot be deleted stays: the
/// new backup is there, and that is what counts.
void DriveStore::Folder::clean(int axis, const std::filesystem::path& newest) const
{
    std::error_code ignored;
    for (const std::filesystem::path& folder : {m_path, backups()})
        for (const std::filesystem::path& file : filesIn(folder))
            if (isTemporaryFile(file))
                std::filesystem::remove(file, ignored);

    std::filesystem::path inJournal;
    if (auto bytes = loadFile(journal(axis), maximumDocumentSize)) {
        const auto entry = readJournal(asText(*bytes), m_path);
        if (!entry)
            return; // it may name any of them
        inJournal = entry->backup;
    }
    std::vector<BackupFile> old;
    for (const std::filesystem::path& file : filesIn(backups()))
        if (auto backup = asBackupFile(file, axis); backup && file != newest)
            old.push_back(*std::move(backup));
    std::ranges::sort(old, std::greater<>{},
        [](const BackupFile& file) { return std::pair(file.time, file.number); });
    for (std::size_t i = keptBackups - 1; i < old.size(); ++i)
        if (old[i].path != inJournal)
            std::filesystem::remove(old[i].path, ignored);
}

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
    const Folder folder{*this, backup.drive.serialNumber};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    if (auto made = makeFolder(folder.backups()); !made)
        return fail(made.error());

    std::filesystem::path file;
    for (int number = 1; file.empty() || !isMissing(file); ++number)
        file = folder.backups() / backupName(backup.time, backup.axis, number);
    DriveBackup ofAxis;
    ofAxis.axes = {backup};
    const std::string text = writeBackup(ofAxis);
    if (auto saved = saveFile(file, asBytes(text)); !saved)
        return fail(saved.error());

    auto bytes = loadFile(file, maximumBackupSize);
    if (!bytes)
        return fail(bytes.error());
    auto readBack = readBackup(asText(*bytes), file.string());
    if (!readBack)
        return fail(readBack.error());
    // As texts, because a register may hold NaN, which differs from itself.
    if (writeBackup(*readBack) != text)
        return fail(ErrorCode::FileNotWritable,
            {{"file", file.string()}, {"reason", "it does not read back as it was written"}});
    folder.clean(backup.axis, file);
    return file;
}

Result<void> DriveStore::openJournal(const JournalEntry& entry)
{
    const Folder folder{*this, entry.serialNumber};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    return saveFile(folder.journal(entry.axis), asBytes(writeJournal(entry, folder.path())));
}

Result<void> DriveStore::closeJournal(std::int32_t serialNumber, int axis)
{
    const Folder folder{*this, serialNumber};
    if (isMissing(folder.journal(axis)))
        return {};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    return removeFile(folder.journal(axis));
}

Result<std::optional<JournalEntry>> DriveStore::journal(std::int32_t serialNumber, int axis)
{
    const Folder folder{*this, serialNumber};
    const std::filesystem::path file = folder.journal(axis);
    const auto broken = [&](const std::string& why) {
        return fail(ErrorCode::FileNotReadable,
            {{"file", file.string()},
                {"reason",
                    "it was kept about a write that did not end, but is damaged (" + why
                        + "). Look at what the drive holds, then delete the file"}});
    };
    if (isMissing(file))
        return std::nullopt;
    auto bytes = loadFile(file, maximumDocumentSize);
    if (!bytes && isMissing(file)) // closed by another program just now
        return std::nullopt;
    if (!bytes)
        return broken(sentence(bytes.error()));
    auto entry = readJournal(asText(*bytes), folder.path());
    if (!entry)
        return broken(entry.error());
    if (entry->serialNumber != serialNumber || entry->axis != axis)
        return broken("it is about axis " + std::to_string(entry->axis) + " of drive "
            + std::to_string(entry->serialNumber));
    return *std::move(entry);
}

Result<DriveStore::FlashHistory> DriveStore::flashHistory(std::int32_t serialNumber)
{
    const Folder folder{*this, serialNumber};
    return folder.look<FlashHistory>(folder.flashHistory(), readFlashHistory);
}

Result<void> DriveStore::recordFlash(std::int32_t serialNumber, WallTime now, int operations)
{
    if (operations <= 0)
        return {};
    const Folder folder{*this, serialNumber};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    auto history = folder.take<FlashHistory>(folder.flashHistory(), readFlashHistory);
    if (!history)
        return fail(history.error());

    const auto count = static_cast<std::size_t>(operations);
    std::vector<WallTime>& recent = history->recent;
    recent.insert(recent.end(), std::min(count, keptFlashOperations), now);
    if (recent.size() > keptFlashOperations)
        recent.erase(recent.begin(), recent.end() - keptFlashOperations);
    history->total += count;
    return saveFile(folder.flashHistory(), asBytes(writeFlashHistory(*history)));
}

Result<std::vector<DriveStore::OwnTable>> DriveStore::ownTables(std::int32_t serialNumber, int axis)
{
    const Folder folder{*this, serialNumber};
    auto written = folder.look<std::vector<WrittenTable>>(folder.tables(), readTables);
    if (!written)
        return fail(written.error());
    std::vector<OwnTable> own;
    for (const WrittenTable& table : *written)
        if (table.axis == axis)
            own.push_back(table.table);
    return own;
}

Result<void> DriveStore::recordOwnTable(std::int32_t serialNumber, int axis, const OwnTable& table)
{
    const Folder folder{*this, serialNumber};
    auto lock = folder.lock();
    if (!lock)
        return fail(lock.error());
    auto written = folder.take<std::vector<WrittenTable>>(folder.tables(), readTables);
    if (!written)
        return fail(written.error());

    std::vector<WrittenTable> tables{{axis, table}};
    for (const WrittenTable& older : *written) {
        const bool isSame = older.table == table;
        const auto ofSlot = std::ranges::count(
            tables, older.table.slot, [](const WrittenTable& kept) { return kept.table.slot; });
        if (!isSame && ofSlot < keptTablesPerSlot)
            tables.push_back(older);
    }
    return saveFile(folder.tables(), asBytes(writeTables(tables)));
}

Result<FileLock> DriveStore::lockWrites(std::int32_t serialNumber)
{
    return Folder{*this, serialNumber}.lock("write.lock");
}

} // namespace axiscomp
