// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/system.h"

#include <filesystem>
#include <optional>
#include <string>

namespace axiscomp {

/// A folder as this user finds it.
struct FolderFacts {
    std::filesystem::path path;
    enum class Kind {
        Folder,
        Missing, ///< nothing is there, and it could be made below `nearest`
        Blocked, ///< `nearest` is no folder
        Hidden, ///< this user may not look into `nearest`
    };
    Kind kind = Kind::Missing;
    /// The folder itself where it is there, or else the last part of its path that is.
    std::filesystem::path nearest{};
    bool mayUse = false; ///< this user may read, change and enter `nearest`
    bool isOwn = false; ///< it belongs to this user
    std::string owner{}; ///< a name, or a number where it has none
    unsigned mode = 0; ///< permission bits
    bool isRoot = false; ///< this user is, who may do everything
    std::optional<system::FileSystemFacts> fileSystem{};

    [[nodiscard]] bool othersMayChange() const { return (mode & 0022U) != 0; }
};

/// Looks without making anything.
[[nodiscard]] FolderFacts folderFacts(const std::filesystem::path& path);

/// Where programs put theirs, as std::filesystem::temp_directory_path, but also what is none:
/// $TMPDIR, $TMP, $TEMP, $TEMPDIR, /tmp
[[nodiscard]] std::filesystem::path temporaryFolder();

} // namespace axiscomp
