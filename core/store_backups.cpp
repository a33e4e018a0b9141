// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store_backups.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

namespace axiscomp {

namespace {

constexpr std::size_t keptBackups = 50;

std::string axisSuffix(int axis)
{
    return "-axis" + std::to_string(axis);
}

/// Colons are not welcome on every file system.
std::string backupName(WallTime time, int axis, int number)
{
    std::string stamp = utcText(time);
    std::ranges::replace(stamp, ':', '-');
    return stamp + axisSuffix(axis) + (number > 1 ? "-" + std::to_string(number) : "") + ".json";
}

struct BackupFile {
    WallTime time{};
    int number = 1;
    std::filesystem::path path;
};

/// The file as one of saveBackup's for the axis, if it is one.
std::optional<BackupFile> asBackupFile(const std::filesystem::path& path, int axis)
{
    const std::string name = path.filename().string();
    const std::size_t end = name.find(axisSuffix(axis));
    if (end == std::string::npos || end < 19)
        return std::nullopt;
    std::string stamp = name.substr(0, end);
    stamp[13] = stamp[16] = ':';
    const auto time = utcFromText(stamp);
    if (!time)
        return std::nullopt;

    BackupFile file{*time, 1, path};
    const std::size_t number = end + axisSuffix(axis).size();
    if (name.substr(number).starts_with("-"))
        std::from_chars(name.data() + number + 1, name.data() + name.size(), file.number);
    return name == backupName(file.time, axis, file.number) ? std::optional(file) : std::nullopt;
}

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (std::filesystem::directory_iterator i{folder, error}, end; i != end && !error;
         i.increment(error))
        files.push_back(i->path());
    return files;
}

} // namespace

std::filesystem::path newBackupFile(const StoreFolder& folder, WallTime time, int axis)
{
    std::filesystem::path file;
    for (int number = 1; file.empty() || !isMissing(file); ++number)
        file = folder.backups() / backupName(time, axis, number);
    return file;
}

std::vector<std::filesystem::path> backupFiles(const StoreFolder& folder, int axis)
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

void pruneBackups(const StoreFolder& folder, int axis, const std::filesystem::path& justMade)
{
    std::error_code ignored;
    for (const std::filesystem::path& place : {folder.path(), folder.backups()})
        for (const std::filesystem::path& file : filesIn(place))
            if (isTemporaryFile(file))
                std::filesystem::remove(file, ignored);

    std::filesystem::path inJournal;
    if (const std::filesystem::path journal = folder.journal(axis); !isMissing(journal)) {
        const auto bytes = loadFile(journal, maximumDocumentSize);
        const auto entry = readJournal(bytes ? asText(*bytes) : std::string_view(), folder.path());
        if (!entry)
            return; // it may name any of them
        inJournal = entry->backup;
    }
    std::vector<std::filesystem::path> old = backupFiles(folder, axis);
    std::erase(old, justMade);
    for (std::size_t i = keptBackups - 1; i < old.size(); ++i)
        if (old[i] != inJournal)
            std::filesystem::remove(old[i], ignored);
}

} // namespace axiscomp
