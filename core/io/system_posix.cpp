// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/system.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <utility>

#include <arpa/inet.h>
#include <fcntl.h>
#include <iconv.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/vfs.h>
#include <unistd.h>

namespace axiscomp::system {

namespace {

namespace fs = std::filesystem;

constexpr int maximumLinks = 40; // as the kernel

// linux/magic.h
constexpr std::array<std::uint32_t, 6> networkFileSystems{0x6969 /* NFS */, 0x517b /* SMB */,
    0xfe534d42 /* SMB 2 */, 0xff534d42 /* CIFS */, 0x73757245 /* Coda */, 0x5346414f /* AFS */};
constexpr std::array<std::uint32_t, 2> memoryFileSystems{
    0x01021994 /* tmpfs */, 0x858458f6 /* ramfs */};

std::error_code lastError()
{
    return {errno, std::generic_category()};
}

tl::unexpected<std::error_code> failed()
{
    return tl::unexpected(lastError());
}

class Descriptor {
public:
    explicit Descriptor(int number) : m_number(number) { }
    Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) { }
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(m_number, other.m_number);
        return *this;
    }
    ~Descriptor() { close(); }

    [[nodiscard]] int number() const { return m_number; }
    [[nodiscard]] bool isOpen() const { return m_number >= 0; }
    bool close()
    {
        return m_number < 0 || ::close(std::exchange(m_number, -1)) == 0 || errno == EINTR;
    }

private:
    int m_number;
};

bool writeAll(int descriptor, ByteView bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            return false;
        if (written > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool syncFolder(int descriptor)
{
    // Some file systems have nothing to synchronise about a folder, and say so.
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
}

Descriptor openFolderOf(const fs::path& file)
{
    const fs::path parent = file.has_parent_path() ? file.parent_path() : ".";
    return Descriptor{::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
}

/// A new file in a folder that vanishes unless it is renamed.
class TemporaryFile {
public:
    TemporaryFile(int folder, mode_t mode) : m_folder(folder)
    {
        static std::atomic<unsigned> counter{0};
        do {
            m_name = std::string(temporaryPrefix) + std::to_string(::getpid()) + "-"
                + std::to_string(counter++) + std::string(temporarySuffix);
            m_file = Descriptor{::openat(folder, m_name.c_str(),
                O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode)};
            m_exists = m_file.isOpen();
        } while (!m_exists && errno == EEXIST);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        if (m_exists)
            ::unlinkat(m_folder, m_name.c_str(), 0);
    }

    [[nodiscard]] bool exists() const { return m_exists; }
    [[nodiscard]] int number() const { return m_file.number(); }
    bool close() { return m_file.close(); }
    bool renameTo(const char* name)
    {
        m_exists = ::renameat(m_folder, m_name.c_str(), m_folder, name) != 0;
        return !m_exists;
    }

private:
    int m_folder;
    std::string m_name;
    Descriptor m_file{-1};
    bool m_exists = false;
};

/// The old file's owner where that is allowed, and its mode.
bool takeOver(int descriptor, const struct stat& old)
{
    if (::fchown(descriptor, old.st_uid, old.st_gid) != 0 && errno != EPERM)
        return false;
    return ::fchmod(descriptor, old.st_mode & 0777) == 0;
}

FileState stateFrom(const struct stat& status)
{
    const FileKind kind = S_ISREG(status.st_mode) ? FileKind::Ordinary
        : S_ISDIR(status.st_mode)                 ? FileKind::Folder
        : S_ISLNK(status.st_mode)                 ? FileKind::Link
                                                  : FileKind::Other;
    const auto lastChange = std::chrono::seconds(status.st_mtim.tv_sec)
        + std::chrono::nanoseconds(status.st_mtim.tv_nsec);
    return {kind, static_cast<std::uint64_t>(status.st_size), WallTime(lastChange)};
}

FileSystemFacts::Kind kindOf(std::uint32_t type)
{
    if (std::ranges::find(networkFileSystems, type) != networkFileSystems.end())
        return FileSystemFacts::Kind::Network;
    if (std::ranges::find(memoryFileSystems, type) != memoryFileSystems.end())
        return FileSystemFacts::Kind::Memory;
    return FileSystemFacts::Kind::Disk;
}

/// Of an absolute path in the environment: the XDG specification wants relative ones to be ignored.
fs::path variable(const char* name)
{
    const char* const value = std::getenv(name);
    return value != nullptr && *value == '/' ? fs::path(value) : fs::path();
}

int descriptorOf(std::intptr_t handle)
{
    return static_cast<int>(handle);
}

} // namespace

Outcome<File> File::open(const fs::path& file, Purpose purpose)
{
    constexpr mode_t usualMode = 0666;
    constexpr mode_t ownMode = 0600;
    int flags = O_CLOEXEC;
    switch (purpose) {
    case Purpose::Read:
        flags |= O_RDONLY | O_NONBLOCK;
        break;
    case Purpose::Write:
        flags |= O_WRONLY;
        break;
    case Purpose::Change:
        flags |= O_RDWR | O_CREAT | O_NONBLOCK;
        break;
    case Purpose::Lock:
        flags |= O_RDWR | O_CREAT | O_NOFOLLOW;
        break;
    }
    const int descriptor =
        ::open(file.c_str(), flags, purpose == Purpose::Lock ? ownMode : usualMode);
    if (descriptor < 0)
        return failed();
    return File(descriptor);
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
    struct stat status { };
    if (::fstat(descriptorOf(m_handle), &status) != 0)
        return failed();
    return stateFrom(status);
}

Outcome<FileIdentity> File::identity() const
{
    struct stat status { };
    if (::fstat(descriptorOf(m_handle), &status) != 0)
        return failed();
    return FileIdentity{status.st_dev, status.st_ino};
}

Outcome<std::size_t> File::readAt(std::uint64_t place, std::span<std::byte> bytes) const
{
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t count = ::pread(descriptorOf(m_handle), bytes.data() + filled,
            bytes.size() - filled, static_cast<off_t>(place + filled));
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return failed();
        if (count == 0)
            break;
        filled += static_cast<std::size_t>(count);
    }
    return filled;
}

std::error_code File::writeAt(std::uint64_t place, ByteView bytes)
{
    while (!bytes.empty()) {
        const ssize_t count =
            ::pwrite(descriptorOf(m_handle), bytes.data(), bytes.size(), static_cast<off_t>(place));
        if (count < 0 && errno == EINTR)
            continue;
        if (count <= 0)
            return count < 0 ? lastError() : std::make_error_code(std::errc::io_error);
        place += static_cast<std::uint64_t>(count);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return {};
}

std::error_code File::write(ByteView bytes)
{
    return writeAll(descriptorOf(m_handle), bytes) ? std::error_code() : lastError();
}

std::error_code File::resize(std::uint64_t size)
{
    const int done = ::ftruncate(descriptorOf(m_handle), static_cast<off_t>(size));
    return done == 0 ? std::error_code() : lastError();
}

std::error_code File::flush()
{
    return ::fdatasync(descriptorOf(m_handle)) == 0 ? std::error_code() : lastError();
}

Outcome<bool> File::tryLock()
{
    // Belongs to the open file, not to the process as a lock of fcntl does.
    while (::flock(descriptorOf(m_handle), LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK)
            return false;
        if (errno != EINTR)
            return failed();
    }
    return true;
}

Outcome<bool> File::isLocked() const
{
    // A shared lock: several programs may ask at once.
    while (::flock(descriptorOf(m_handle), LOCK_SH | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK)
            return true;
        if (errno != EINTR)
            return failed();
    }
    ::flock(descriptorOf(m_handle), LOCK_UN);
    return false;
}

std::error_code File::close()
{
    Descriptor descriptor{descriptorOf(std::exchange(m_handle, -1))};
    return descriptor.close() ? std::error_code() : lastError();
}

Outcome<FileState> stateOf(const fs::path& file)
{
    struct stat status { };
    if (::stat(file.c_str(), &status) != 0)
        return failed();
    return stateFrom(status);
}

Outcome<FileState> linkStateOf(const fs::path& file)
{
    struct stat status { };
    if (::lstat(file.c_str(), &status) != 0)
        return failed();
    return stateFrom(status);
}

Outcome<fs::path> endOfLinks(const fs::path& file)
{
    fs::path end = file;
    for (int links = 0; links < maximumLinks; ++links) {
        std::error_code error;
        const fs::path target = fs::read_symlink(end, error);
        if (error)
            return end;
        end = target.is_absolute() ? target : end.parent_path() / target;
    }
    return tl::unexpected(std::make_error_code(std::errc::too_many_symbolic_link_levels));
}

std::error_code replaceFile(const fs::path& file, ByteView bytes)
{
    struct stat status { };
    const bool isThere = ::stat(file.c_str(), &status) == 0;
    if (isThere && ::faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) != 0)
        return lastError();
    const Descriptor folder = openFolderOf(file);
    if (!folder.isOpen())
        return lastError();
    TemporaryFile temporary{folder.number(), isThere ? mode_t{0600} : mode_t{0666}};
    if (!temporary.exists() || (isThere && !takeOver(temporary.number(), status))
        || !writeAll(temporary.number(), bytes) || ::fsync(temporary.number()) != 0
        || !temporary.close() || !temporary.renameTo(file.filename().c_str())
        || !syncFolder(folder.number()))
        return lastError();
    return {};
}

std::error_code removeFile(const fs::path& file)
{
    if (::unlink(file.c_str()) != 0)
        return lastError();
    const Descriptor folder = openFolderOf(file);
    if (!folder.isOpen() || !syncFolder(folder.number()))
        return lastError();
    return {};
}

std::error_code makePrivateFolder(const fs::path& folder)
{
    constexpr mode_t ownMode = 0700;
    const bool isThere = ::mkdir(folder.c_str(), ownMode) == 0 || errno == EEXIST;
    return isThere ? std::error_code() : lastError();
}

Outcome<fs::path> makeTemporaryFolder(const fs::path& parent)
{
    std::string pattern = (parent / "axiscomp-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
        return failed();
    return fs::path(pattern);
}

Outcome<FileIdentity> identityOf(const fs::path& file)
{
    struct stat status { };
    if (::stat(file.c_str(), &status) != 0)
        return failed();
    return FileIdentity{status.st_dev, status.st_ino};
}

bool mayReadAndWrite(const fs::path& file)
{
    return ::faccessat(AT_FDCWD, file.c_str(), R_OK | W_OK, AT_EACCESS) == 0;
}

std::optional<FileSystemFacts> fileSystemOf(const fs::path& path)
{
    struct statfs system { };
    struct statvfs room { };
    if (::statfs(path.c_str(), &system) != 0 || ::statvfs(path.c_str(), &room) != 0)
        return std::nullopt;
    // A file system that makes names as it needs them has 0 of 0.
    return FileSystemFacts{.kind = kindOf(static_cast<std::uint32_t>(system.f_type)),
        .isReadOnly = (room.f_flag & ST_RDONLY) != 0,
        .takesFiles = room.f_files == 0 || room.f_favail > 0,
        .freeBytes = static_cast<std::uint64_t>(room.f_bavail) * room.f_frsize};
}

fs::path stateFolder()
{
    if (fs::path state = variable("XDG_STATE_HOME"); !state.empty())
        return state;
    fs::path home = variable("HOME");
    if (home.empty()) {
        std::array<char, 16384> buffer{};
        struct passwd entry { };
        struct passwd* found = nullptr;
        if (::getpwuid_r(::geteuid(), &entry, buffer.data(), buffer.size(), &found) == 0 && found)
            home = entry.pw_dir;
    }
    return home / ".local" / "state";
}

fs::path programFolder()
{
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

void preferLargePages(void* begin, std::size_t size)
{
    constexpr std::size_t enough = std::size_t{3}
        << 20; // one large page at least, wherever it begins
    constexpr std::uintptr_t page = 4096;
    if (size < enough)
        return;
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t first = (address + page - 1) / page * page;
    ::madvise(reinterpret_cast<void*>(first), address + size - first, MADV_HUGEPAGE);
}

std::chrono::nanoseconds timeSinceStart()
{
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
}

fs::path pathFromText(std::string_view text)
{
    // A name is bytes, and need not be UTF-8: it stays as it is.
    return {text};
}

fs::path nativeName(const fs::path& file)
{
    return file;
}

std::optional<std::string> fromGbk(std::string_view bytes)
{
    const iconv_t converter = ::iconv_open("UTF-8", "GBK");
    if (converter == reinterpret_cast<iconv_t>(-1))
        return std::nullopt;
    std::string input(bytes);
    std::string output(2 * input.size(), '\0');
    char* from = input.data();
    char* to = output.data();
    std::size_t fromLeft = input.size();
    std::size_t toLeft = output.size();
    const std::size_t result = ::iconv(converter, &from, &fromLeft, &to, &toLeft);
    ::iconv_close(converter);
    if (result == static_cast<std::size_t>(-1))
        return std::nullopt;
    output.resize(output.size() - toLeft);
    return output;
}

std::optional<std::string> numericAddress(const std::string& host)
{
    std::array<char, INET6_ADDRSTRLEN> text{};
    struct in6_addr six { };
    if (::inet_pton(AF_INET6, host.c_str(), &six) == 1)
        return ::inet_ntop(AF_INET6, &six, text.data(), text.size());
    struct in_addr four { };
    if (::inet_aton(host.c_str(), &four) != 0)
        return ::inet_ntop(AF_INET, &four, text.data(), text.size());
    return std::nullopt;
}

bool isQuotaUsedUp(const std::error_code& error)
{
    return error.value() == EDQUOT; // of whichever category: both have the numbers of errno
}

std::string messageOf(const std::error_code& error)
{
    return error.message();
}

} // namespace axiscomp::system
