// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// What this computer is, and what its environment says. Nothing is changed by asking.
namespace axiscomp {

struct SystemFacts {
    std::string distribution; ///< "Debian GNU/Linux 12 (bookworm)"; empty: not known
    std::string kernel; ///< "Linux 6.1.0-18-amd64"
    std::string architecture; ///< "x86_64"
    unsigned cores = 0; ///< that this program may use
    std::uint64_t memory = 0; ///< bytes; 0: not known
    std::uint64_t freeMemory = 0; ///< that programs can still have
};
[[nodiscard]] SystemFacts systemFacts();
/// PRETTY_NAME of the file os-release (freedesktop.org); empty where it has none.
[[nodiscard]] std::string distributionOf(std::string_view osRelease);

struct LocaleFacts {
    using Variable = std::pair<std::string, std::string>; ///< name and value
    std::vector<Variable> variables; ///< those that are set, the strongest first
    bool isInstalled = true; ///< what they name
    std::string encoding; ///< "UTF-8"
    std::string decimalSign; ///< "."

    [[nodiscard]] bool isUtf8() const;
};
/// That of the environment, whatever locale the program uses itself.
[[nodiscard]] LocaleFacts localeFacts();

/// Variables that decide where a window appears; empty: not set.
struct DisplayFacts {
    std::string display; ///< of X11, ":0"
    std::string waylandDisplay; ///< "wayland-0"
    std::string platform; ///< QT_QPA_PLATFORM: what the window is told to use in place of both
};
[[nodiscard]] DisplayFacts displayFacts();

struct ClockFacts {
    WallTime now{};
    std::optional<WallTime> program{}; ///< when the program was made
};
[[nodiscard]] ClockFacts clockFacts();

/// The names of the variables that name a proxy. Their values may have passwords in them.
[[nodiscard]] std::vector<std::string> proxyVariables();

/// Libraries of core, as they are loaded: "SQLite" and "zlib" with their versions.
struct LibraryVersion {
    std::string name;
    std::string version;
    std::string builtWith; ///< the version whose headers were compiled
};
[[nodiscard]] std::vector<LibraryVersion> libraryVersions();

} // namespace axiscomp
