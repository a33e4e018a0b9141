// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace axiscomp {

/// What the file system under a path means for what is kept there.
struct FileSystemFacts {
    enum class Kind {
        Disk,
        Network, ///< its locks and shared memory do not reach other computers
        Memory, ///< gone with a restart
    };
    Kind kind = Kind::Disk;
    bool isReadOnly = false;
    bool takesFiles = true; ///< there is room for the names of new ones
    std::uint64_t freeBytes = 0; ///< for a user without privileges
};

/// Of a file or folder that exists; nullopt: it cannot be asked.
[[nodiscard]] std::optional<FileSystemFacts> fileSystemOf(const std::filesystem::path& path);

} // namespace axiscomp
