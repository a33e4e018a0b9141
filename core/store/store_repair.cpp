// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_repair.h"

#include "core/base/wall_time.h"
#include "core/io/local_file.h"
#include "core/store/sqlite.h"
#include "core/store/store_folder.h"
#include "core/store/store_records.h"
#include "core/store/store_schema.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <sqlite3.h>

namespace axiscomp {

namespace {

using sqlite::Connection;
using sqlite::Statement;
namespace fs = std::filesystem;

const std::string recoveredEnding = ".recovered-";
const std::string damagedEnding = ".damaged-";

std::vector<std::string> columnsOf(Connection& database, const std::string& table)
{
    std::vector<std::string> names;
    for (Statement info(database, "SELECT name FROM pragma_table_info(?1)", table); info.next();)
        names.push_back(info.text(0));
    return names;
}

/// Every row that can be read, from the beginning and, behind a damaged page, from the end. An
/// older version's table has fewer columns.
void copyReadable(Connection& from, Connection& to, const std::string& table)
{
    const std::vector<std::string> there = columnsOf(from, table);
    std::string columns;
    std::string places;
    for (const std::string& column : columnsOf(to, table)) {
        if (std::ranges::find(there, column) == there.end())
            continue;
        columns += (columns.empty() ? "" : ",") + column;
        places += places.empty() ? "?" : ",?";
    }
    if (columns.empty())
        return;
    Statement insert(
        to, "INSERT OR IGNORE INTO " + table + " (" + columns + ") VALUES (" + places + ")");
    for (const char* order : {"", " DESC"}) {
        try {
            Statement rows(
                from, "SELECT " + columns + " FROM " + table + " ORDER BY rowid" + order);
            while (rows.next())
                insert.runWith(rows);
            return;
        } catch (const sqlite::Failure&) { // the rest cannot be read this way
        }
    }
}

void recoverRows(const fs::path& damaged, Connection& to)
{
    if (isMissing(damaged)) // opening it would make it, and delete its log
        return;
    try {
        Connection from(damaged, std::chrono::milliseconds{0});
        for (const std::string_view table : storeTables)
            copyReadable(from, to, std::string(table));
    } catch (const sqlite::Failure&) { // nothing of it can be read
    }
}

/// Fills a new database, and gives it its name when it is whole.
Result<void> buildStore(
    const fs::path& database, const fs::path& name, const std::function<void(Connection&)>& fill)
{
    const fs::path building = withEnding(database, ".building");
    for (const char* ending : {"", "-journal"})
        AXISCOMP_CHECK(removeFile(withEnding(building, ending)));
    {
        Connection to(building, std::chrono::milliseconds{0});
        to.run(
            "PRAGMA journal_mode = OFF; PRAGMA synchronous = FULL"); // it is whole or thrown away
        migrateStore(to);
        sqlite::Transaction transaction(to, sqlite::Transaction::Kind::Write);
        fill(to);
        transaction.commit();
    }
    return renameFile(building, name);
}

/// Of quick_check: the disk or the memory failed, which does not damage anything.
bool isReadError(std::string_view found)
{
    constexpr std::string_view words = "error code=";
    const std::size_t at = found.find(words);
    int code = 0;
    if (at != std::string_view::npos)
        std::from_chars(found.data() + at + words.size(), found.data() + found.size(), code);
    return (code & 0xff) == SQLITE_IOERR || (code & 0xff) == SQLITE_NOMEM;
}

bool hasLog(const fs::path& database)
{
    return !isMissing(withEnding(database, "-wal")) || !isMissing(withEnding(database, "-journal"));
}

} // namespace

fs::path withEnding(fs::path file, std::string_view ending)
{
    return file += ending;
}

std::optional<fs::path> recoveredFile(const fs::path& database)
{
    const std::string beginning = database.filename().string() + recoveredEnding;
    for (const fs::path& file : filesIn(database.parent_path()))
        if (file.filename().string().starts_with(beginning))
            return file;
    return std::nullopt;
}

void checkStoreFile(const fs::path& database)
{
    if (isMissing(database) && hasLog(database))
        throw sqlite::Failure::damage("its log is there, but not the database");
    if (std::error_code error; fs::file_size(database, error) == 0 && !error)
        throw sqlite::Failure::damage("the file is empty");
}

void checkStorePages(Connection& database)
{
    if (const std::string found = database.text("PRAGMA quick_check(1)"); found != "ok")
        throw sqlite::Failure{.code = isReadError(found) ? SQLITE_IOERR : SQLITE_CORRUPT,
            .systemError = std::make_error_code(std::errc::io_error),
            .message = found};
}

Result<void> makeStore(const fs::path& database)
{
    return buildStore(database, database, [](Connection&) {});
}

Result<void> replaceDamagedStore(const fs::path& database)
{
    std::string stamp = utcText(std::chrono::system_clock::now());
    std::ranges::replace(stamp, ':', '-');
    // From its renaming on it counts: what follows is ended by whoever opens the store next.
    auto built =
        buildStore(database, withEnding(database, recoveredEnding + stamp), [&](Connection& to) {
            recoverRows(database, to);
            // What the user has decided about earlier losses does not reach this one.
            to.run(
                "UPDATE drive SET accepted_loss = min(accepted_loss, (SELECT coalesce(max(id), 0) "
                "FROM flash_loss))");
            records::addFlashLoss(
                to, std::nullopt, database.filename().string() + damagedEnding + stamp);
        });
    return built ? finishStoreReplacement(database) : built;
}

std::vector<fs::path> storesSetAside(const fs::path& database)
{
    std::vector<fs::path> stores = filesIn(database.parent_path());
    std::erase_if(stores, [&](const fs::path& file) {
        const std::string name = file.filename().string();
        return !name.starts_with(withEnding(database, damagedEnding).filename().string())
            || std::ranges::any_of(databaseCompanions,
                [&](std::string_view ending) { return name.ends_with(ending); });
    });
    std::ranges::sort(stores);
    return stores;
}

Result<void> finishStoreReplacement(const fs::path& database)
{
    const auto recovered = recoveredFile(database);
    if (!recovered)
        return {};
    const std::string name = recovered->filename().string();
    const std::string stamp =
        name.substr(database.filename().string().size() + recoveredEnding.size());
    const fs::path aside = withEnding(database, damagedEnding + stamp);
    // The database itself moves last: while it is there, its companions are its own.
    for (const char* ending : databaseCompanions)
        AXISCOMP_CHECK(renameFile(withEnding(database, ending), withEnding(aside, ending)));
    AXISCOMP_CHECK(renameFile(database, aside));
    return renameFile(*recovered, database);
}

} // namespace axiscomp
