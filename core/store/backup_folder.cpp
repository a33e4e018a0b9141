// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/backup_folder.h"

#include "core/io/local_file.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

namespace axiscomp {

namespace {

constexpr std::size_t keptBackups = 50;

std::string suffixOf(std::optional<int> axis)
{
    return axis ? "-axis" + std::to_string(*axis) : "-file";
}

/// Colons are not welcome on every file system.
std::string backupName(WallTime time, std::optional<int> axis, int number)
{
    std::string stamp = utcText(time);
    std::ranges::replace(stamp, ':', '-');
    return stamp + suffixOf(axis) + (number > 1 ? "-" + std::to_string(number) : "") + ".json";
}

struct BackupFile {
    WallTime time{};
    int number = 1;
    std::filesystem::path path;
};

/// The file as one of saveBackup's for the axis, if it is one.
std::optional<BackupFile> asBackupFile(const std::filesystem::path& path, std::optional<int> axis)
{
    const std::string name = path.filename().string();
    const std::size_t end = name.find(suffixOf(axis));
    if (end == std::string::npos || end < 19)
        return std::nullopt;
    std::string stamp = name.substr(0, end);
    stamp[13] = stamp[16] = ':';
    const auto time = utcFromText(stamp);
    if (!time)
        return std::nullopt;

    BackupFile file{*time, 1, path};
    const std::size_t number = end + suffixOf(axis).size();
    if (name.substr(number).starts_with("-"))
        std::from_chars(name.data() + number + 1, name.data() + name.size(), file.number);
    return name == backupName(file.time, axis, file.number) ? std::optional(file) : std::nullopt;
}

} // namespace

std::filesystem::path newBackupFile(
    const StoreFolder& folder, WallTime time, std::optional<int> axis)
{
    std::filesystem::path file;
    for (int number = 1; file.empty() || !isMissing(file); ++number)
        file = folder.backups() / backupName(time, axis, number);
    return file;
}

std::vector<std::filesystem::path> backupFiles(const StoreFolder& folder, std::optional<int> axis)
{
    std::vector<BackupFile> backups;
    for (const std::filesystem::path& file : filesIn(folder.backups()))
        if (auto backup = asBackupFile(file, axis))
            backups.push_back(*std::move(backup));
    std::ranges::sort(backups, std::greater<>{},
        [](const BackupFile& file) { return std::pair(file.time, file.number); });
    std::vector<std::filesystem::path> files;
    for (BackupFile& backup : backups)
        files.push_back(std::move(backup.path));
    return files;
}

std::optional<WallTime> timeOfBackup(const std::filesystem::path& file, int axis)
{
    const auto backup = asBackupFile(file, axis);
    return backup ? std::optional(backup->time) : std::nullopt;
}

void pruneBackups(const StoreFolder& folder, std::optional<int> axis,
    const std::filesystem::path& justMade, const std::filesystem::path& inJournal)
{
    std::error_code ignored;
    for (const std::filesystem::path& place : {folder.path(), folder.backups()})
        for (const std::filesystem::path& file : filesIn(place))
            if (isTemporaryFile(file))
                std::filesystem::remove(file, ignored);

    std::vector<std::filesystem::path> old = backupFiles(folder, axis);
    std::erase(old, justMade);
    for (std::size_t i = keptBackups - 1; i < old.size(); ++i)
        if (old[i] != inJournal)
            std::filesystem::remove(old[i], ignored);
}

} // namespace axiscomp
