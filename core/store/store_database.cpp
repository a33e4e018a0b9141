// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_database.h"

#include "core/io/local_file.h"
#include "core/store/json_import.h"
#include "core/store/store_folder.h"
#include "core/store/store_repair.h"
#include "core/store/store_schema.h"

#include <string>
#include <utility>

#include <sqlite3.h>

namespace axiscomp {

namespace {

namespace fs = std::filesystem;
using sqlite::Transaction;

constexpr int mostReplacements = 3;

tl::unexpected<Error> unusable(const fs::path& file, const Text& reason)
{
    return fail(ErrorCode::FileNotReadable, {{"file", file.string()}, {"reason", reason}});
}

tl::unexpected<Error> notWritable(const fs::path& file, const Text& reason)
{
    return fail(ErrorCode::FileNotWritable, {{"file", file.string()}, {"reason", reason}});
}

Result<void> checkOrdinaryFiles(const fs::path& database)
{
    for (const char* ending : databaseCompanions)
        AXISCOMP_CHECK(checkOrdinaryFile(withEnding(database, ending)));
    return checkOrdinaryFile(database);
}

} // namespace

StoreDatabase::StoreDatabase(fs::path root, std::chrono::milliseconds longestWait)
    : m_root(std::move(root))
    , m_file(m_root / databaseName)
    , m_longestWait(longestWait)
{
}

StoreDatabase::~StoreDatabase() = default;

Result<void> StoreDatabase::read(const Work& work)
{
    return run(work, Transaction::Kind::Read);
}

Result<void> StoreDatabase::change(const Work& work)
{
    return run(work, Transaction::Kind::Write);
}

Result<void> StoreDatabase::run(const Work& work, Transaction::Kind kind)
{
    const std::scoped_lock guard(m_mutex);
    const bool changes = kind == Transaction::Kind::Write;
    for (int attempt = 0;; ++attempt) {
        const auto opened = open(changes);
        if (!opened || !*opened)
            return opened ? Result<void>{} : fail(opened.error());
        try {
            {
                Transaction transaction(*m_connection, kind);
                work(*m_connection);
                transaction.commit();
            }
            if (!changes || isStillInPlace() || attempt == mostReplacements)
                return {};
        } catch (const sqlite::Failure& failure) {
            // Opening anew replaces what is damaged.
            m_connection.reset();
            m_isDamaged = failure.isDamage();
            if (!m_isDamaged || attempt == mostReplacements)
                return failed(
                    failure, changes ? ErrorCode::FileNotWritable : ErrorCode::FileNotReadable);
        }
    }
}

/// false: there is nothing to read.
Result<bool> StoreDatabase::open(bool makes)
{
    if (m_connection && isStillInPlace())
        return true;
    m_connection.reset();
    if (!makes && !hasStore(m_root))
        return false;
    AXISCOMP_CHECK(makePrivateFolder(m_root));
    const auto fileSystem = system::fileSystemOf(m_root);
    if (fileSystem && fileSystem->kind == system::FileSystemFacts::Kind::Network)
        return unusable(m_root,
            AXISCOMP_TEXT("Error",
                "it is on a network file system, where a database can be damaged; set "
                "XDG_STATE_HOME to a folder on this computer"));
    const auto lock = FileLock::acquire(m_root / "axiscomp.lock", m_longestWait, m_file);
    if (!lock)
        return fail(lock.error());
    if (auto opened = openLocked(); !opened) {
        m_connection.reset();
        return fail(opened.error());
    }
    return true;
}

Result<void> StoreDatabase::openLocked()
{
    AXISCOMP_CHECK(finishStoreReplacement(m_file));
    AXISCOMP_CHECK(checkOrdinaryFiles(m_file));
    try {
        if (std::exchange(m_isDamaged, false) && isStillInPlace())
            throw sqlite::Failure::damage("found while it was used");
        checkStoreFile(m_file);
        if (isMissing(m_file))
            AXISCOMP_CHECK(makeStore(m_file));
        AXISCOMP_CHECK(openFile());
    } catch (const sqlite::Failure& failure) {
        m_connection.reset();
        if (!failure.isDamage())
            return failed(failure);
        try {
            AXISCOMP_CHECK(replaceDamagedStore(m_file));
            AXISCOMP_CHECK(openFile());
        } catch (const sqlite::Failure& again) {
            return failed(again);
        }
    }
    try {
        return takeOverJson(*m_connection, m_root);
    } catch (const sqlite::Failure& failure) {
        return failed(failure);
    }
}

/// Throws what SQLite finds wrong.
Result<void> StoreDatabase::openFile()
{
    m_connection = std::make_unique<sqlite::Connection>(m_file, m_longestWait);
    sqlite::Connection& connection = *m_connection;
    const StoreIdentity identity = storeIdentity(connection);
    if (identity == StoreIdentity::Newer)
        return unusable(m_file,
            AXISCOMP_TEXT(
                "Error", "a newer version of this program has written it; use that version"));
    if (identity == StoreIdentity::Foreign)
        return unusable(
            m_file, AXISCOMP_TEXT("Error", "it is the database of another program; move it away"));
    if (connection.isReadOnly())
        return notWritable(m_file, AXISCOMP_TEXT("Error", "the file is read-only"));
    checkStorePages(connection);
    connection.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
    if (connection.text("PRAGMA journal_mode") != "wal")
        return notWritable(
            m_file, AXISCOMP_TEXT("Error", "this file system cannot share it between programs"));
    if (identity == StoreIdentity::Older)
        migrateStore(connection);

    const auto found = system::identityOf(m_file);
    if (!found)
        return unusable(m_file, fileErrorReason(found.error()));
    m_identity = *found;
    return {};
}

bool StoreDatabase::isStillInPlace() const
{
    const auto found = system::identityOf(m_file);
    return found && *found == m_identity;
}

tl::unexpected<Error> StoreDatabase::failed(const sqlite::Failure& failure, ErrorCode code) const
{
    const auto reason = [&]() -> Text {
        if (!failure.reason.isEmpty())
            return failure.reason;
        switch (failure.code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
        case SQLITE_PROTOCOL:
            return AXISCOMP_TEXT(
                "Error", "another program is using it; try again when that one has finished");
        case SQLITE_FULL:
            return fileErrorReason(std::make_error_code(std::errc::no_space_on_device));
        case SQLITE_READONLY:
            return AXISCOMP_TEXT("Error", "the file or its folder is read-only");
        case SQLITE_NOMEM:
            return fileErrorReason(std::make_error_code(std::errc::not_enough_memory));
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
            return AXISCOMP_TEXT("Error", "it is damaged");
        default:
            return failure.systemError ? fileErrorReason(failure.systemError)
                                       : Text(Verbatim{failure.message});
        }
    }();
    return fail(code, {{"file", m_file.string()}, {"reason", reason}}, failure.message);
}

} // namespace axiscomp
