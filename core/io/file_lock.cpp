// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/file_lock.h"

#include "core/io/local_file.h"

#include <cerrno>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace axiscomp {

namespace {

// flock has no time-out of its own; a store operation takes a few milliseconds.
constexpr std::chrono::milliseconds lockPollInterval{10};

tl::unexpected<Error> notLocked(const std::filesystem::path& what, const Text& reason)
{
    return fail(ErrorCode::FileNotWritable, {{"file", what.string()}, {"reason", reason}});
}

} // namespace

Result<std::optional<FileLock>> FileLock::tryAcquire(
    const std::filesystem::path& lockFile, const std::filesystem::path& what)
{
    const int descriptor =
        ::open(lockFile.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (descriptor < 0)
        return notLocked(what, fileErrorReason(errno));
    FileLock lock{descriptor};
    while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK)
            return std::nullopt;
        if (errno != EINTR)
            return notLocked(what,
                AXISCOMP_TEXT("Error", "it cannot be locked: {reason}")
                    .with("reason", fileErrorReason(errno)));
    }
    return lock;
}

Result<FileLock> FileLock::acquire(const std::filesystem::path& lockFile,
    std::chrono::milliseconds longestWait, const std::filesystem::path& what)
{
    const auto end = std::chrono::steady_clock::now() + longestWait;
    while (true) {
        AXISCOMP_TRY(auto lock, tryAcquire(lockFile, what));
        if (lock)
            return *std::move(lock);
        if (std::chrono::steady_clock::now() >= end)
            return notLocked(what,
                AXISCOMP_TEXT(
                    "Error", "another program is using it; try again when that one has finished"));
        std::this_thread::sleep_for(lockPollInterval);
    }
}

bool FileLock::isHeld(const std::filesystem::path& lockFile)
{
    const FileLock probe{::open(lockFile.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK)};
    return probe.m_descriptor >= 0 && ::flock(probe.m_descriptor, LOCK_SH | LOCK_NB) != 0
        && errno == EWOULDBLOCK;
}

FileLock::FileLock(FileLock&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1))
{
}

FileLock& FileLock::operator=(FileLock&& other) noexcept
{
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
}

FileLock::~FileLock()
{
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

} // namespace axiscomp
