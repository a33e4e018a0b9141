// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/io/system.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

namespace axiscomp {

/// Holds a lock file against other programs, and against other holders in this one, until it is
/// destroyed; the system lets go of it when a program dies. The file stays: deleting it would let
/// two holders in.
class FileLock {
public:
    /// Waits until the lock is free, at most this long. `what` is the file or folder that the error
    /// names. Errors: FileNotWritable.
    [[nodiscard]] static Result<FileLock> acquire(const std::filesystem::path& lockFile,
        std::chrono::milliseconds longestWait, const std::filesystem::path& what);

    /// Without waiting; nullopt while somebody else holds it. Errors: FileNotWritable.
    [[nodiscard]] static Result<std::optional<FileLock>> tryAcquire(
        const std::filesystem::path& lockFile, const std::filesystem::path& what);

    /// Whether somebody holds it now; nothing is made where there is no such file.
    [[nodiscard]] static bool isHeld(const std::filesystem::path& lockFile);

private:
    explicit FileLock(system::File file) : m_file(std::move(file)) { }
    system::File m_file;
};

} // namespace axiscomp
