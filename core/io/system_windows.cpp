// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/system.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <optional>
#include <string>
#include <utility>

// windows.h comes before what needs it.
#include <windows.h>

#include <knownfolders.h>
#include <shlobj.h>

namespace axiscomp::system {

namespace {

namespace fs = std::filesystem;

constexpr DWORD sharedByAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
/// Of a folder; a file may have 12 more (MAX_PATH).
constexpr std::size_t longestPlainName = 247;
constexpr std::size_t longestComponent = 255;

/// What is locked of a file may not be read by others; this is behind the end of all of them.
constexpr DWORD lockedByteHigh = 0x40000000;

/// Search indexers and virus scanners open what has just been written for a moment, and readers
/// that come one after the other leave moments between them: tried often, for this long.
constexpr ULONGLONG longestReplacement = 500; // ms
constexpr DWORD replacementPause = 1; // ms

/// ERROR_DISK_QUOTA_EXCEEDED, which MinGW does not have.
constexpr DWORD diskQuotaExceeded = 1295;

tl::unexpected<std::error_code> failed(std::error_code error)
{
    return tl::unexpected(error);
}

std::error_code codeOf(DWORD error)
{
    return {static_cast<int>(error), std::system_category()};
}

std::error_code lastError()
{
    return codeOf(::GetLastError());
}

std::wstring nameOf(const fs::path& file)
{
    return nativeName(file).native();
}

DWORD attributesOf(const fs::path& file)
{
    return ::GetFileAttributesW(nameOf(file).c_str());
}

bool isFolder(DWORD attributes)
{
    return attributes != INVALID_FILE_ATTRIBUTES && (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
}

/// Windows says the same of several things that POSIX tells apart.
std::error_code explained(std::error_code error, const fs::path& file)
{
    const auto is = [&](DWORD code) { return error == codeOf(code); };
    if (file.filename().native().size() > longestComponent)
        return std::make_error_code(std::errc::filename_too_long);
    if (is(ERROR_ACCESS_DENIED) && isFolder(attributesOf(file)))
        return std::make_error_code(std::errc::is_a_directory);
    if (is(ERROR_PATH_NOT_FOUND)) {
        fs::path above = file.parent_path();
        while (!above.empty() && above.has_relative_path()
            && attributesOf(above) == INVALID_FILE_ATTRIBUTES)
            above = above.parent_path();
        const DWORD attributes = attributesOf(above);
        if (attributes != INVALID_FILE_ATTRIBUTES && !isFolder(attributes))
            return std::make_error_code(std::errc::not_a_directory);
    }
    return error;
}

class Handle {
public:
    explicit Handle(HANDLE handle) : m_handle(handle) { }
    Handle(Handle&& other) noexcept : m_handle(std::exchange(other.m_handle, INVALID_HANDLE_VALUE))
    {
    }
    Handle& operator=(Handle&& other) noexcept
    {
        std::swap(m_handle, other.m_handle);
        return *this;
    }
    ~Handle() { close(); }

    [[nodiscard]] HANDLE get() const { return m_handle; }
    [[nodiscard]] bool isOpen() const { return m_handle != INVALID_HANDLE_VALUE; }
    bool close()
    {
        return !isOpen() || ::CloseHandle(std::exchange(m_handle, INVALID_HANDLE_VALUE)) != 0;
    }

private:
    HANDLE m_handle;
};

HANDLE handleOf(std::intptr_t handle)
{
    return reinterpret_cast<HANDLE>(handle);
}

/// Opens what is there to ask about it, folders too; what others do with it is no hindrance.
Handle openToAsk(const fs::path& file)
{
    return Handle{::CreateFileW(nameOf(file).c_str(), 0, sharedByAll, nullptr, OPEN_EXISTING,
        FILE_FLAG_BACKUP_SEMANTICS, nullptr)};
}

DWORD sizeOfNext(std::size_t left)
{
    return static_cast<DWORD>(std::min<std::size_t>(left, std::numeric_limits<DWORD>::max() / 2));
}

OVERLAPPED overlappedAt(std::uint64_t place)
{
    OVERLAPPED overlapped{};
    overlapped.Offset = static_cast<DWORD>(place & 0xffffffffU);
    overlapped.OffsetHigh = static_cast<DWORD>(place >> 32);
    return overlapped;
}

/// place: nothing where the file has none.
std::error_code writeAll(HANDLE file, std::optional<std::uint64_t> place, ByteView bytes)
{
    while (!bytes.empty()) {
        OVERLAPPED overlapped = overlappedAt(place.value_or(0));
        DWORD count = 0;
        if (!::WriteFile(file, bytes.data(), sizeOfNext(bytes.size()), &count,
                place ? &overlapped : nullptr))
            return lastError();
        if (count == 0)
            return std::make_error_code(std::errc::io_error);
        if (place)
            *place += count;
        bytes = bytes.subspan(count);
    }
    return {};
}

/// From tenths of a microsecond since 1601.
WallTime timeFrom(const FILETIME& time)
{
    using Ticks = std::chrono::duration<std::int64_t, std::ratio<1, 10'000'000>>;
    constexpr std::chrono::sys_days begin = std::chrono::January / 1 / 1601;
    const std::uint64_t ticks = std::uint64_t{time.dwHighDateTime} << 32 | time.dwLowDateTime;
    const auto sinceUnixEpoch = Ticks(static_cast<std::int64_t>(ticks)) + begin.time_since_epoch();
    return WallTime(std::chrono::duration_cast<WallTime::duration>(sinceUnixEpoch));
}

Outcome<FileState> stateFrom(HANDLE file)
{
    const DWORD type = ::GetFileType(file);
    if (type == FILE_TYPE_UNKNOWN && ::GetLastError() != NO_ERROR)
        return failed(lastError());
    if (type != FILE_TYPE_DISK)
        return FileState{FileKind::Other};
    BY_HANDLE_FILE_INFORMATION found{};
    if (!::GetFileInformationByHandle(file, &found))
        return failed(lastError());
    return FileState{isFolder(found.dwFileAttributes) ? FileKind::Folder : FileKind::Ordinary,
        std::uint64_t{found.nFileSizeHigh} << 32 | found.nFileSizeLow,
        timeFrom(found.ftLastWriteTime)};
}

/// On ReFS two files may have the same number: it has 64 of 128 bits of it here.
Outcome<FileIdentity> identityFrom(HANDLE file)
{
    BY_HANDLE_FILE_INFORMATION found{};
    if (!::GetFileInformationByHandle(file, &found))
        return failed(lastError());
    return FileIdentity{found.dwVolumeSerialNumber,
        std::uint64_t{found.nFileIndexHigh} << 32 | found.nFileIndexLow};
}

/// A symbolic link or a junction. Files that are kept in a cloud are reparse points, too, and are
/// none.
bool isLink(const fs::path& file)
{
    WIN32_FIND_DATAW found{};
    const HANDLE search = ::FindFirstFileW(nameOf(file).c_str(), &found);
    if (search == INVALID_HANDLE_VALUE)
        return false;
    ::FindClose(search);
    return (found.dwFileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0
        && IsReparseTagNameSurrogate(found.dwReserved0);
}

/// A new file in a folder that vanishes unless it is moved.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& folder)
    {
        static std::atomic<unsigned> counter{0};
        do {
            m_name = nameOf(folder
                / (std::string(temporaryPrefix) + std::to_string(::GetCurrentProcessId()) + "-"
                    + std::to_string(counter++) + std::string(temporarySuffix)));
            m_file = Handle{::CreateFileW(m_name.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW,
                FILE_ATTRIBUTE_NORMAL, nullptr)};
            m_exists = m_file.isOpen();
        } while (!m_exists && ::GetLastError() == ERROR_FILE_EXISTS);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        m_file.close();
        if (m_exists)
            ::DeleteFileW(m_name.c_str());
    }

    [[nodiscard]] bool exists() const { return m_exists; }
    [[nodiscard]] const std::wstring& name() const { return m_name; }
    [[nodiscard]] HANDLE handle() const { return m_file.get(); }
    bool close() { return m_file.close(); }
    bool moveTo(const std::wstring& name)
    {
        const ULONGLONG begin = ::GetTickCount64();
        while (true) {
            if (::MoveFileExW(m_name.c_str(), name.c_str(),
                    MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH)) {
                m_exists = false;
                return true;
            }
            const DWORD error = ::GetLastError();
            const bool mayPass = error == ERROR_SHARING_VIOLATION || error == ERROR_ACCESS_DENIED;
            if (!mayPass || ::GetTickCount64() - begin >= longestReplacement)
                return false;
            ::Sleep(replacementPause);
        }
    }

private:
    std::wstring m_name;
    Handle m_file{INVALID_HANDLE_VALUE};
    bool m_exists = false;
};

/// Who may read and write the old file, and whether it is hidden. A file system that knows no users
/// has nothing to take over.
bool takeOver(const std::wstring& from, const std::wstring& to, DWORD attributes)
{
    constexpr DWORD hiding = FILE_ATTRIBUTE_HIDDEN | FILE_ATTRIBUTE_SYSTEM;
    if ((attributes & hiding) != 0 && !::SetFileAttributesW(to.c_str(), attributes & hiding))
        return false;
    DWORD size = 0;
    ::GetFileSecurityW(from.c_str(), DACL_SECURITY_INFORMATION, nullptr, 0, &size);
    if (size == 0)
        return true;
    std::string rights(size, '\0');
    return ::GetFileSecurityW(from.c_str(), DACL_SECURITY_INFORMATION, rights.data(), size, &size)
        && ::SetFileSecurityW(to.c_str(), DACL_SECURITY_INFORMATION, rights.data());
}

std::string utf8Of(std::wstring_view text)
{
    const int size = ::WideCharToMultiByte(
        CP_UTF8, 0, text.data(), static_cast<int>(text.size()), nullptr, 0, nullptr, nullptr);
    std::string result(static_cast<std::size_t>(size), '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), result.data(),
        size, nullptr, nullptr);
    return result;
}

/// Empty, too, where the text is none of the code page and flags forbid that.
std::wstring wideOf(UINT codePage, DWORD flags, std::string_view text)
{
    const auto length = static_cast<int>(text.size());
    const int size = ::MultiByteToWideChar(codePage, flags, text.data(), length, nullptr, 0);
    std::wstring wide(static_cast<std::size_t>(size), L'\0');
    ::MultiByteToWideChar(codePage, flags, text.data(), length, wide.data(), size);
    return wide;
}

} // namespace

Outcome<File> File::open(const fs::path& file, Purpose purpose)
{
    DWORD access = GENERIC_READ | GENERIC_WRITE;
    DWORD disposition = OPEN_ALWAYS;
    DWORD flags = FILE_ATTRIBUTE_NORMAL;
    switch (purpose) {
    case Purpose::Read:
        access = GENERIC_READ;
        disposition = OPEN_EXISTING;
        flags = FILE_FLAG_BACKUP_SEMANTICS; // opens folders, too, so that they can be named
        break;
    case Purpose::Write:
        access = GENERIC_WRITE;
        disposition = OPEN_EXISTING;
        break;
    case Purpose::Change:
        break;
    case Purpose::Lock: // in a folder of the user; the rights are those of the folder
        if (isLink(file))
            return failed(std::make_error_code(std::errc::too_many_symbolic_link_levels));
        flags |= FILE_FLAG_OPEN_REPARSE_POINT;
        break;
    }
    // Without security attributes no program that is started inherits the handle.
    const HANDLE handle = ::CreateFileW(
        nameOf(file).c_str(), access, sharedByAll, nullptr, disposition, flags, nullptr);
    if (handle == INVALID_HANDLE_VALUE)
        return failed(explained(lastError(), file));
    return File(reinterpret_cast<std::intptr_t>(handle));
}

File::File(File&& other) noexcept : m_handle(std::exchange(other.m_handle, -1)) { }

File& File::operator=(File&& other) noexcept
{
    std::swap(m_handle, other.m_handle);
    return *this;
}

File::~File()
{
    static_cast<void>(close());
}

Outcome<FileState> File::state() const
{
    return stateFrom(handleOf(m_handle));
}

Outcome<FileIdentity> File::identity() const
{
    return identityFrom(handleOf(m_handle));
}

/// The system lets one thread after the other read: the file is opened for one at a time.
Outcome<std::size_t> File::readAt(std::uint64_t place, std::span<std::byte> bytes) const
{
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        OVERLAPPED overlapped = overlappedAt(place + filled);
        DWORD count = 0;
        if (!::ReadFile(handleOf(m_handle), bytes.data() + filled,
                sizeOfNext(bytes.size() - filled), &count, &overlapped)
            && ::GetLastError() != ERROR_HANDLE_EOF)
            return failed(lastError());
        if (count == 0)
            break;
        filled += count;
    }
    return filled;
}

std::error_code File::writeAt(std::uint64_t place, ByteView bytes)
{
    return writeAll(handleOf(m_handle), place, bytes);
}

std::error_code File::write(ByteView bytes)
{
    return writeAll(handleOf(m_handle), std::nullopt, bytes);
}

std::error_code File::resize(std::uint64_t size)
{
    FILE_END_OF_FILE_INFO end{};
    end.EndOfFile.QuadPart = static_cast<LONGLONG>(size);
    return ::SetFileInformationByHandle(handleOf(m_handle), FileEndOfFileInfo, &end, sizeof end)
        ? std::error_code()
        : lastError();
}

std::error_code File::flush()
{
    return ::FlushFileBuffers(handleOf(m_handle)) ? std::error_code() : lastError();
}

/// As flock: it belongs to the handle, so that this program keeps itself out as well. Unlike it,
/// the system may let go of the lock of a program that has died only after a while.
Outcome<bool> File::tryLock()
{
    OVERLAPPED overlapped{};
    overlapped.OffsetHigh = lockedByteHigh;
    if (::LockFileEx(handleOf(m_handle), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1,
            0, &overlapped))
        return true;
    const DWORD error = ::GetLastError();
    if (error == ERROR_LOCK_VIOLATION || error == ERROR_IO_PENDING)
        return false;
    return failed(codeOf(error));
}

Outcome<bool> File::isLocked() const
{
    OVERLAPPED overlapped{};
    overlapped.OffsetHigh = lockedByteHigh;
    if (!::LockFileEx(handleOf(m_handle), LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &overlapped)) {
        const DWORD error = ::GetLastError();
        if (error == ERROR_LOCK_VIOLATION || error == ERROR_IO_PENDING)
            return true;
        return failed(codeOf(error));
    }
    ::UnlockFileEx(handleOf(m_handle), 0, 1, 0, &overlapped);
    return false;
}

std::error_code File::close()
{
    Handle handle{handleOf(std::exchange(m_handle, -1))};
    return handle.close() ? std::error_code() : lastError();
}

Outcome<FileState> stateOf(const fs::path& file)
{
    const Handle handle = openToAsk(file);
    if (!handle.isOpen())
        return failed(explained(lastError(), file));
    return stateFrom(handle.get());
}

Outcome<FileState> linkStateOf(const fs::path& file)
{
    if (isLink(file))
        return FileState{FileKind::Link};
    return stateOf(file);
}

/// The end of a chain must be there: Windows gives the final name of what can be opened only.
Outcome<fs::path> endOfLinks(const fs::path& file)
{
    if (!isLink(file))
        return file;
    const Handle handle = openToAsk(file);
    if (!handle.isOpen())
        return failed(lastError());
    const DWORD size = ::GetFinalPathNameByHandleW(handle.get(), nullptr, 0, FILE_NAME_NORMALIZED);
    std::wstring name(size, L'\0');
    const DWORD length =
        ::GetFinalPathNameByHandleW(handle.get(), name.data(), size, FILE_NAME_NORMALIZED);
    if (size == 0 || length == 0 || length >= size)
        return failed(lastError());
    name.resize(length);
    return fs::path(name);
}

/// Weaker than on POSIX in two ways: the folder is named, not held open, so that one that is
/// exchanged meanwhile gets the file; and a folder cannot be flushed, so that after a power cut the
/// old file may be there although this has returned (MOVEFILE_WRITE_THROUGH asks for the new one).
/// Stricter in one: a program that has the old file open and does not share its deletion is in the
/// way.
std::error_code replaceFile(const fs::path& file, ByteView bytes)
{
    const std::wstring name = nameOf(file);
    const DWORD old = ::GetFileAttributesW(name.c_str());
    const bool isThere = old != INVALID_FILE_ATTRIBUTES;
    if (isThere && (old & FILE_ATTRIBUTE_READONLY) != 0)
        return std::make_error_code(std::errc::permission_denied);
    if (!isThere && file.filename().native().size() > longestComponent)
        return std::make_error_code(std::errc::filename_too_long);
    TemporaryFile temporary(file.parent_path());
    if (!temporary.exists())
        return explained(lastError(), file);
    if (const std::error_code error = writeAll(temporary.handle(), std::nullopt, bytes))
        return error;
    if (!::FlushFileBuffers(temporary.handle()) || !temporary.close()
        || (isThere && !takeOver(name, temporary.name(), old)) || !temporary.moveTo(name))
        return lastError();
    return {};
}

/// A read-only file stays: on POSIX its folder decides.
std::error_code removeFile(const fs::path& file)
{
    return ::DeleteFileW(nameOf(file).c_str()) ? std::error_code() : explained(lastError(), file);
}

/// It inherits the rights of the folder above: below the profile of a user that is this user, the
/// system and administrators. Elsewhere others may be able to read it.
std::error_code makePrivateFolder(const fs::path& folder)
{
    const bool isThere = ::CreateDirectoryW(nameOf(folder).c_str(), nullptr)
        || ::GetLastError() == ERROR_ALREADY_EXISTS;
    return isThere ? std::error_code() : lastError();
}

Outcome<fs::path> makeTemporaryFolder(const fs::path& parent)
{
    while (true) {
        static std::atomic<unsigned> counter{0};
        const fs::path folder = parent
            / ("axiscomp-" + std::to_string(::GetCurrentProcessId()) + "-"
                + std::to_string(::GetTickCount64()) + "-" + std::to_string(counter++));
        if (::CreateDirectoryW(nameOf(folder).c_str(), nullptr))
            return folder;
        if (::GetLastError() != ERROR_ALREADY_EXISTS)
            return failed(lastError());
    }
}

Outcome<FileIdentity> identityOf(const fs::path& file)
{
    const Handle handle = openToAsk(file);
    if (!handle.isOpen())
        return failed(lastError());
    return identityFrom(handle.get());
}

/// Opens it, which a program that has it open and does not share it is in the way of.
bool mayReadAndWrite(const fs::path& file)
{
    return Handle{::CreateFileW(nameOf(file).c_str(), GENERIC_READ | GENERIC_WRITE, sharedByAll,
                      nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr)}
        .isOpen();
}

/// A folder that is synchronised with a cloud counts as a disk.
std::optional<FileSystemFacts> fileSystemOf(const fs::path& path)
{
    if (attributesOf(path) == INVALID_FILE_ATTRIBUTES) // its drive would be asked
        return std::nullopt;
    const std::wstring name = nameOf(path);
    std::wstring volume(name.size() + MAX_PATH, L'\0');
    ULARGE_INTEGER freeBytes{};
    DWORD flags = 0;
    if (!::GetVolumePathNameW(name.c_str(), volume.data(), static_cast<DWORD>(volume.size()))
        || !::GetDiskFreeSpaceExW(volume.c_str(), &freeBytes, nullptr, nullptr)
        || !::GetVolumeInformationW(
            volume.c_str(), nullptr, 0, nullptr, nullptr, &flags, nullptr, 0))
        return std::nullopt;
    FileSystemFacts facts;
    const UINT type = ::GetDriveTypeW(volume.c_str());
    if (type == DRIVE_REMOTE)
        facts.kind = FileSystemFacts::Kind::Network;
    else if (type == DRIVE_RAMDISK)
        facts.kind = FileSystemFacts::Kind::Memory;
    facts.isReadOnly = (flags & FILE_READ_ONLY_VOLUME) != 0;
    facts.freeBytes = freeBytes.QuadPart;
    return facts;
}

/// %LOCALAPPDATA%, which stays on this computer when the profile of a user moves between several.
fs::path stateFolder()
{
    PWSTR found = nullptr;
    fs::path folder;
    if (SUCCEEDED(::SHGetKnownFolderPath(FOLDERID_LocalAppData, 0, nullptr, &found)))
        folder = found;
    ::CoTaskMemFree(found);
    return folder;
}

fs::path programFolder()
{
    std::wstring name(MAX_PATH, L'\0');
    DWORD length = 0;
    while ((length = ::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())))
        == name.size())
        name.resize(2 * name.size());
    name.resize(length);
    return fs::path(name).parent_path();
}

/// As Microsoft says, this counter goes on in standby and hibernation.
/// Large pages are a privilege there.
void preferLargePages(void* /*begin*/, std::size_t /*size*/) { }

std::chrono::nanoseconds timeSinceStart()
{
    LARGE_INTEGER ticks{};
    LARGE_INTEGER perSecond{};
    ::QueryPerformanceCounter(&ticks);
    ::QueryPerformanceFrequency(&perSecond);
    const auto part = static_cast<double>(ticks.QuadPart % perSecond.QuadPart)
        / static_cast<double>(perSecond.QuadPart);
    return std::chrono::seconds(ticks.QuadPart / perSecond.QuadPart)
        + std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(part));
}

/// What is not UTF-8 becomes U+FFFD.
fs::path pathFromText(std::string_view text)
{
    return wideOf(CP_UTF8, 0, text);
}

/// Short ones stay as they are: "NUL" is a device only without the prefix.
fs::path nativeName(const fs::path& file)
{
    const std::wstring given = fs::path(file).make_preferred().native();
    const DWORD size = ::GetFullPathNameW(given.c_str(), 0, nullptr, nullptr);
    if (size <= longestPlainName || given.starts_with(L"\\\\?\\") || given.starts_with(L"\\\\.\\"))
        return given;
    std::wstring full(size, L'\0');
    full.resize(::GetFullPathNameW(given.c_str(), size, full.data(), nullptr));
    return full.starts_with(L"\\\\") ? L"\\\\?\\UNC" + full.substr(1) : L"\\\\?\\" + full;
}

std::optional<std::string> fromGbk(std::string_view bytes)
{
    constexpr UINT chinese = 936;
    const std::wstring wide = wideOf(chinese, MB_ERR_INVALID_CHARS, bytes);
    if (wide.empty() && !bytes.empty())
        return std::nullopt;
    return utf8Of(wide);
}

/// Addresses are compared as they are written: the functions that read them are those of a library
/// for the network, which core does not have.
std::optional<std::string> numericAddress(const std::string& /*host*/)
{
    return std::nullopt;
}

bool isQuotaUsedUp(const std::error_code& error)
{
    return error == codeOf(diskQuotaExceeded);
}

std::string messageOf(const std::error_code& error)
{
    if (error.category() != std::system_category())
        return error.message();
    std::array<wchar_t, 1024> words{};
    DWORD length = ::FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS,
        nullptr, static_cast<DWORD>(error.value()), 0, words.data(), words.size(), nullptr);
    constexpr std::wstring_view endings = L"\r\n. ";
    while (length > 0 && endings.find(words[length - 1]) != std::wstring_view::npos)
        --length;
    return length == 0 ? "Windows error " + std::to_string(error.value())
                       : utf8Of({words.data(), length});
}

} // namespace axiscomp::system
