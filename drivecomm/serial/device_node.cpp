// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/device_node.h"

#include <fcntl.h>
#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace axiscomp::drivecomm {

namespace {

tl::unexpected<Error> unusable(Text reason, int error)
{
    // NOLINTNEXTLINE(concurrency-mt-unsafe): glibc's is thread-safe
    const char* detail = std::strerror(error);
    return fail(ErrorCode::NotConnected, {{"reason", std::move(reason)}}, detail);
}

std::string groupName(gid_t id)
{
    group entry{};
    group* found = nullptr;
    std::array<char, 16384> buffer{};
    if (::getgrgid_r(id, &entry, buffer.data(), buffer.size(), &found) != 0 || found == nullptr)
        return std::to_string(id);
    return found->gr_name;
}

Text whoMayUse(const std::string& device)
{
    struct stat status { };
    constexpr mode_t groupMayUse = S_IRGRP | S_IWGRP;
    constexpr gid_t root = 0;
    if (::stat(device.c_str(), &status) != 0 || (status.st_mode & groupMayUse) != groupMayUse
        || status.st_gid == root)
        return AXISCOMP_TEXT("Error",
            "you have no permission to use the port, and no group has it; ask the administrator");
    const std::string group = groupName(status.st_gid);
    return AXISCOMP_TEXT("Error",
        "you have no permission to use the port; join the group {group} (sudo usermod -aG {name} "
        "$USER) and log in again")
        .with("group", group)
        .with("name", group);
}

} // namespace

Result<std::string> usableDevice(const std::string& path)
{
    const std::unique_ptr<char, decltype(&std::free)> resolved(
        ::realpath(path.c_str(), nullptr), &std::free);
    if (!resolved && errno == EACCES)
        return unusable(
            AXISCOMP_TEXT("Error", "you have no permission to look into its folder"), EACCES);
    if (!resolved)
        return unusable(AXISCOMP_TEXT("Error",
                            "there is no such port; is the cable or the adapter plugged in?"),
            errno);
    const std::string device = resolved.get();
    if (::faccessat(AT_FDCWD, device.c_str(), R_OK | W_OK, AT_EACCESS) == 0)
        return device;
    if (errno == EACCES || errno == EPERM)
        return unusable(whoMayUse(device), errno);
    return unusable(AXISCOMP_TEXT("Error", "the port cannot be used"), errno);
}

} // namespace axiscomp::drivecomm
