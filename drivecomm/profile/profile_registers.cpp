// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/profile/profile_registers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t maximumPatternLength = 256;
constexpr std::size_t longestWord = 64;
constexpr std::size_t longestShortlist = 1024;
constexpr int mostNameWords = 64;

struct PathKey {
    std::string_view key;
    std::string RegisterPaths::*member;
    std::string_view placeholders; ///< all of them, each one exactly once
    bool isOptional = false;
};

constexpr std::array pathKeys{
    PathKey{"deviceName", &RegisterPaths::deviceName, "{n}"},
    PathKey{"serialNumber", &RegisterPaths::serialNumber, ""},
    PathKey{"driveError", &RegisterPaths::driveError, ""},
    PathKey{"saveParameters", &RegisterPaths::saveParameters, ""},
    PathKey{"reboot", &RegisterPaths::reboot, ""},
    PathKey{"axisName", &RegisterPaths::axisName, "{axis}{n}"},
    PathKey{"positionUnit", &RegisterPaths::positionUnit, "{axis}"},
    PathKey{"positionMinimum", &RegisterPaths::positionMinimum, "{axis}", true},
    PathKey{"positionMaximum", &RegisterPaths::positionMaximum, "{axis}", true},
    PathKey{"table", &RegisterPaths::table, "{axis}"},
    PathKey{"source", &RegisterPaths::source, "{axis}{n}"},
    PathKey{"coggingTable", &RegisterPaths::coggingTable, "{axis}"},
    PathKey{"activation", &RegisterPaths::activation, "{axis}"},
    PathKey{"state", &RegisterPaths::state, "{axis}"},
    PathKey{"error", &RegisterPaths::error, "{axis}"},
    PathKey{"output", &RegisterPaths::output, "{axis}"},
    PathKey{"index", &RegisterPaths::index, "{axis}{n}"},
    PathKey{"homingState", &RegisterPaths::homingState, "{axis}"},
    PathKey{"tablePersistent", &RegisterPaths::tablePersistent, "{slot}"},
    PathKey{"tableDimensions", &RegisterPaths::tableDimensions, "{slot}"},
    PathKey{"tableSize", &RegisterPaths::tableSize, "{slot}{n}"},
    PathKey{"tableStart", &RegisterPaths::tableStart, "{slot}{n}"},
    PathKey{"tableDistance", &RegisterPaths::tableDistance, "{slot}{n}"},
    PathKey{"tableElements", &RegisterPaths::tableElements, "{slot}"},
    PathKey{"tableCrc", &RegisterPaths::tableCrc, "{slot}"},
    PathKey{"tableCommand", &RegisterPaths::tableCommand, "{slot}"},
    PathKey{"tableEraseCount", &RegisterPaths::tableEraseCount, "{slot}"},
};

struct WordCountKey {
    std::string_view key;
    int RegisterPaths::*member;
};

constexpr std::array wordCountKeys{
    WordCountKey{"deviceNameWords", &RegisterPaths::deviceNameWords},
    WordCountKey{"axisNameWords", &RegisterPaths::axisNameWords},
};

struct EnumKey {
    std::string_view key;
    std::string RegisterEnums::*member;
    std::string_view registerKey; ///< values of one register differ from each other
    bool isOptional = false;
};

constexpr std::array enumKeys{
    EnumKey{"tableDisabled", &RegisterEnums::tableDisabled, "table"},
    EnumKey{"activationDisabled", &RegisterEnums::activationDisabled, "activation"},
    EnumKey{"activationEvaluate", &RegisterEnums::activationEvaluate, "activation"},
    EnumKey{"activationAddToEncoders", &RegisterEnums::activationAddToEncoders, "activation"},
    EnumKey{"stateDisabled", &RegisterEnums::stateDisabled, "state"},
    EnumKey{"stateEvaluating", &RegisterEnums::stateEvaluating, "state"},
    EnumKey{"stateRamping", &RegisterEnums::stateRamping, "state"},
    EnumKey{"stateActive", &RegisterEnums::stateActive, "state"},
    EnumKey{"stateError", &RegisterEnums::stateError, "state"},
    EnumKey{"errorNone", &RegisterEnums::errorNone, "error"},
    EnumKey{"errorNotHomed", &RegisterEnums::errorNotHomed, "error", true},
    EnumKey{"errorNoTable", &RegisterEnums::errorNoTable, "error", true},
    EnumKey{"errorDimensionMismatch", &RegisterEnums::errorDimensionMismatch, "error", true},
    EnumKey{"errorBadSource", &RegisterEnums::errorBadSource, "error", true},
    EnumKey{"errorBadTable", &RegisterEnums::errorBadTable, "error", true},
    EnumKey{"homingDone", &RegisterEnums::homingDone, "homingState"},
    EnumKey{"saveParametersSave", &RegisterEnums::saveParametersSave, "saveParameters"},
    EnumKey{"rebootReboot", &RegisterEnums::rebootReboot, "reboot"},
    EnumKey{"tableCommandCommit", &RegisterEnums::tableCommandCommit, "tableCommand"},
    EnumKey{"tableCommandDelete", &RegisterEnums::tableCommandDelete, "tableCommand"},
    EnumKey{"driveErrorNone", &RegisterEnums::driveErrorNone, "driveError"},
    EnumKey{"driveErrorFlashWear", &RegisterEnums::driveErrorFlashWear, "driveError"},
};

constexpr std::array<std::string_view, 3> knownPlaceholders{"{axis}", "{slot}", "{n}"};
constexpr std::array<std::string_view, 4> numericTypes{"Int32", "UInt32", "Single", "Double"};

bool isWordCharacter(char c)
{
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'
        || c == '-';
}

std::size_t occurrences(std::string_view text, std::string_view part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

/// What is wrong with a pattern beside its placeholders, empty when nothing is.
Text shapeFault(std::string_view pattern)
{
    if (pattern.empty())
        return AXISCOMP_TEXT("Error", "it is empty; a register path is expected");
    if (pattern.size() > maximumPatternLength)
        return AXISCOMP_TEXT("Error", "it has {count} characters, at most {most} are possible")
            .with("count", pattern.size())
            .with("most", maximumPatternLength);
    if (pattern.front() == '/' || pattern.back() == '/' || pattern.find("//") != pattern.npos)
        return AXISCOMP_TEXT(
            "Error", "a path has one slash between its parts and none at its ends");
    const auto other = std::ranges::find_if_not(pattern, [](char c) {
        return isWordCharacter(c) || std::string_view("/[]{}").find(c) != std::string_view::npos;
    });
    if (other != pattern.end())
        return AXISCOMP_TEXT("Error",
            "a path is made of letters, digits, '_', '-', '/', '[' and ']'; the character at "
            "position {position} is none of them")
            .with("position", other - pattern.begin() + 1);
    return {};
}

/// required: placeholders, one after the other, each of which is there exactly once.
Text placeholderFault(std::string_view pattern, std::string_view required)
{
    std::size_t known = 0;
    for (const std::string_view placeholder : knownPlaceholders) {
        const std::size_t found = occurrences(pattern, placeholder);
        const bool isRequired = required.find(placeholder) != required.npos;
        if (isRequired && found != 1)
            return (found == 0
                    ? AXISCOMP_TEXT("Error", "the placeholder {name} is missing")
                    : AXISCOMP_TEXT("Error", "the placeholder {name} is there more than once"))
                .with("name", placeholder);
        if (!isRequired && found > 0)
            return AXISCOMP_TEXT("Error", "the placeholder {name} has no meaning here")
                .with("name", placeholder);
        known += found;
    }
    if (occurrences(pattern, "{") != known || occurrences(pattern, "}") != known)
        return AXISCOMP_TEXT("Error", "in braces there can only be a placeholder, one of {known}")
            .with("known",
                std::vector<std::string>(knownPlaceholders.begin(), knownPlaceholders.end()));
    return {};
}

std::string readPattern(const JsonNode& node, std::string_view required)
{
    std::string pattern = node.text();
    for (const Text& fault : {shapeFault(pattern), placeholderFault(pattern, required)}) {
        if (!fault.isEmpty()) {
            node.refuse(fault);
            break;
        }
    }
    return pattern;
}

struct Range {
    std::string before, after; ///< including the brackets
    int first = 0;
    int last = 0;
};

/// The range "[first..last]" of a shortlist entry; none, or a fault in words.
std::optional<Range> findRange(std::string_view entry, Text& fault)
{
    const std::size_t dots = entry.find("..");
    if (dots == entry.npos)
        return std::nullopt;
    const std::size_t open = entry.rfind('[', dots);
    const std::size_t close = entry.find(']', dots);
    if (open == entry.npos || close == entry.npos) {
        fault = AXISCOMP_TEXT("Error", "a range is written in brackets, such as [0..15]");
        return std::nullopt;
    }
    Range range{std::string(entry.substr(0, open + 1)), std::string(entry.substr(close)), 0, -1};
    const char* const begin = entry.data();
    const auto first = std::from_chars(begin + open + 1, begin + dots, range.first);
    const auto last = std::from_chars(begin + dots + 2, begin + close, range.last);
    if (first.ptr != begin + dots || last.ptr != begin + close || first.ec != std::errc{}
        || last.ec != std::errc{} || range.first < 0 || range.last < range.first)
        fault = AXISCOMP_TEXT(
            "Error", "a range goes from a whole number up to another one, such as [0..15]");
    return range;
}

/// What is wrong with an entry without ranges, empty when nothing is.
Text entryFault(const std::string& entry, const std::vector<std::string>& list)
{
    if (Text fault = shapeFault(entry); !fault.isEmpty())
        return fault;
    const bool hasAxis = entry.find("{axis}") != std::string::npos;
    if (Text fault = placeholderFault(entry, hasAxis ? "{axis}" : ""); !fault.isEmpty())
        return fault;
    if (std::ranges::find(list, entry) != list.end())
        return AXISCOMP_TEXT("Error", "the register {path} is there twice").with("path", entry);
    if (list.size() == longestShortlist)
        return AXISCOMP_TEXT("Error", "the shortlist has more than {most} registers")
            .with("most", longestShortlist);
    return {};
}

/// Adds one entry with its ranges written out, from left to right. Ends at the first fault, so that
/// a huge range costs nothing.
bool appendExpanded(const JsonNode& node, const std::string& entry, std::vector<std::string>& list)
{
    Text fault;
    const auto range = findRange(entry, fault);
    if (fault.isEmpty() && !range)
        fault = entryFault(entry, list);
    if (!fault.isEmpty()) {
        node.refuse(fault);
        return false;
    }
    if (!range) {
        list.push_back(entry);
        return true;
    }
    for (int i = range->first; i < range->last; ++i) {
        if (!appendExpanded(node, range->before + std::to_string(i) + range->after, list))
            return false;
    }
    return appendExpanded(node, range->before + std::to_string(range->last) + range->after, list);
}

/// A register that is in a list before this one would be both, and the first list would decide.
void refuseShared(const JsonNode& node, const std::vector<std::string>& list,
    const std::vector<std::string>& before, std::string_view nameOfBefore)
{
    for (const std::string& path : list)
        if (std::ranges::find(before, path) != before.end())
            node.refuse(AXISCOMP_TEXT("Error", "the register {path} is in {name} too")
                            .with("path", path)
                            .with("name", nameOfBefore));
}

} // namespace

std::string readWord(const JsonNode& node)
{
    std::string word = node.text();
    if (word.empty() || word.size() > longestWord || !std::ranges::all_of(word, isWordCharacter))
        node.refuse(
            AXISCOMP_TEXT("Error", "a word of 1 to {most} letters, digits, '_' or '-' is expected")
                .with("most", longestWord));
    return word;
}

RegisterPaths readRegisterPaths(const JsonNode& node)
{
    std::vector<std::string_view> keys;
    std::vector<std::string_view> optional;
    for (const PathKey& row : pathKeys)
        (row.isOptional ? optional : keys).push_back(row.key);
    for (const WordCountKey& row : wordCountKeys)
        keys.push_back(row.key);
    node.expectMembers(keys, optional);

    RegisterPaths paths;
    std::map<std::string, std::string_view> usedBy;
    for (const PathKey& row : pathKeys) {
        if (row.isOptional && !node.has(row.key))
            continue;
        const JsonNode place = node[row.key];
        paths.*row.member = readPattern(place, row.placeholders);
        const auto [used, isNew] = usedBy.emplace(paths.*row.member, row.key);
        if (!isNew)
            place.refuse(AXISCOMP_TEXT("Error", "this is the same register as {name}")
                             .with("name", used->second));
    }
    for (const WordCountKey& row : wordCountKeys)
        paths.*row.member = node[row.key].integer<int>(1, mostNameWords);
    return paths;
}

RegisterEnums readRegisterEnums(const JsonNode& node)
{
    std::vector<std::string_view> keys;
    std::vector<std::string_view> optional;
    for (const EnumKey& row : enumKeys)
        (row.isOptional ? optional : keys).push_back(row.key);
    node.expectMembers(keys, optional);

    RegisterEnums enums;
    std::map<std::pair<std::string_view, std::string>, std::string_view> usedBy;
    for (const EnumKey& row : enumKeys) {
        if (row.isOptional && !node.has(row.key))
            continue;
        const JsonNode place = node[row.key];
        enums.*row.member = readWord(place);
        const auto [used, isNew] =
            usedBy.emplace(std::pair(row.registerKey, enums.*row.member), row.key);
        if (!isNew)
            place.refuse(AXISCOMP_TEXT("Error", "this is the same value as {name}")
                             .with("name", used->second));
    }
    return enums;
}

std::vector<std::string> readSourceShortlist(const JsonNode& node)
{
    std::vector<std::string> list;
    for (const JsonNode& item : node.items()) {
        const std::string entry = item.text();
        if (entry.size() > maximumPatternLength)
            item.refuse(shapeFault(entry));
        else
            static_cast<void>(appendExpanded(item, entry, list));
    }
    return list;
}

PositionKinds readPositionKinds(const JsonNode& node)
{
    node.expectMembers({"beforeCompensation", "afterCompensation", "commanded"});
    const auto paths = [&node](const char* kind) {
        for (const JsonNode& item : node[kind].items())
            if (item.text().find("{axis}") == std::string::npos)
                item.refuse(AXISCOMP_TEXT("Error", "{placeholder} is expected in the path")
                                .with("placeholder", Verbatim{"{axis}"}));
        return readSourceShortlist(node[kind]);
    };
    PositionKinds kinds{
        paths("beforeCompensation"), paths("afterCompensation"), paths("commanded")};
    refuseShared(node["afterCompensation"], kinds.after, kinds.before, "beforeCompensation");
    refuseShared(node["commanded"], kinds.commanded, kinds.before, "beforeCompensation");
    refuseShared(node["commanded"], kinds.commanded, kinds.after, "afterCompensation");
    return kinds;
}

std::vector<std::string> readTemperatures(const JsonNode& node, const PositionKinds& positions)
{
    std::vector<std::string> temperatures = readSourceShortlist(node);
    DriveProfile withPositions;
    withPositions.positionKinds = positions;
    for (const std::string& path : temperatures)
        if (withPositions.axisOfPosition(expandPath(path, {.axis = 0})))
            node.refuse(AXISCOMP_TEXT("Error", "the register {path} is in {name} too")
                            .with("path", path)
                            .with("name", std::string_view("positionKinds")));
    return temperatures;
}

std::vector<std::string> readSourceTypes(const JsonNode& node)
{
    std::vector<std::string> types;
    for (const JsonNode& item : node.items()) {
        std::string type = item.text();
        if (std::ranges::find(numericTypes, type) == numericTypes.end())
            item.refuse(AXISCOMP_TEXT(
                "Error", "a numeric type is expected: Int32, UInt32, Single or Double"));
        else if (std::ranges::find(types, type) != types.end())
            item.refuse(
                AXISCOMP_TEXT("Error", "the type {type} is there twice").with("type", type));
        types.push_back(std::move(type));
    }
    if (types.empty())
        node.refuse(AXISCOMP_TEXT("Error", "at least one type is needed"));
    return types;
}

} // namespace axiscomp::drivecomm
