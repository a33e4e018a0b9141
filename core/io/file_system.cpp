// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/file_system.h"

#include <algorithm>
#include <array>

#include <sys/statvfs.h>
#include <sys/vfs.h>

namespace axiscomp {

namespace {

// linux/magic.h
constexpr std::array<std::uint32_t, 6> networkFileSystems{0x6969 /* NFS */, 0x517b /* SMB */,
    0xfe534d42 /* SMB 2 */, 0xff534d42 /* CIFS */, 0x73757245 /* Coda */, 0x5346414f /* AFS */};
constexpr std::array<std::uint32_t, 2> memoryFileSystems{
    0x01021994 /* tmpfs */, 0x858458f6 /* ramfs */};

FileSystemFacts::Kind kindOf(std::uint32_t type)
{
    if (std::ranges::find(networkFileSystems, type) != networkFileSystems.end())
        return FileSystemFacts::Kind::Network;
    if (std::ranges::find(memoryFileSystems, type) != memoryFileSystems.end())
        return FileSystemFacts::Kind::Memory;
    return FileSystemFacts::Kind::Disk;
}

} // namespace

std::optional<FileSystemFacts> fileSystemOf(const std::filesystem::path& path)
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

} // namespace axiscomp
