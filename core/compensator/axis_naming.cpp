// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/axis_naming.h"

#include "core/write/write_planner.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

namespace axiscomp {

namespace {

constexpr std::string_view indexPrefix = "index:";

std::optional<int> axisNumbered(std::span<const AxisInfo> axes, std::string_view text)
{
    int index = -1;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, index);
    if (parsed.ec != std::errc{} || parsed.ptr != end
        || std::ranges::find(axes, index, &AxisInfo::index) == axes.end())
        return std::nullopt;
    return index;
}

std::vector<int> axesNamed(std::span<const AxisInfo> axes, std::string_view name)
{
    std::vector<int> found;
    for (const AxisInfo& info : axes)
        if (!name.empty() && info.name == name)
            found.push_back(info.index);
    return found;
}

} // namespace

Result<int> axisAmong(std::span<const AxisInfo> axes, std::string_view asked)
{
    constexpr std::string_view namePrefix = "name:";
    const bool isIndex = asked.starts_with(indexPrefix);
    std::vector<int> named = axesNamed(axes, asked);
    const auto numbered = axisNumbered(axes, isIndex ? asked.substr(indexPrefix.size()) : asked);
    if (named.empty() && !numbered && asked.starts_with(namePrefix))
        named = axesNamed(axes, asked.substr(namePrefix.size()));
    if (named.size() > 1) {
        std::vector<std::string> matches;
        for (const int index : named)
            matches.push_back(axisIndexText(axes, index));
        return fail(ErrorCode::AxisAmbiguous, {{"axis", asked}, {"matches", std::move(matches)}});
    }
    if (!named.empty() && numbered && named.front() != *numbered)
        return fail(ErrorCode::AxisAmbiguous,
            {{"axis", asked}, {"named", named.front()}, {"numbered", *numbered},
                {"index", axisIndexText(axes, *numbered)}});
    if (!named.empty())
        return named.front();
    if (numbered)
        return *numbered;
    std::vector<Text> known;
    for (const AxisInfo& info : axes)
        known.push_back(axisText(info.index, info.name));
    return fail(ErrorCode::AxisNotFound, {{"axis", asked}, {"known", std::move(known)}});
}

std::string axisIndexText(std::span<const AxisInfo> axes, int index)
{
    std::string text = std::to_string(index);
    const bool isAnothers = std::ranges::any_of(
        axes, [&](const AxisInfo& info) { return info.name == text && info.index != index; });
    return isAnothers ? std::string(indexPrefix) + text : text;
}

} // namespace axiscomp
