// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_condition.h"

#include "core/io/file_lock.h"
#include "core/io/local_file.h"
#include "core/io/system.h"
#include "core/store/json_import.h"
#include "core/store/store_folder.h"
#include "core/store/store_records.h"
#include "core/store/store_repair.h"
#include "core/store/store_schema.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace axiscomp {

namespace {

namespace fs = std::filesystem;
using Database = StoreCondition::Database;

/// What belongs to a database beside it; the shared memory is made anew from the log.
constexpr std::array copiedEndings{"", "-wal", "-journal"};
/// A copy is taken again when a program has written meanwhile.
constexpr int mostCopies = 5;
/// Far more than what drives leave in years.
constexpr std::uint64_t mostBytes = 256ULL * 1024 * 1024;

/// A file as it was at a moment; all 0: there was none.
struct FileMoment {
    system::FileIdentity identity{};
    std::uint64_t size = 0;
    WallTime lastChange{};

    friend bool operator==(const FileMoment&, const FileMoment&) = default;
};
using DatabaseMoment = std::array<FileMoment, copiedEndings.size()>;

DatabaseMoment momentOf(const fs::path& database)
{
    DatabaseMoment moment{};
    for (std::size_t n = 0; n < copiedEndings.size(); ++n) {
        const fs::path file = withEnding(database, copiedEndings[n]);
        if (const auto state = system::linkStateOf(file))
            moment[n] = {system::identityOf(file).value_or(system::FileIdentity{}), state->size,
                state->lastChange};
    }
    return moment;
}

Result<void> copyFile(const fs::path& from, const fs::path& to)
{
    if (isMissing(from))
        return removeFile(to);
    AXISCOMP_TRY(const auto bytes, loadOrdinaryFile(from, mostBytes));
    return saveFile(to, bytes);
}

/// false: programs write to it all the time. Errors: FileNotReadable, FileTooLarge,
/// FileNotWritable.
Result<bool> copyDatabase(const fs::path& from, const fs::path& to)
{
    for (int attempt = 0; attempt < mostCopies; ++attempt) {
        const DatabaseMoment before = momentOf(from);
        for (const char* ending : copiedEndings)
            AXISCOMP_CHECK(copyFile(withEnding(from, ending), withEnding(to, ending)));
        if (momentOf(from) == before)
            return true;
    }
    return false;
}

Database databaseOf(StoreIdentity identity)
{
    switch (identity) {
    case StoreIdentity::Ours:
        return Database::Usable;
    case StoreIdentity::Older:
        return Database::Older;
    case StoreIdentity::Newer:
        return Database::Newer;
    case StoreIdentity::Foreign:
        break;
    }
    return Database::Foreign;
}

/// Throws what SQLite finds wrong.
void checkCopy(const fs::path& copy, const fs::path& root, StoreCondition& condition)
{
    checkStoreFile(copy);
    sqlite::Connection connection(copy, std::chrono::milliseconds{0});
    condition.database = databaseOf(storeIdentity(connection));
    if (condition.database == Database::Newer || condition.database == Database::Foreign)
        return;
    checkStorePages(connection);
    for (JournalEntry& entry : records::journals(connection))
        condition.unfinished.push_back({std::move(entry)});
    condition.flashLoss = records::drivesWithFlashLoss(connection, root);
}

void lookAtDatabase(const fs::path& root, const fs::path& scratch, StoreCondition& condition)
{
    const fs::path usual = root / databaseName;
    const fs::path database = recoveredFile(usual).value_or(usual);
    const fs::path copy = scratch / databaseName;
    const DatabaseMoment moment = momentOf(database);
    if (moment == DatabaseMoment{})
        return;
    WallTime lastChange{};
    for (const FileMoment& file : moment) {
        condition.bytes += file.size;
        lastChange = std::max(lastChange, file.lastChange);
    }
    condition.lastChange = std::chrono::floor<std::chrono::seconds>(lastChange);
    condition.isWritable = isMissing(database) || system::mayReadAndWrite(database);
    const auto copied = copyDatabase(database, copy);
    if (!copied || !*copied) {
        const bool isForLackOfRoom = !copied && copied.error().code == ErrorCode::FileNotWritable;
        condition.database = copied ? Database::Busy
            : isForLackOfRoom       ? Database::NotCopied
                                    : Database::Unreadable;
        condition.reason = copied ? Text() : textOf(copied.error());
        return;
    }
    try {
        checkCopy(copy, root, condition);
    } catch (const sqlite::Failure& failure) {
        condition.database = failure.isDamage() ? Database::Damaged : Database::Unreadable;
        condition.reason =
            failure.reason.isEmpty() ? Text(Verbatim{failure.message}) : failure.reason;
    }
}

void lookAtBackups(const fs::path& folder, StoreCondition& condition)
{
    for (const fs::path& file : filesIn(folder)) {
        std::error_code error;
        const std::uint64_t size = fs::file_size(file, error);
        if (error || file.extension() != ".json")
            continue;
        ++condition.backups;
        condition.backupBytes += size;
    }
}

} // namespace

StoreCondition lookAtStore(const fs::path& root, const fs::path& scratch)
{
    StoreCondition condition;
    lookAtDatabase(root, scratch, condition);
    for (auto& journal : journalsOfOlderVersion(root)) {
        if (journal)
            condition.unfinished.push_back({*std::move(journal)});
        else
            condition.damagedJournals.push_back(std::move(journal).error());
    }
    const auto folderOf = [&](std::int32_t serialNumber) {
        return StoreFolder{root, serialNumber, std::chrono::milliseconds{0}};
    };
    for (StoreCondition::Write& write : condition.unfinished)
        write.isBeingDone =
            FileLock::isHeld(folderOf(write.entry.serialNumber).path() / StoreFolder::writeLock);
    for (const std::int32_t serialNumber : drivesIn(root)) {
        ++condition.drives;
        lookAtBackups(folderOf(serialNumber).backups(), condition);
    }
    condition.setAside = storesSetAside(root / databaseName);
    return condition;
}

} // namespace axiscomp
