// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace axiscomp {

namespace {

constexpr std::string_view temporaryPrefix = ".axiscomp-";
constexpr std::string_view temporarySuffix = ".tmp";
constexpr int maximumLinks = 40; // as the kernel

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

tl::unexpected<Error> notWritable(const std::filesystem::path& file, int errorNumber)
{
    Text reason = fileErrorReason(errorNumber);
    if (errorNumber == ENOENT)
        reason = AXISCOMP_TEXT("Error", "the folder {folder} does not exist")
                     .with("folder", std::filesystem::absolute(file).parent_path().string());
    return fail(ErrorCode::FileNotWritable, {{"file", file.string()}, {"reason", reason}});
}

tl::unexpected<Error> notReadable(const std::filesystem::path& file, int errorNumber)
{
    return fail(ErrorCode::FileNotReadable,
        {{"file", file.string()}, {"reason", fileErrorReason(errorNumber)}});
}

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

/// Where a chain of symbolic links ends: an ordinary file, or a name that does not exist yet.
std::optional<std::filesystem::path> followLinks(std::filesystem::path file)
{
    for (int links = 0; links < maximumLinks; ++links) {
        std::error_code error;
        const std::filesystem::path target = std::filesystem::read_symlink(file, error);
        if (error)
            return file;
        file = target.is_absolute() ? target : file.parent_path() / target;
    }
    errno = ELOOP;
    return std::nullopt;
}

Result<void> writeDirectly(const std::filesystem::path& file, ByteView bytes)
{
    Descriptor device{::open(file.c_str(), O_WRONLY | O_CLOEXEC)};
    if (!device.isOpen() || !writeAll(device.number(), bytes) || !device.close())
        return notWritable(file, errno);
    return {};
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

/// file: no symbolic link; old: what it is now, if it exists.
Result<void> replace(
    const std::filesystem::path& file, const std::optional<struct stat>& old, ByteView bytes)
{
    const std::filesystem::path parent = file.has_parent_path() ? file.parent_path() : ".";
    const Descriptor folder{::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (!folder.isOpen())
        return notWritable(file, errno);
    TemporaryFile temporary{folder.number(), old ? mode_t{0600} : mode_t{0666}};
    if (!temporary.exists() || (old && !takeOver(temporary.number(), *old))
        || !writeAll(temporary.number(), bytes) || ::fsync(temporary.number()) != 0
        || !temporary.close() || !temporary.renameTo(file.filename().c_str())
        || !syncFolder(folder.number()))
        return notWritable(file, errno);
    return {};
}

/// Reads from an offset on until the space is full or the file ends. Returns what was read; none:
/// an error.
std::optional<std::size_t> readAt(int descriptor, std::size_t offset, std::span<std::byte> space)
{
    std::size_t filled = 0;
    while (filled < space.size()) {
        const ssize_t count = ::pread(descriptor, space.data() + filled, space.size() - filled,
            static_cast<off_t>(offset + filled));
        if (count < 0 && errno != EINTR)
            return std::nullopt;
        if (count == 0)
            break;
        filled += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    return filled;
}

/// Several threads read pieces of the bytes. False: one of them came out short, or there was an
/// error.
bool readTogether(int descriptor, std::size_t threads, std::span<std::byte> bytes)
{
    constexpr std::size_t piece = std::size_t{1} << 20U;
    std::atomic<bool> isWhole = true;
    shareWork((bytes.size() + piece - 1) / piece, threads, [&](std::size_t index) {
        const std::size_t offset = index * piece;
        const auto part = bytes.subspan(offset, std::min(piece, bytes.size() - offset));
        if (readAt(descriptor, offset, part) != part.size())
            isWhole = false;
    });
    return isWhole;
}

/// Reads to the end, or one byte more than the maximum. A file may be longer than it says
/// (expected) while somebody writes to it, or shorter.
template <typename Content>
bool readAll(int descriptor, std::uint64_t expected, std::uint64_t maximumSize, std::size_t threads,
    Content& content)
{
    constexpr std::uint64_t firstBlock = 4096;
    content.resize(static_cast<std::size_t>(std::max(firstBlock, expected + 1)));
    std::size_t filled = 0;
    if (readTogether(descriptor, threads, {content.data(), static_cast<std::size_t>(expected)}))
        filled = static_cast<std::size_t>(expected);
    while (filled <= maximumSize) {
        if (filled == content.size())
            content.resize(static_cast<std::size_t>(
                std::min(maximumSize + 1, 2 * std::uint64_t{content.size()})));
        const auto count =
            readAt(descriptor, filled, {content.data() + filled, content.size() - filled});
        if (!count)
            return false;
        filled += *count;
        if (filled < content.size())
            break;
    }
    content.resize(filled);
    return true;
}

/// Straight into what is asked for: a second copy would be memory for nothing.
template <typename Content>
Result<Content> load(
    const std::filesystem::path& file, std::uint64_t maximumSize, std::size_t threads)
try {
    // Does not wait for somebody to write into a pipe.
    const Descriptor descriptor{::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    struct stat status { };
    if (!descriptor.isOpen() || ::fstat(descriptor.number(), &status) != 0)
        return notReadable(file, errno);
    if (S_ISDIR(status.st_mode))
        return notReadable(file, EISDIR);
    if (!S_ISREG(status.st_mode))
        return fail(ErrorCode::FileNotReadable,
            {{"file", file.string()},
                {"reason", AXISCOMP_TEXT("Error", "it is a pipe or a device, not a file")}});

    const auto tooLarge = [&](const Argument& size) {
        return fail(ErrorCode::FileTooLarge,
            {{"file", file.string()}, {"size", size}, {"limit", maximumSize}});
    };
    const auto expected = static_cast<std::uint64_t>(status.st_size);
    if (expected > maximumSize)
        return tooLarge(expected);

    // One byte more is asked for to see that nothing follows.
    const std::uint64_t readable =
        std::min<std::uint64_t>(maximumSize, std::numeric_limits<std::int64_t>::max());
    Content content;
    if (!readAll(descriptor.number(), expected, readable, threads, content))
        return notReadable(file, errno);
    if (content.size() > maximumSize)
        return tooLarge(AXISCOMP_TEXT("Error", "more than {size}").with("size", maximumSize));
    return content;
} catch (const std::bad_alloc&) {
    return notReadable(file, ENOMEM);
}

} // namespace

Text fileErrorReason(int errorNumber)
{
    switch (errorNumber) {
    case ENOENT:
        return AXISCOMP_TEXT("Error", "it does not exist");
    case EACCES:
    case EPERM:
        return AXISCOMP_TEXT("Error", "no permission");
    case ENOSPC:
        return AXISCOMP_TEXT("Error", "the disk is full");
    case EDQUOT:
        return AXISCOMP_TEXT("Error", "the disk quota is used up");
    case EROFS:
        return AXISCOMP_TEXT("Error", "the file system is read-only");
    case EISDIR:
        return AXISCOMP_TEXT("Error", "it is a folder");
    case ENOTDIR:
        return AXISCOMP_TEXT("Error", "a part of the path is not a folder");
    case ENAMETOOLONG:
        return AXISCOMP_TEXT("Error", "the name is too long");
    case ELOOP:
        return AXISCOMP_TEXT("Error", "its symbolic links lead in a circle");
    case EFBIG:
        return AXISCOMP_TEXT("Error", "it would be larger than a file may be here");
    case EIO:
        return AXISCOMP_TEXT("Error", "the disk reports an error");
    case ENOMEM:
        return AXISCOMP_TEXT("Error", "there is not enough memory");
    default:
        return Verbatim{std::generic_category().message(errorNumber)};
    }
}

Result<void> saveFile(const std::filesystem::path& file, ByteView bytes)
{
    // What the path leads to decides, before any link is followed by name: "/dev/stdout" is a link
    // to something that has no name.
    struct stat status { };
    std::optional<struct stat> old;
    if (::stat(file.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode))
            return notWritable(file, EISDIR);
        if (!S_ISREG(status.st_mode))
            return writeDirectly(file, bytes);
        if (::faccessat(AT_FDCWD, file.c_str(), W_OK, AT_EACCESS) != 0)
            return notWritable(file, errno);
        old = status;
    }
    const auto target = followLinks(file);
    if (!target || !target->has_filename())
        return notWritable(file, target ? EISDIR : errno);
    return replace(*target, old, bytes);
}

void FileContent::resize(std::size_t size)
{
    if (size > m_size) {
        auto larger = std::make_unique_for_overwrite<std::byte[]>(size);
        std::copy_n(m_bytes.get(), m_size, larger.get());
        m_bytes = std::move(larger);
    }
    m_size = size;
}

Result<FileContent> loadContent(
    const std::filesystem::path& file, std::uint64_t maximumSize, std::size_t threads)
{
    return load<FileContent>(file, maximumSize, threads);
}

Result<Bytes> loadFile(const std::filesystem::path& file, std::uint64_t maximumSize)
{
    return load<Bytes>(file, maximumSize, 1);
}

Result<void> checkOrdinaryFile(const std::filesystem::path& file)
{
    struct stat status { };
    if (::lstat(file.c_str(), &status) != 0 || S_ISREG(status.st_mode))
        return {};
    return fail(ErrorCode::FileNotReadable,
        {{"file", file.string()},
            {"reason", AXISCOMP_TEXT("Error", "it is not an ordinary file; move it away")}});
}

Result<Bytes> loadOrdinaryFile(const std::filesystem::path& file, std::uint64_t maximumSize)
{
    AXISCOMP_CHECK(checkOrdinaryFile(file));
    return loadFile(file, maximumSize);
}

Result<void> removeFile(const std::filesystem::path& file)
{
    if (::unlink(file.c_str()) != 0)
        return errno == ENOENT ? Result<void>{} : notWritable(file, errno);
    const std::filesystem::path parent = file.has_parent_path() ? file.parent_path() : ".";
    const Descriptor folder{::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (!folder.isOpen() || !syncFolder(folder.number()))
        return notWritable(file, errno);
    return {};
}

bool isTemporaryFile(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    return name.starts_with(temporaryPrefix) && name.ends_with(temporarySuffix);
}

} // namespace axiscomp
