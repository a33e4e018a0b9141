// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/file_lock.h"

#include "core/io/local_file.h"

#include <thread>

namespace axiscomp {

namespace {

// The system's locks have no time-out of their own; a store operation takes a few milliseconds.
constexpr std::chrono::milliseconds lockPollInterval{10};

tl::unexpected<Error> notLocked(const std::filesystem::path& what, const Text& reason)
{
    return fail(ErrorCode::FileNotWritable, {{"file", what.string()}, {"reason", reason}});
}

} // namespace

Result<std::optional<FileLock>> FileLock::tryAcquire(
    const std::filesystem::path& lockFile, const std::filesystem::path& what)
{
    auto file = system::File::open(lockFile, system::File::Purpose::Lock);
    if (!file)
        return notLocked(what, fileErrorReason(file.error()));
    const auto isLocked = file->tryLock();
    if (!isLocked)
        return notLocked(what,
            AXISCOMP_TEXT("Error", "it cannot be locked: {reason}")
                .with("reason", fileErrorReason(isLocked.error())));
    if (!*isLocked)
        return std::nullopt;
    return FileLock(*std::move(file));
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
    const auto state = system::linkStateOf(lockFile);
    if (!state || state->kind != system::FileKind::Ordinary)
        return false;
    const auto file = system::File::open(lockFile, system::File::Purpose::Read);
    return file && file->isLocked().value_or(false);
}

} // namespace axiscomp
