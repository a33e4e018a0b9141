// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/wall_time.h"

#include <tl/expected.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

/// What core needs of the operating system and the standard library does not have. One source file
/// for each kind of system, which also says what that system promises less:
/// system_posix.cpp, system_windows.cpp. Errors are those of the system;
/// fileErrorReason() has words for them.
namespace axiscomp::system {

template <typename T> using Outcome = tl::expected<T, std::error_code>;

enum class FileKind {
    Ordinary,
    Folder,
    Link, ///< only where links are not followed
    Other, ///< a pipe, a device
};

struct FileState {
    FileKind kind = FileKind::Ordinary;
    std::uint64_t size = 0;
    WallTime lastChange{}; ///< of its content
};

/// Says whether two paths, or a path and an open file, are one file.
struct FileIdentity {
    std::uint64_t volume = 0;
    std::uint64_t number = 0;

    friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};

/// An open file, which other programs may read, replace and delete meanwhile. Programs that are
/// started do not get it.
class File {
public:
    enum class Purpose {
        Read, ///< what is there; does not wait for the other end of a pipe
        Write, ///< a device or a pipe that is there
        Change, ///< read and write, made where it is missing; does not wait either
        Lock, ///< made for this user only where it is missing; no link is followed
    };
    [[nodiscard]] static Outcome<File> open(const std::filesystem::path& file, Purpose purpose);

    File(File&& other) noexcept;
    File& operator=(File&& other) noexcept;
    ~File();

    [[nodiscard]] Outcome<FileState> state() const;
    [[nodiscard]] Outcome<FileIdentity> identity() const;
    /// The bytes from a place on until the room is full or the file ends; gives how many. Several
    /// threads may read at once.
    [[nodiscard]] Outcome<std::size_t> readAt(
        std::uint64_t place, std::span<std::byte> bytes) const;
    /// After an error some of them may be there.
    [[nodiscard]] std::error_code writeAt(std::uint64_t place, ByteView bytes);
    /// For devices and pipes, which have no places.
    [[nodiscard]] std::error_code write(ByteView bytes);
    [[nodiscard]] std::error_code resize(std::uint64_t size);
    /// The content is on the disk when this returns.
    [[nodiscard]] std::error_code flush();
    /// Against every other open File, of this program as well, until it is closed or its program
    /// ends. false: somebody has it.
    [[nodiscard]] Outcome<bool> tryLock();
    /// Whether another open File has the lock. Who tries to take it at this moment may fail.
    [[nodiscard]] Outcome<bool> isLocked() const;
    /// What could not be written may only show here.
    [[nodiscard]] std::error_code close();

private:
    explicit File(std::intptr_t handle) : m_handle(handle) { }
    std::intptr_t m_handle;
};

/// What a path leads to, through links.
[[nodiscard]] Outcome<FileState> stateOf(const std::filesystem::path& file);
/// What stands there itself.
[[nodiscard]] Outcome<FileState> linkStateOf(const std::filesystem::path& file);

/// Where a chain of links ends: a file, or a name that does not exist yet. What is no link is
/// itself.
[[nodiscard]] Outcome<std::filesystem::path> endOfLinks(const std::filesystem::path& file);

/// Temporary files of replaceFile begin and end like this.
inline constexpr std::string_view temporaryPrefix = ".axiscomp-";
inline constexpr std::string_view temporarySuffix = ".tmp";

/// Puts a file of these bytes where a file is, or nothing; file is no link. After a crash or a full
/// disk the old one is whole or the new one. A read-only file is refused; who may read and write
/// the old one may do so with the new one.
[[nodiscard]] std::error_code replaceFile(const std::filesystem::path& file, ByteView bytes);

/// The file is gone after a crash, too. A folder is refused.
[[nodiscard]] std::error_code removeFile(const std::filesystem::path& file);

/// One folder, for this user only; one that is there is no error.
[[nodiscard]] std::error_code makePrivateFolder(const std::filesystem::path& folder);
/// A new folder for this user only, in another one.
[[nodiscard]] Outcome<std::filesystem::path> makeTemporaryFolder(
    const std::filesystem::path& parent);

/// What a path leads to, through links.
[[nodiscard]] Outcome<FileIdentity> identityOf(const std::filesystem::path& file);

/// Of what is there, by this user.
[[nodiscard]] bool mayReadAndWrite(const std::filesystem::path& file);

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

/// Where programs keep what they remember for this user.
[[nodiscard]] std::filesystem::path stateFolder();
/// Of the program that runs.
[[nodiscard]] std::filesystem::path programFolder();

/// Asks for few large pages in place of many small ones in memory that nothing has been written to
/// yet. What is in it does not change, and nothing is promised.
void preferLargePages(void* begin, std::size_t size);

/// Of a clock that no person sets, and that goes on while the computer sleeps.
[[nodiscard]] std::chrono::nanoseconds timeSinceStart();

/// UTF-8 is how this program holds text; names of files are as the system has them.
[[nodiscard]] std::filesystem::path pathFromText(std::string_view text);
/// As functions of the system take it at any length.
[[nodiscard]] std::filesystem::path nativeName(const std::filesystem::path& file);

/// UTF-8 from GBK (GB 2312 and more), as Chinese programs on Windows write it. Nothing when it is
/// none, or this computer cannot read it.
[[nodiscard]] std::optional<std::string> fromGbk(std::string_view bytes);

/// An address in numbers in the one way in which all its forms are equal: "127.0.0.1" for "127.1",
/// "::1" for "0:0:0:0:0:0:0:1". Nothing for a name, which is not looked up.
[[nodiscard]] std::optional<std::string> numericAddress(const std::string& host);

/// Whether it is the quota of the user, for which std::errc has no name.
[[nodiscard]] bool isQuotaUsedUp(const std::error_code& error);
/// In the system's own words.
[[nodiscard]] std::string messageOf(const std::error_code& error);

} // namespace axiscomp::system
