// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/backup_folder.h"

#include "core/io/local_file.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace axiscomp {

namespace {

constexpr std::size_t keptBackups = 50;

std::string suffixOf(std::optional<int> axis)
{
    return axis ? "-axis" + std::to_string(*axis) : "-file";
}

constexpr std::string_view clockMark = "-clock";

struct BackupFile {
    WallTime time{};
    int number = 1; ///< among those of one moment
    /// Counted on whenever the computer's clock is behind the newest backup: the time alone would
    /// say that a backup from before the clock was set back is newer.
    int clock = 1;
    std::filesystem::path path;

    /// In the order in which they were made.
    [[nodiscard]] auto turn() const { return std::tuple(clock, time, number); }
};

/// Colons are not welcome on every file system.
std::string backupName(const BackupFile& file, std::optional<int> axis)
{
    std::string stamp = utcText(file.time);
    std::ranges::replace(stamp, ':', '-');
    return stamp + suffixOf(axis)
        + (file.clock > 1 ? std::string(clockMark) + std::to_string(file.clock) : "")
        + (file.number > 1 ? "-" + std::to_string(file.number) : "") + ".json";
}

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

    BackupFile file{.time = *time, .path = path};
    std::string_view rest = std::string_view(name).substr(end + suffixOf(axis).size());
    if (rest.starts_with(clockMark)) {
        const char* const digits = rest.data() + clockMark.size();
        const auto [after, error] = std::from_chars(digits, rest.data() + rest.size(), file.clock);
        rest.remove_prefix(static_cast<std::size_t>(after - rest.data()));
    }
    if (rest.starts_with("-"))
        std::from_chars(rest.data() + 1, rest.data() + rest.size(), file.number);
    return name == backupName(file, axis) ? std::optional(file) : std::nullopt;
}

/// The backups of the axis, newest first.
std::vector<BackupFile> madeFiles(const StoreFolder& folder, std::optional<int> axis)
{
    std::vector<BackupFile> backups;
    for (const std::filesystem::path& file : filesIn(folder.backups()))
        if (auto backup = asBackupFile(file, axis))
            backups.push_back(*std::move(backup));
    std::ranges::sort(
        backups, std::greater<>{}, [](const BackupFile& file) { return file.turn(); });
    return backups;
}

} // namespace

std::filesystem::path newBackupFile(
    const StoreFolder& folder, WallTime time, std::optional<int> axis)
{
    const std::vector<BackupFile> before = madeFiles(folder, axis);
    BackupFile file{.time = time, .path = {}};
    if (!before.empty())
        file.clock = before.front().clock + (time < before.front().time ? 1 : 0);
    const auto place = [&] { return folder.backups() / backupName(file, axis); };
    while (!isMissing(place()))
        ++file.number;
    return place();
}

std::vector<std::filesystem::path> backupFiles(const StoreFolder& folder, std::optional<int> axis)
{
    std::vector<std::filesystem::path> files;
    for (BackupFile& backup : madeFiles(folder, axis))
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
