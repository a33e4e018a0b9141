// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/backup.h"

#include "core/base/bytes.h"
#include "core/store/backup_json.h"

#include <array>
#include <limits>
#include <set>
#include <utility>

namespace axiscomp {

namespace {

constexpr std::string_view format = "axiscomp-backup";
constexpr std::array<std::string_view, 4> members{"format", "version", "axes", "otherFiles"};
constexpr std::array<std::string_view, 1> extras{"drive"};
constexpr std::array<std::string_view, 6> axisMembers{
    "drive", "axis", "axisName", "time", "registers", "files"};
constexpr std::array<std::string_view, 5> axisExtras{
    "unit", "sourceUnits", "sourcePaths", "profile", "layout"};
constexpr JsonLimits backupLimits{.size = maximumBackupSize, .depth = 8, .values = 100'000};

OrderedJson toJson(const DriveIdentity& drive)
{
    return {{"name", drive.name}, {"serialNumber", drive.serialNumber}, {"axes", drive.axes}};
}

OrderedJson toJson(const AxisBackup::File& file)
{
    return {{"slot", file.slot}, {"path", file.path}, {"persistent", file.persistent},
        {"crc32", crcText(crc32(file.bytes))}, {"bytes", toBase64(file.bytes)}};
}

OrderedJson toJson(const std::vector<AxisBackup::File>& files)
{
    OrderedJson list = OrderedJson::array();
    for (const AxisBackup::File& file : files)
        list.push_back(toJson(file));
    return list;
}

OrderedJson toJson(const AxisBackup& backup)
{
    OrderedJson document{{"drive", toJson(backup.drive)}, {"axis", backup.axis},
        {"axisName", backup.axisName}, {"time", utcText(backup.time)},
        {"registers", toJson(backup.registers)}, {"files", toJson(backup.files)}};
    if (!backup.unit.empty())
        document["unit"] = backup.unit;
    if (!backup.sourceUnits.empty())
        document["sourceUnits"] = backup.sourceUnits;
    if (!backup.sourcePaths.empty())
        document["sourcePaths"] = backup.sourcePaths;
    if (!backup.profile.empty())
        document["profile"] = backup.profile;
    if (!backup.layout.empty())
        document["layout"] = backup.layout;
    return document;
}

DriveIdentity driveFromJson(const JsonNode& node)
{
    node.expectMembers({"name", "serialNumber", "axes"});
    return {node["name"].text(), node["serialNumber"].integer<std::int32_t>(),
        node["axes"].integer<int>(0)};
}

AxisBackup::File fileFromJson(const JsonNode& node)
{
    node.expectMembers({"slot", "path", "persistent", "crc32", "bytes"});
    AxisBackup::File file{
        node["slot"].text(), node["path"].text(), {}, node["persistent"].boolean()};
    if (auto bytes = fromBase64(node["bytes"].textView()))
        file.bytes = std::move(*bytes);
    else
        node["bytes"].refuse(AXISCOMP_TEXT("Error", "this is not base64"));
    const std::uint32_t crc = crc32(file.bytes);
    if (crcFromJson(node["crc32"]) != crc)
        node["crc32"].refuse(
            AXISCOMP_TEXT("Error", "the bytes have the CRC-32 {crc}, so they are damaged")
                .with("crc", crcText(crc)));
    return file;
}

std::vector<AxisBackup::File> filesFromJson(const JsonNode& node)
{
    std::vector<AxisBackup::File> files;
    std::set<std::pair<std::string, std::string>> places;
    for (const JsonNode& item : node.items()) {
        files.push_back(fileFromJson(item));
        if (!places.emplace(files.back().slot, files.back().path).second)
            item["path"].refuse(AXISCOMP_TEXT("Error", "this file is there twice"));
    }
    return files;
}

AxisBackup axisFromJson(const JsonNode& node)
{
    node.expectMembers(axisMembers, axisExtras);
    AxisBackup backup{driveFromJson(node["drive"]), node["axis"].integer<int>(0),
        node["axisName"].text(), timeFromJson(node["time"]), registersFromJson(node["registers"]),
        filesFromJson(node["files"])};
    if (node.has("unit"))
        backup.unit = node["unit"].text();
    if (node.has("sourceUnits"))
        for (const JsonNode& unit : node["sourceUnits"].items())
            backup.sourceUnits.push_back(unit.text());
    if (node.has("sourcePaths"))
        for (const JsonNode& path : node["sourcePaths"].items())
            backup.sourcePaths.push_back(path.text());
    if (node.has("profile"))
        backup.profile = node["profile"].text();
    if (node.has("layout"))
        backup.layout = node["layout"].text();
    return backup;
}

DriveBackup backupFromJson(const JsonNode& root)
{
    DriveBackup backup;
    expectFormat(root, format);
    root.expectMembers(members, extras);
    if (root.has("drive"))
        backup.drive = driveFromJson(root["drive"]);
    std::set<std::pair<std::int32_t, int>> axes;
    for (const JsonNode& item : root["axes"].items()) {
        backup.axes.push_back(axisFromJson(item));
        const AxisBackup& axis = backup.axes.back();
        if (!axes.emplace(axis.drive.serialNumber, axis.axis).second)
            item["axis"].refuse(AXISCOMP_TEXT("Error", "this axis of the drive is there twice"));
    }
    backup.otherFiles = filesFromJson(root["otherFiles"]);
    return backup;
}

} // namespace

std::string writeBackup(const DriveBackup& backup)
{
    OrderedJson document = newDocument(format);
    document["axes"] = OrderedJson::array();
    for (const AxisBackup& axis : backup.axes)
        document["axes"].push_back(toJson(axis));
    document["otherFiles"] = toJson(backup.otherFiles);
    if (backup.drive)
        document["drive"] = toJson(*backup.drive);
    return jsonText(document);
}

Result<DriveBackup> readBackup(std::string_view text, const std::string& fileName)
{
    StrictJson document{text, backupLimits};
    DriveBackup backup = backupFromJson(document.root());
    if (document.problem())
        return fail(
            ErrorCode::InvalidBackup, {{"file", fileName}, {"reason", document.problem()->reason}});
    return backup;
}

} // namespace axiscomp
