// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/web/directory_listing.h"

#include "drivecomm/codec/json_parsing.h"
#include "drivecomm/web/html_table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t maximumFiles = 1000;

bool isDecimal(char c)
{
    return c >= '0' && c <= '9';
}

/// Removes a blank or another mark between groups of three digits; 0 when none is there.
std::size_t separatorLength(std::string_view text)
{
    constexpr std::array<std::string_view, 8> separators{
        " ", "'", ",", ".", "\u00A0", "\u2009", "\u202F", "\u2019"};
    const auto found = std::ranges::find_if(
        separators, [text](std::string_view each) { return text.starts_with(each); });
    return found == separators.end() ? 0 : found->size();
}

/// "63360", "63 360", "63'360 bytes"
std::optional<std::uint32_t> byteCount(std::string_view text)
{
    std::string digits;
    std::size_t group = 0;
    bool grouped = false;
    while (!text.empty()) {
        if (isDecimal(text.front())) {
            digits += text.front();
            text.remove_prefix(1);
            ++group;
            continue;
        }
        const std::size_t separator = separatorLength(text);
        if (separator == 0 || text.size() == separator || !isDecimal(text[separator]))
            break;
        if (group == 0 || group > 3 || (grouped && group != 3))
            return std::nullopt;
        grouped = true;
        group = 0;
        text.remove_prefix(separator);
    }
    if (digits.empty() || (grouped && group != 3))
        return std::nullopt;
    while (text.starts_with(' '))
        text.remove_prefix(1);
    if (!text.empty() && text != "B" && text != "byte" && text != "bytes" && text != "Bytes")
        return std::nullopt;
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() ? std::optional(value)
                                                                        : std::nullopt;
}

bool isFilePath(std::string_view text)
{
    return !text.empty() && text.size() <= 255
        && std::ranges::all_of(text, [](char c) { return c > ' ' && c < '\x7f'; });
}

/// What is wrong with the rows taken together.
std::optional<Text> fault(const std::vector<DriveFile>& files)
{
    if (files.size() > maximumFiles)
        return AXISCOMP_TEXT("Error", "at most {count} files").with("count", maximumFiles);
    std::set<std::string_view> paths;
    for (const DriveFile& file : files) {
        if (!isFilePath(file.path))
            return AXISCOMP_TEXT("Error", "file paths without blanks");
        if (file.size > file.maximumSize)
            return AXISCOMP_TEXT("Error", "an actual size of {path} up to its maximum size")
                .with("path", file.path);
        if (!paths.insert(file.path).second)
            return AXISCOMP_TEXT("Error", "the file {path} once").with("path", file.path);
    }
    return std::nullopt;
}

struct Columns {
    std::size_t file;
    std::size_t size;
    std::size_t maximumSize;
};

std::optional<Columns> columnsOf(const HtmlRow& row)
{
    std::optional<std::size_t> file, size, maximumSize;
    for (std::size_t i = 0; i < row.size(); ++i) {
        std::string heading = row[i];
        std::ranges::transform(heading, heading.begin(),
            [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        std::optional<std::size_t>* column = nullptr;
        if (heading.starts_with("max"))
            column = &maximumSize;
        else if (heading.starts_with("actual"))
            column = &size;
        else if (heading.starts_with("file"))
            column = &file;
        if (!column)
            continue;
        if (column->has_value())
            return std::nullopt;
        *column = i;
    }
    if (!file || !size || !maximumSize)
        return std::nullopt;
    return Columns{*file, *size, *maximumSize};
}

std::string joined(const HtmlRow& row)
{
    std::string text;
    for (const std::string& cell : row)
        text += (text.empty() ? "" : " | ") + cell;
    return text;
}

Result<std::vector<DriveFile>> filesOf(
    const HtmlTable& table, std::size_t firstRow, Columns columns)
{
    std::vector<DriveFile> files;
    for (std::size_t i = firstRow; i < table.size(); ++i) {
        const HtmlRow& row = table[i];
        if (row.size() <= std::max({columns.file, columns.size, columns.maximumSize}))
            return notExpected(
                AXISCOMP_TEXT("Error", "a file, its size and its maximum size in each row"),
                joined(row));
        const auto size = byteCount(row[columns.size]);
        const auto maximumSize = byteCount(row[columns.maximumSize]);
        if (!size || !maximumSize)
            return notExpected(AXISCOMP_TEXT("Error", "sizes in bytes"), joined(row));
        files.push_back({row[columns.file], *size, *maximumSize});
    }
    return files;
}

std::optional<DriveFile> fileOf(const nlohmann::json& json)
{
    if (!json.is_object())
        return std::nullopt;
    const auto path = json.find("path");
    const auto number = [&json](const char* key) -> std::optional<std::uint32_t> {
        const auto place = json.find(key);
        if (place == json.end() || !place->is_number_unsigned()
            || !std::in_range<std::uint32_t>(place->get<std::uint64_t>()))
            return std::nullopt;
        return place->get<std::uint32_t>();
    };
    const auto size = number("size");
    const auto maximumSize = number("maximumSize");
    if (path == json.end() || !path->is_string() || !size || !maximumSize)
        return std::nullopt;
    return DriveFile{path->get<std::string>(), *size, *maximumSize};
}

} // namespace

std::string directoryJson(std::span<const DriveFile> files)
{
    std::string json = "[";
    for (const DriveFile& file : files) {
        json += json.size() == 1 ? "\n" : ",\n";
        json += "{\"path\":" + jsonString(file.path) + ",\"size\":" + std::to_string(file.size)
            + ",\"maximumSize\":" + std::to_string(file.maximumSize) + "}";
    }
    return json + "\n]\n";
}

Result<std::vector<DriveFile>> parseDirectoryJson(std::string_view json)
{
    const nlohmann::json document = parseJson(json);
    if (!document.is_array())
        return notExpected(AXISCOMP_TEXT("Error", "a JSON array of files"), json);
    std::vector<DriveFile> files;
    for (const nlohmann::json& each : document) {
        auto file = fileOf(each);
        if (!file)
            return notExpected(AXISCOMP_TEXT("Error", "a file with path, size and maximumSize"),
                each.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
        files.push_back(std::move(*file));
    }
    if (auto expected = fault(files))
        return notExpected(std::move(*expected), json);
    return files;
}

Result<std::vector<DriveFile>> parseDirectoryPage(std::string_view html)
{
    for (const HtmlTable& table : htmlTables(html)) {
        for (std::size_t row = 0; row < table.size(); ++row) {
            const auto columns = columnsOf(table[row]);
            if (!columns)
                continue;
            auto files = filesOf(table, row + 1, *columns);
            if (!files)
                return files;
            if (auto expected = fault(*files))
                return notExpected(std::move(*expected), htmlText(html));
            if (files->empty())
                return notExpected(
                    AXISCOMP_TEXT("Error", "at least one file in the table"), htmlText(html));
            return files;
        }
    }
    return notExpected(AXISCOMP_TEXT("Error",
                           "a Directory page with a table of File, actual size and maximum size"),
        htmlText(html));
}

} // namespace axiscomp::drivecomm
