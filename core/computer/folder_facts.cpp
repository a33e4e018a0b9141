// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/folder_facts.h"

#include <array>
#include <cerrno>
#include <cstdlib>

#include <fcntl.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

namespace axiscomp {

namespace {

namespace fs = std::filesystem;

std::string accountName(uid_t id)
{
    passwd entry{};
    passwd* found = nullptr;
    std::array<char, 16384> buffer{};
    if (::getpwuid_r(id, &entry, buffer.data(), buffer.size(), &found) != 0 || found == nullptr)
        return std::to_string(id);
    return found->pw_name;
}

} // namespace

FolderFacts folderFacts(const fs::path& path)
{
    FolderFacts facts{path};
    facts.isRoot = ::geteuid() == 0;
    facts.nearest = path;
    struct stat status { };
    bool isHidden = false;
    // A part of the path that is no folder, or may not be entered, hides what is below it.
    while (::stat(facts.nearest.c_str(), &status) != 0) {
        isHidden = errno == EACCES;
        const fs::path parent = facts.nearest.parent_path();
        if (parent.empty() || parent == facts.nearest)
            return facts;
        facts.nearest = parent;
    }
    const bool isFolder = S_ISDIR(status.st_mode);
    if (!isFolder)
        facts.kind = FolderFacts::Kind::Blocked;
    else if (isHidden)
        facts.kind = FolderFacts::Kind::Hidden;
    else if (facts.nearest == path)
        facts.kind = FolderFacts::Kind::Folder;
    facts.mayUse = isFolder
        && ::faccessat(AT_FDCWD, facts.nearest.c_str(), R_OK | W_OK | X_OK, AT_EACCESS) == 0;
    facts.isOwn = status.st_uid == ::geteuid();
    facts.owner = accountName(status.st_uid);
    facts.mode = status.st_mode & 07777U;
    facts.fileSystem = system::fileSystemOf(facts.nearest);
    return facts;
}

fs::path temporaryFolder()
{
    for (const char* name : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"})
        if (const char* const folder = std::getenv(name))
            return folder;
    return "/tmp";
}

} // namespace axiscomp
