// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_folder.h"

#include "core/io/local_file.h"
#include "core/io/system.h"
#include "core/store/backup_json.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace axiscomp {

namespace {

constexpr const char* keptTableEnding = ".TAMtbl";

} // namespace

Result<void> makePrivateFolder(const std::filesystem::path& folder)
{
    std::error_code error;
    if (folder.empty() || std::filesystem::is_directory(folder, error))
        return {};
    if (auto parent = makePrivateFolder(folder.parent_path()); !parent)
        return parent;
    if (const auto problem = system::makePrivateFolder(folder))
        return fail(ErrorCode::FileNotWritable,
            {{"file", folder.string()}, {"reason", fileErrorReason(problem)}});
    return {};
}

bool isMissing(const std::filesystem::path& file)
{
    std::error_code error;
    return std::filesystem::symlink_status(file, error).type()
        == std::filesystem::file_type::not_found;
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

std::vector<std::int32_t> drivesIn(const std::filesystem::path& root)
{
    std::vector<std::int32_t> drives;
    for (const std::filesystem::path& folder : filesIn(root)) {
        const std::string name = folder.filename().string();
        std::int32_t serialNumber = 0;
        std::from_chars(name.data(), name.data() + name.size(), serialNumber);
        if (std::to_string(serialNumber) == name)
            drives.push_back(serialNumber);
    }
    std::ranges::sort(drives);
    return drives;
}

Result<void> renameFile(const std::filesystem::path& from, const std::filesystem::path& to)
{
    std::error_code error;
    std::filesystem::rename(from, to, error);
    if (!error || isMissing(from))
        return {};
    return fail(ErrorCode::FileNotWritable,
        {{"file", from.string()},
            {"reason",
                AXISCOMP_TEXT("Error", "it cannot be renamed: {reason}")
                    .with("reason", fileErrorReason(error))}});
}

StoreFolder::StoreFolder(const std::filesystem::path& root, std::int32_t serialNumber,
    std::chrono::milliseconds lockWait)
    : m_path(root / std::to_string(serialNumber))
    , m_lockWait(lockWait)
{
}

std::filesystem::path StoreFolder::keptTable(int axis, std::uint32_t crc) const
{
    return m_path / ("journal-axis" + std::to_string(axis) + "-" + crcText(crc) + keptTableEnding);
}

std::vector<std::filesystem::path> StoreFolder::keptTables(int axis) const
{
    const std::string beginning = "journal-axis" + std::to_string(axis) + "-";
    std::vector<std::filesystem::path> tables = filesIn(m_path);
    std::erase_if(tables, [&](const std::filesystem::path& file) {
        const std::string name = file.filename().string();
        return !name.starts_with(beginning) || !name.ends_with(keptTableEnding);
    });
    return tables;
}

Result<FileLock> StoreFolder::lock(const char* name) const
{
    AXISCOMP_CHECK(makePrivateFolder(m_path));
    return FileLock::acquire(m_path / name, m_lockWait, m_path);
}

Result<std::optional<FileLock>> StoreFolder::tryLock(const char* name) const
{
    AXISCOMP_CHECK(makePrivateFolder(m_path));
    return FileLock::tryAcquire(m_path / name, m_path);
}

} // namespace axiscomp
