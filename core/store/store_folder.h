// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/file_lock.h"
#include "core/io/local_file.h"
#include "core/store/store_json.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axiscomp {

/// Like mkdir -p, for the user only: who may change these files could make the program write to the
/// wrong slot. Errors: FileNotWritable.
[[nodiscard]] Result<void> makePrivateFolder(const std::filesystem::path& folder);

/// Whether there is nothing of that name, not even a link to nothing.
[[nodiscard]] bool isMissing(const std::filesystem::path& file);

/// Empty when there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder);

/// The folder of one drive in the DriveStore.
class StoreFolder {
public:
    StoreFolder(const std::filesystem::path& root, std::int32_t serialNumber,
        std::chrono::milliseconds lockWait);

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    [[nodiscard]] std::filesystem::path backups() const { return m_path / "backups"; }
    [[nodiscard]] std::filesystem::path journal(int axis) const;
    /// The table file of a write, kept for its journal; crc is that of the file.
    [[nodiscard]] std::filesystem::path keptTable(int axis, std::uint32_t crc) const;
    [[nodiscard]] std::vector<std::filesystem::path> keptTables(int axis) const;
    [[nodiscard]] std::filesystem::path flashHistory() const { return m_path / "flash.json"; }
    [[nodiscard]] std::filesystem::path tables() const { return m_path / "tables.json"; }
    [[nodiscard]] std::filesystem::path saved() const { return m_path / "saved.json"; }

    /// Makes the folder too.
    [[nodiscard]] Result<FileLock> lock(const char* name = "lock") const;
    [[nodiscard]] Result<std::optional<FileLock>> tryLock(const char* name) const;

    /// What parse makes of the file; T{} when there is none; a broken one is moved aside and counts
    /// as none. To be called under the lock.
    template <typename T, typename Parse>
    [[nodiscard]] Result<T> take(const std::filesystem::path& file, const Parse& parse) const;

    /// The same without the lock, which is taken only when there is something to move.
    template <typename T, typename Parse>
    [[nodiscard]] Result<T> look(const std::filesystem::path& file, const Parse& parse) const;

private:
    /// nullopt: the file is broken.
    template <typename T, typename Parse>
    [[nodiscard]] static Result<std::optional<T>> read(
        const std::filesystem::path& file, const Parse& parse);
    [[nodiscard]] static Result<std::optional<Bytes>> load(const std::filesystem::path& file);
    [[nodiscard]] static Result<void> moveAside(const std::filesystem::path& file);

    std::filesystem::path m_path;
    std::chrono::milliseconds m_lockWait;
};

template <typename T, typename Parse>
Result<T> StoreFolder::take(const std::filesystem::path& file, const Parse& parse) const
{
    AXISCOMP_TRY(auto value, read<T>(file, parse));
    if (value)
        return *std::move(value);
    AXISCOMP_CHECK(moveAside(file));
    return T{};
}

template <typename T, typename Parse>
Result<T> StoreFolder::look(const std::filesystem::path& file, const Parse& parse) const
{
    AXISCOMP_TRY(auto value, read<T>(file, parse));
    if (value)
        return *std::move(value);
    auto held = lock();
    if (!held)
        return fail(held.error());
    return take<T>(file, parse);
}

template <typename T, typename Parse>
Result<std::optional<T>> StoreFolder::read(const std::filesystem::path& file, const Parse& parse)
{
    if (isMissing(file))
        return T{};
    auto bytes = load(file);
    if (!bytes && isMissing(file)) // another program moved it aside just now
        return T{};
    if (!bytes)
        return fail(bytes.error());
    if (*bytes)
        if (auto value = parse(asText(**bytes)))
            return *std::move(value);
    return std::nullopt;
}

} // namespace axiscomp
