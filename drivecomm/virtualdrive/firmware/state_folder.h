// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/wall_time.h"
#include "core/drive/register_value.h"
#include "core/io/file_lock.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

/// What a virtual drive keeps while it is off.
struct StoredDrive {
    struct Slot {
        std::uint32_t eraseCount = 0;
        std::shared_ptr<const Bytes> table; ///< null: empty
    };
    std::int32_t serialNumber = 0;
    WallTime savedAt{};
    std::vector<std::chrono::nanoseconds> operationAges; ///< of flash operations, when saved
    std::map<std::string, Slot> slots; ///< by name
    std::map<std::string, RegisterValue> parameters; ///< those unlike the factory's
};

/// A folder with drive.json and, in its folder flash, one file per table. Each save is one instant:
/// tables go under new names, then drive.json, which names them, is replaced. Locked against other
/// programs while open.
class StateFolder {
public:
    /// Makes the folder when it is missing. Errors: FileNotWritable.
    [[nodiscard]] static Result<std::unique_ptr<StateFolder>> open(
        const std::filesystem::path& folder);

    /// None when nothing was saved yet. Errors: FileNotReadable with what is wrong where.
    [[nodiscard]] Result<std::optional<StoredDrive>> load();
    /// Errors: FileNotWritable; the old state is kept.
    [[nodiscard]] Result<void> save(const StoredDrive& drive);

    [[nodiscard]] std::filesystem::path mainFile() const { return m_folder / "drive.json"; }

private:
    StateFolder(std::filesystem::path folder, FileLock lock);
    void removeUnused() const;

    std::filesystem::path m_folder;
    FileLock m_lock;
    std::set<std::string> m_tableFiles; ///< that drive.json names
};

} // namespace axiscomp::drivecomm
