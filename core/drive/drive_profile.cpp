// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/drive_profile.h"

#include "core/text/utf8.h"

#include <algorithm>
#include <charconv>
#include <span>

namespace axiscomp {

namespace {

constexpr std::size_t bytesPerWord = 4;

std::optional<std::string> argument(std::string_view name, const PathArguments& arguments)
{
    if (name == "axis" && arguments.axis)
        return std::to_string(*arguments.axis);
    if (name == "n" && arguments.n)
        return std::to_string(*arguments.n);
    if (name == "slot" && !arguments.slot.empty())
        return std::string(arguments.slot);
    return std::nullopt;
}

} // namespace

const TableSlot* DriveProfile::slotNamed(std::string_view slotName) const
{
    const auto slot = std::ranges::find(tableSlots, slotName, &TableSlot::name);
    return slot == tableSlots.end() ? nullptr : &*slot;
}

const TableSlot* DriveProfile::slotOfFile(std::string_view file) const
{
    const auto slot = std::ranges::find(tableSlots, file, &TableSlot::file);
    return slot == tableSlots.end() ? nullptr : &*slot;
}

std::size_t DriveProfile::mostPoints() const
{
    std::size_t largest = 0;
    for (const TableSlot& slot : tableSlots)
        largest = std::max<std::size_t>(largest, slot.maximumSize);
    const std::size_t header = layout.headerSize;
    return largest > header ? (largest - header) / sizeof(float) : 0;
}

namespace {

/// The axis in a path of one of the patterns.
std::optional<int> axisIn(std::string_view path, std::span<const std::string> patterns)
{
    constexpr std::string_view placeholder = "{axis}";
    for (const std::string_view pattern : patterns) {
        const std::size_t place = pattern.find(placeholder);
        if (place == std::string_view::npos || !path.starts_with(pattern.substr(0, place)))
            continue;
        const std::string_view rest = path.substr(place);
        int axis = 0;
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), axis);
        const auto length = static_cast<std::size_t>(end - rest.data());
        if (error == std::errc{} && axis >= 0
            && rest.substr(length) == pattern.substr(place + placeholder.size()))
            return axis;
    }
    return std::nullopt;
}

} // namespace

bool DriveProfile::isBeforeCompensation(std::string_view path) const
{
    return axisIn(path, positionKinds.before).has_value();
}

bool DriveProfile::isAfterCompensation(std::string_view path) const
{
    return axisIn(path, positionKinds.after).has_value();
}

std::optional<int> DriveProfile::axisOfPosition(std::string_view path) const
{
    for (const auto* const patterns :
        {&positionKinds.before, &positionKinds.after, &positionKinds.commanded})
        if (const auto axis = axisIn(path, *patterns))
            return axis;
    return std::nullopt;
}

bool DriveProfile::isTemperature(std::string_view path) const
{
    return std::ranges::find(temperatures, path) != temperatures.end()
        || axisIn(path, temperatures).has_value();
}

std::string expandPath(std::string_view pattern, const PathArguments& arguments)
{
    std::string result;
    while (!pattern.empty()) {
        const std::size_t open = pattern.find('{');
        const std::size_t close = pattern.find('}', open);
        if (open == std::string_view::npos || close == std::string_view::npos)
            return result.append(pattern);
        result.append(pattern.substr(0, open));
        const auto value = argument(pattern.substr(open + 1, close - open - 1), arguments);
        if (value)
            result.append(*value);
        else
            result.append(pattern.substr(open, close - open + 1));
        pattern.remove_prefix(close + 1);
    }
    return result;
}

std::vector<std::string> axisRegisterPaths(const DriveProfile& profile, int axis)
{
    constexpr int mostSources = 3;
    const RegisterPaths& names = profile.registers;
    std::vector<std::string> paths{expandPath(names.table, {.axis = axis, .slot = {}, .n = {}})};
    for (int n = 1; n <= mostSources; ++n)
        paths.push_back(expandPath(names.source, {.axis = axis, .slot = {}, .n = n}));
    return paths;
}

std::string unpackName(const std::vector<std::int32_t>& words)
{
    std::string packed;
    packed.reserve(words.size() * bytesPerWord);
    for (const std::int32_t word : words) {
        const auto bits = static_cast<std::uint32_t>(word);
        for (std::size_t byte = 0; byte < bytesPerWord; ++byte)
            packed.push_back(static_cast<char>(bits >> (8 * byte) & 0xFFU));
    }
    return shownText(packed);
}

std::vector<std::int32_t> packName(std::string_view name, int words)
{
    const std::size_t wordCount = static_cast<std::size_t>(std::max(words, 0));
    const std::string_view kept = cutAtCharacter(name, wordCount * bytesPerWord);
    std::vector<std::uint32_t> packed(wordCount);
    for (std::size_t i = 0; i < kept.size(); ++i)
        packed[i / bytesPerWord] |= static_cast<std::uint32_t>(static_cast<unsigned char>(kept[i]))
            << (8 * (i % bytesPerWord));
    std::vector<std::int32_t> result(wordCount);
    std::ranges::transform(
        packed, result.begin(), [](std::uint32_t word) { return static_cast<std::int32_t>(word); });
    return result;
}

} // namespace axiscomp
