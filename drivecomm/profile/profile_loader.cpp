// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/profile/profile_loader.h"

#include "core/io/local_file.h"
#include "core/io/strict_json.h"
#include "drivecomm/profile/generic_profile.h"
#include "drivecomm/profile/profile_layout.h"
#include "drivecomm/profile/profile_registers.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t maximumProfileSize = std::size_t{1} << 20;
constexpr int deepestNesting = 8;
constexpr std::size_t mostValues = 20'000;
constexpr std::size_t mostSlots = 256;
constexpr std::size_t maximumPathLength = 256;
constexpr std::uint32_t largestSlot = std::uint32_t{1} << 30;
constexpr int mostFlashOperations = 1'000'000;
constexpr std::int64_t longestFlashWindowSeconds = 366 * 86'400;

bool isGraphic(char c)
{
    return c > ' ' && c <= '~';
}

tl::unexpected<Error> invalid(const std::string& file, Argument path, Argument reason)
{
    return fail(ErrorCode::InvalidProfile,
        {{"file", file}, {"path", std::move(path)}, {"reason", std::move(reason)}});
}

/// The name of a file on the drive: it goes into URLs and into lines of the serial link.
std::string readFileName(const JsonNode& node)
{
    std::string name = node.text();
    const auto isAllowed = [](char c) {
        return isGraphic(c) && std::string_view("\"\\%?#&*:<>|").find(c) == std::string_view::npos;
    };
    if (name.empty() || name.size() > maximumPathLength || !std::ranges::all_of(name, isAllowed))
        node.refuse(AXISCOMP_TEXT("Error", "a file path such as tables/small1.TAMtbl is expected"));
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string_view part = std::string_view(name).substr(begin, end - begin);
        if (part.empty() || part == "." || part == "..")
            node.refuse(AXISCOMP_TEXT("Error",
                "a file path has a name between its slashes, none at its ends, and no \".\" or "
                "\"..\""));
        begin = end + 1;
    }
    return name;
}

std::vector<TableSlot> readSlots(const JsonNode& node, const DriveProfile& profile)
{
    std::vector<TableSlot> slots;
    for (const JsonNode& item : node.items()) {
        if (slots.size() == mostSlots) {
            item.refuse(
                AXISCOMP_TEXT("Error", "there are more than {most} slots").with("most", mostSlots));
            break;
        }
        item.expectMembers({"name", "file", "maximumSize"});
        // the smallest table: a header and two values
        const std::uint32_t smallest =
            std::min(profile.layout.headerSize, largestSlot) + 2 * sizeof(float);
        TableSlot slot{readWord(item["name"]), readFileName(item["file"]),
            item["maximumSize"].integer<std::uint32_t>(smallest, largestSlot)};
        if (slot.name == profile.enums.tableDisabled)
            item["name"].refuse(AXISCOMP_TEXT(
                "Error", "this is the value that stands for no table, enums.tableDisabled"));
        if (std::ranges::find(slots, slot.name, &TableSlot::name) != slots.end())
            item["name"].refuse(
                AXISCOMP_TEXT("Error", "another slot has the name {name}").with("name", slot.name));
        if (std::ranges::find(slots, slot.file, &TableSlot::file) != slots.end())
            item["file"].refuse(
                AXISCOMP_TEXT("Error", "another slot has the file {file}").with("file", slot.file));
        slots.push_back(std::move(slot));
    }
    if (slots.empty())
        node.refuse(AXISCOMP_TEXT("Error", "at least one slot is needed"));
    return slots;
}

enum class UrlPathEnd { Slash, NoSlash };

std::string readUrlPath(const JsonNode& node, UrlPathEnd end)
{
    std::string path = node.text();
    const auto isAllowed = [](char c) {
        return isGraphic(c) && std::string_view("\"\\%?#<>{}").find(c) == std::string_view::npos;
    };
    if (path.size() > maximumPathLength || !path.starts_with('/') || path.find("//") != path.npos
        || !std::ranges::all_of(path, isAllowed))
        node.refuse(
            AXISCOMP_TEXT("Error", "the path of a web page is expected, such as /directory"));
    if (end == UrlPathEnd::Slash && !path.ends_with('/'))
        node.refuse(
            AXISCOMP_TEXT("Error", "a slash is needed at the end, because a file path follows"));
    if (end == UrlPathEnd::NoSlash && path.ends_with('/'))
        node.refuse(AXISCOMP_TEXT("Error", "there must be no slash at the end"));
    return path;
}

WebPaths readWebPaths(const JsonNode& node)
{
    node.expectMembers(
        {"directory", "transfer", "files", "registers", "transferPathField", "transferFileField"});
    WebPaths web{readUrlPath(node["directory"], UrlPathEnd::NoSlash),
        readUrlPath(node["transfer"], UrlPathEnd::NoSlash),
        readUrlPath(node["files"], UrlPathEnd::Slash),
        readUrlPath(node["registers"], UrlPathEnd::NoSlash), readWord(node["transferPathField"]),
        readWord(node["transferFileField"])};
    if (web.transfer == web.directory)
        node["transfer"].refuse(AXISCOMP_TEXT("Error", "this is the same page as directory"));
    if (web.registers == web.directory || web.registers == web.transfer)
        node["registers"].refuse(
            AXISCOMP_TEXT("Error", "this is the same page as directory or transfer"));
    if (web.transferFileField == web.transferPathField)
        node["transferFileField"].refuse(
            AXISCOMP_TEXT("Error", "this is the same field as transferPathField"));
    return web;
}

FlashWearLimits readFlashWear(const JsonNode& node)
{
    node.expectMembers({"operations", "windowSeconds", "ratedCycles"});
    FlashWearLimits limits;
    limits.operations = node["operations"].integer<int>(1, mostFlashOperations);
    limits.window = std::chrono::seconds(
        node["windowSeconds"].integer<std::int64_t>(1, longestFlashWindowSeconds));
    limits.ratedCycles = node["ratedCycles"].integer<std::uint32_t>();
    return limits;
}

DriveProfile readProfile(const JsonNode& root)
{
    constexpr std::array<std::string_view, 11> keys{"name", "registers", "enums", "sourceShortlist",
        "sourceTypes", "slots", "layout", "web", "flashWear", "writesAtOneInstant",
        "readsAtOneInstant"};
    constexpr std::array<std::string_view, 3> optionalKeys{
        "description", "positionKinds", "temperatures"};
    root.expectMembers(keys, optionalKeys);
    if (root.has("description"))
        static_cast<void>(root["description"].textView());

    DriveProfile profile;
    profile.name = readWord(root["name"]);
    profile.registers = readRegisterPaths(root["registers"]);
    profile.enums = readRegisterEnums(root["enums"]);
    profile.sourceShortlist = readSourceShortlist(root["sourceShortlist"]);
    if (root.has("positionKinds"))
        profile.positionKinds = readPositionKinds(root["positionKinds"]);
    if (root.has("temperatures"))
        profile.temperatures = readTemperatures(root["temperatures"], profile.positionKinds);
    profile.sourceTypes = readSourceTypes(root["sourceTypes"]);
    profile.layout = readTableLayout(root["layout"]);
    profile.tableSlots = readSlots(root["slots"], profile);
    profile.web = readWebPaths(root["web"]);
    profile.flashWear = readFlashWear(root["flashWear"]);
    profile.writesAtOneInstant = root["writesAtOneInstant"].boolean();
    profile.readsAtOneInstant = root["readsAtOneInstant"].boolean();
    return profile;
}

} // namespace

Result<DriveProfile> parseProfile(std::string_view json, const std::string& fileName)
{
    StrictJson document(json, {maximumProfileSize, deepestNesting, mostValues});
    DriveProfile profile = readProfile(document.root());
    if (const auto& problem = document.problem())
        return invalid(fileName, problem->place, problem->fault);
    if (const auto checked = checkLayout(profile.layout); !checked) {
        const ErrorContext& context = checked.error().context;
        return invalid(fileName, "layout." + context.english("path"), *context.find("reason"));
    }
    return profile;
}

Result<DriveProfile> loadProfile(const std::filesystem::path& file)
{
    return loadFile(file, maximumProfileSize).and_then([&](const Bytes& bytes) {
        return parseProfile(asText(bytes), file.string());
    });
}

const DriveProfile& genericProfile()
{
    static const DriveProfile profile = [] {
        auto parsed = parseProfile(genericProfileJson, "generic");
        if (!parsed)
            std::abort(); // the file is part of the build, and tst_profileloader reads it
        return *std::move(parsed);
    }();
    return profile;
}

} // namespace axiscomp::drivecomm
