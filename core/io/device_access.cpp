// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/device_access.h"

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <vector>

namespace axiscomp {

namespace {

std::string groupName(gid_t id)
{
    group entry{};
    group* found = nullptr;
    std::array<char, 16384> buffer{};
    if (::getgrgid_r(id, &entry, buffer.data(), buffer.size(), &found) != 0 || found == nullptr)
        return std::to_string(id);
    return found->gr_name;
}

/// As the computer knows the account now, whatever this session began with.
bool isAccountIn(gid_t id)
{
    passwd entry{};
    passwd* found = nullptr;
    std::array<char, 16384> buffer{};
    if (::getpwuid_r(::geteuid(), &entry, buffer.data(), buffer.size(), &found) != 0
        || found == nullptr)
        return false;
    int count = 64;
    std::vector<gid_t> groups(static_cast<std::size_t>(count));
    while (::getgrouplist(found->pw_name, found->pw_gid, groups.data(), &count) < 0) {
        if (count <= static_cast<int>(groups.size()))
            return false;
        groups.resize(static_cast<std::size_t>(count));
    }
    groups.resize(static_cast<std::size_t>(count));
    return std::ranges::find(groups, id) != groups.end();
}

bool isSessionIn(gid_t id)
{
    const int count = ::getgroups(0, nullptr);
    std::vector<gid_t> groups(static_cast<std::size_t>(std::max(count, 0)));
    if (count > 0 && ::getgroups(count, groups.data()) != count)
        return false;
    return ::getegid() == id || std::ranges::find(groups, id) != groups.end();
}

DeviceGroup groupOf(const std::string& device)
{
    struct stat status { };
    constexpr mode_t groupMayUse = S_IRGRP | S_IWGRP;
    constexpr gid_t root = 0;
    if (::stat(device.c_str(), &status) != 0 || (status.st_mode & groupMayUse) != groupMayUse
        || status.st_gid == root)
        return {};
    return {groupName(status.st_gid), isAccountIn(status.st_gid), isSessionIn(status.st_gid)};
}

} // namespace

DeviceObstacle noPermission(const DeviceGroup& group)
{
    if (group.name.empty())
        return {.found = AXISCOMP_TEXT(
                    "Error", "you have no permission to use the port, and no group has it"),
            .wayOut = AXISCOMP_TEXT("Error", "ask the administrator"),
            .systemError = EACCES};
    if (group.hasSession)
        return {.found = AXISCOMP_TEXT("Error",
                    "you have no permission to use the port, although you are in its group {group}")
                             .with("group", group.name),
            .wayOut = AXISCOMP_TEXT("Error", "ask the administrator"),
            .systemError = EACCES};
    if (group.hasAccount)
        return {.found = AXISCOMP_TEXT("Error",
                    "you have no permission to use the port: you are in the group {group}, but "
                    "this session is older than that")
                             .with("group", group.name),
            .wayOut = AXISCOMP_TEXT("Error", "log out and in again"),
            .group = group.name,
            .systemError = EACCES};
    return {.found = AXISCOMP_TEXT("Error", "you have no permission to use the port"),
        .wayOut = AXISCOMP_TEXT(
            "Error", "join the group {group} (sudo usermod -aG {name} $USER) and log in again")
                      .with("group", group.name)
                      .with("name", group.name),
        .group = group.name,
        .systemError = EACCES};
}

DeviceAccess deviceAccess(const std::string& path)
{
    const std::unique_ptr<char, decltype(&std::free)> resolved(
        ::realpath(path.c_str(), nullptr), &std::free);
    if (!resolved && errno == EACCES)
        return {{},
            DeviceObstacle{
                .found = AXISCOMP_TEXT("Error", "you have no permission to look into its folder"),
                .systemError = EACCES}};
    if (!resolved)
        return {{},
            DeviceObstacle{.found = AXISCOMP_TEXT("Error", "there is no such port"),
                .wayOut = AXISCOMP_TEXT("Error", "is the cable or the adapter plugged in?"),
                .systemError = errno}};
    const std::string device = resolved.get();
    if (::faccessat(AT_FDCWD, device.c_str(), R_OK | W_OK, AT_EACCESS) == 0)
        return {device, std::nullopt};
    if (errno == EACCES || errno == EPERM)
        return {device, noPermission(groupOf(device))};
    return {device,
        DeviceObstacle{
            .found = AXISCOMP_TEXT("Error", "the port cannot be used"), .systemError = errno}};
}

} // namespace axiscomp
