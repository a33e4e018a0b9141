// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/table_formats.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace axiscomp::app {

namespace {

constexpr std::array formats{
    TableFormatInfo{.format = TableFormat::Csv,
        .name = "csv",
        .extension = ".csv",
        .severalTables = true,
        .holdsNames = true,
        .holdsUnits = true,
        .holdsNotes = true,
        .holdsPersistency = false,
        .isText = true,
        .numbers = "decimal text",
        .description = "calibration file: reference positions and compensation values"},
    TableFormatInfo{.format = TableFormat::TamTable,
        .name = "tamtbl",
        .extension = ".TAMtbl",
        .severalTables = false,
        .holdsNames = false,
        .holdsUnits = false,
        .holdsNotes = false,
        .holdsPersistency = true,
        .isText = false,
        .numbers = "float32",
        .description = "table file of the drive, laid out as the drive profile says"},
};

bool sameLetters(std::string_view a, std::string_view b)
{
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

std::string knownNames()
{
    std::string names;
    for (const TableFormatInfo& info : formats)
        names += (names.empty() ? "" : ", ") + std::string(info.name);
    return names;
}

} // namespace

std::span<const TableFormatInfo> tableFormats()
{
    return formats;
}

const TableFormatInfo& formatInfo(TableFormat format)
{
    return *std::ranges::find(formats, format, &TableFormatInfo::format);
}

Result<TableFormat> chooseFormat(const std::string& file, const std::string& name)
{
    const std::string extension = std::filesystem::path(file).extension().string();
    for (const TableFormatInfo& info : formats) {
        if (name.empty() ? sameLetters(extension, info.extension) : sameLetters(name, info.name))
            return info.format;
    }
    return fail(ErrorCode::UnknownFormat,
        {{"file", name.empty() ? file : file + " (" + name + ")"}, {"known", knownNames()}});
}

} // namespace axiscomp::app
