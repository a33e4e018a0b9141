// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/file_lock.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace axiscomp {

/// Like mkdir -p, for the user only: who may change these files could make the program write to the
/// wrong slot. Errors: FileNotWritable.
[[nodiscard]] Result<void> makePrivateFolder(const std::filesystem::path& folder);

/// Whether there is nothing of that name, not even a link to nothing.
[[nodiscard]] bool isMissing(const std::filesystem::path& file);

/// Empty when there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder);

/// The drives that have a folder in the state folder: serial numbers, ascending.
[[nodiscard]] std::vector<std::int32_t> drivesIn(const std::filesystem::path& root);

/// What is not there any more is no error. Errors: FileNotWritable.
[[nodiscard]] Result<void> renameFile(
    const std::filesystem::path& from, const std::filesystem::path& to);

/// The folder of one drive in the DriveStore.
class StoreFolder {
public:
    StoreFolder(const std::filesystem::path& root, std::int32_t serialNumber,
        std::chrono::milliseconds lockWait);

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    [[nodiscard]] std::filesystem::path backups() const { return m_path / "backups"; }
    /// Held by whoever writes to the drive.
    static constexpr const char* writeLock = "write.lock";
    /// The table file of a write, kept for its journal; crc is that of the file.
    [[nodiscard]] std::filesystem::path keptTable(int axis, std::uint32_t crc) const;
    [[nodiscard]] std::vector<std::filesystem::path> keptTables(int axis) const;

    /// Makes the folder too.
    [[nodiscard]] Result<FileLock> lock(const char* name = "lock") const;
    [[nodiscard]] Result<std::optional<FileLock>> tryLock(const char* name) const;

private:
    std::filesystem::path m_path;
    std::chrono::milliseconds m_lockWait;
};

} // namespace axiscomp
