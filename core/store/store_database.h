// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/io/file_lock.h"
#include "core/io/system.h"
#include "core/store/sqlite.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>

namespace axiscomp {

/// The file axiscomp.db of a state folder, opened when it is first asked for and shared with other
/// programs. May be used from several threads.
///
/// Whoever opens it holds the lock axiscomp.lock for that moment, so that only one program at a
/// time makes the database, takes over the files of older versions, or replaces a damaged one.
class StoreDatabase {
public:
    StoreDatabase(std::filesystem::path root, std::chrono::milliseconds longestWait);
    ~StoreDatabase();

    using Work = std::function<void(sqlite::Connection&)>;
    /// Runs work in a transaction that changes nothing, or not at all where there is nothing yet.
    /// Errors: FileNotReadable, FileNotWritable.
    [[nodiscard]] Result<void> read(const Work& work);
    /// What query gives, or T{} where there is nothing yet.
    template <typename T, typename Query> [[nodiscard]] Result<T> get(const Query& query)
    {
        T value{};
        AXISCOMP_CHECK(read([&](sqlite::Connection& database) { value = query(database); }));
        return value;
    }
    /// Makes the folder and the database when they are missing. When another program has replaced
    /// the database meanwhile, work runs once more on the new one. Errors: FileNotReadable,
    /// FileNotWritable: nothing was changed.
    [[nodiscard]] Result<void> change(const Work& work);

    [[nodiscard]] const std::filesystem::path& root() const { return m_root; }

private:
    [[nodiscard]] Result<void> run(const Work& work, sqlite::Transaction::Kind kind);
    [[nodiscard]] Result<bool> open(bool makes);
    [[nodiscard]] Result<void> openLocked();
    [[nodiscard]] Result<void> openFile();
    [[nodiscard]] bool isStillInPlace() const;
    [[nodiscard]] tl::unexpected<Error> failed(
        const sqlite::Failure& failure, ErrorCode code = ErrorCode::FileNotWritable) const;

    std::filesystem::path m_root;
    std::filesystem::path m_file;
    std::chrono::milliseconds m_longestWait;
    std::mutex m_mutex;
    std::unique_ptr<sqlite::Connection> m_connection;
    system::FileIdentity m_identity; ///< of the file that is open
    bool m_isDamaged = false; ///< that file, as work has found
};

} // namespace axiscomp
