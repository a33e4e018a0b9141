// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/proposals.h"

#include "core/table/position_unit.h"
#include "core/table/target_axis.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <set>

namespace axiscomp {

namespace {

/// Whether a column of positions has the name of an axis, perhaps with "position".
bool isNamedAfter(const GridAxis& column, std::string_view axis)
{
    const std::string_view header = trimmed(column.name);
    return !axis.empty() && !header.empty()
        && (sameLetters(header, axis) || sameLetters(axisInHeader(header), axis));
}

/// "T", "Temp. 1", "Motor temperature"
bool isCalledTemperature(const GridAxis& column)
{
    constexpr std::array<std::string_view, 4> words{"t", "temp", "temperature", "temperatur"};
    constexpr std::string_view separators = " \t-_.:";
    std::string_view rest = column.name;
    while (true) {
        const std::size_t begin = rest.find_first_not_of(separators);
        if (begin == std::string_view::npos)
            return false;
        rest.remove_prefix(begin);
        const std::size_t end = std::min(rest.find_first_of(separators), rest.size());
        if (std::ranges::any_of(words,
                [&](std::string_view word) { return sameLetters(rest.substr(0, end), word); }))
            return true;
        rest.remove_prefix(end);
    }
}

bool hasTemperatures(const GridAxis& column)
{
    return isTemperatureUnit(column.unit)
        || (isCalledTemperature(column) && !isPositionUnit(column.unit));
}

/// Whether the numbers of a column may be positions of an axis.
bool suits(const GridAxis& column, const AxisInfo& axis)
{
    const std::string unit = unitSymbol(axis.unit);
    return column.unit.empty() || unit.empty() || unitFactor(column.unit, unit).has_value();
}

const AxisInfo* axisOf(std::span<const AxisInfo> axes, int index)
{
    const auto found = std::ranges::find(axes, index, &AxisInfo::index);
    return found == axes.end() ? nullptr : &*found;
}

/// The one axis that a column of positions is named after.
const AxisInfo* axisNamedIn(const GridAxis& column, std::span<const AxisInfo> axes)
{
    const AxisInfo* named = nullptr;
    for (const AxisInfo& axis : axes) {
        if (!isNamedAfter(column, trimmed(axis.name)))
            continue;
        if (named)
            return nullptr;
        named = &axis;
    }
    return named;
}

DimSource temperatureSource(const DriveRegisters& drive, int axis)
{
    const AxisInfo* own = axisOf(drive.axes, axis);
    std::vector<DimSource> others;
    for (const DimSource& source : drive.sources) {
        if (!drive.profile.isTemperature(source.path))
            continue;
        if (own && !own->folder.empty() && source.path.starts_with(own->folder))
            return source;
        others.push_back(source);
    }
    return others.size() == 1 ? others.front() : DimSource{};
}

DimSource proposedSource(
    const DriveRegisters& drive, int axis, const GridAxis& column, bool isOnlyDimension)
{
    if (const AxisInfo* named = axisNamedIn(column, drive.axes))
        return suits(column, *named) ? positionSource(drive, named->index) : DimSource{};
    if (hasTemperatures(column))
        return temperatureSource(drive, axis);
    const AxisInfo* own = axisOf(drive.axes, axis);
    const bool isOfAnother =
        own && !axisInHeader(column.name).empty() && !axisInHeader(own->name).empty();
    return isOnlyDimension && !isOfAnother && own && suits(column, *own)
        ? positionSource(drive, axis)
        : DimSource{};
}

SourceDoubt wrongUnit(Text text)
{
    Error refusal{ErrorCode::SourceMismatch, {{"doubt", text}}, {}};
    return {std::move(text), std::move(refusal)};
}

} // namespace

DimSource positionSource(const DriveRegisters& drive, int axis)
{
    const auto found = std::ranges::find_if(drive.sources, [&](const DimSource& source) {
        return drive.profile.axisOfPosition(source.path) == axis
            && !drive.profile.isAfterCompensation(source.path);
    });
    return found == drive.sources.end() ? DimSource{} : *found;
}

std::vector<DimSource> proposedSources(const DriveRegisters& drive, int axis, const Grid& grid)
{
    std::vector<DimSource> proposed;
    for (const GridAxis& column : grid.axes) {
        DimSource source = proposedSource(drive, axis, column, grid.axes.size() == 1);
        const bool isRepeated = std::ranges::find(proposed, source) != proposed.end();
        proposed.push_back(isRepeated ? DimSource{} : std::move(source));
    }
    return proposed;
}

std::optional<SourceDoubt> sourceDoubt(const DriveProfile& profile, const GridAxis& column,
    std::size_t dimension, const DimSource& source, bool isStated,
    const std::function<std::string(int axis)>& nameOf,
    const std::function<std::vector<std::string>(int axis)>& othersOf)
{
    const auto doubt = [&](const TextPattern& pattern) {
        return pattern
            .with("column", column.name.empty() ? Argument(dimension) : Argument(column.name))
            .with("unit", column.unit)
            .with("source", source.path);
    };
    const std::string_view named = axisInHeader(column.name);
    if (profile.isTemperature(source.path)) {
        if (isPositionUnit(column.unit))
            return wrongUnit(doubt(AXISCOMP_TEXT("Error",
                "Column {column} of the file has positions in {unit}, but its source {source} is a "
                "temperature.")));
        if (!named.empty() && column.unit.empty())
            return SourceDoubt{doubt(AXISCOMP_TEXT("Error",
                "Column {column} of the file is named as an axis, but its source {source} is a "
                "temperature."))};
        return std::nullopt;
    }
    const auto owner = profile.axisOfPosition(source.path);
    const std::string axis = owner ? nameOf(*owner) : std::string();
    if (!owner || isNamedAfter(column, trimmed(axis)))
        return std::nullopt;
    if (hasTemperatures(column)) {
        Text text = doubt(AXISCOMP_TEXT("Error",
            "Column {column} of the file has temperatures, but its source {source} is a "
            "position."));
        return isTemperatureUnit(column.unit) ? wrongUnit(std::move(text)) : SourceDoubt{text};
    }
    const std::string_view owning = axisInHeader(axis);
    const bool areLetters = !mayBeCounted(named) && areDifferentAxes(named, owning);
    const std::string name = nameInPositions(column.name);
    const bool isOther = areLetters
        || (!isStated && !name.empty() && namesAnotherAxis(name, axis, othersOf(*owner)));
    if (!isOther && (named.empty() || owning.empty()))
        return std::nullopt;
    const std::string called = axis.empty() ? std::to_string(*owner) : axis;
    SourceDoubt other{doubt(AXISCOMP_TEXT("Error",
                                "Column {column} of the file is not named as axis {axis}, whose "
                                "position its source {source} is."))
                          .with("axis", called)};
    if (!isStated && isOther)
        other.refusal = Error{
            ErrorCode::SourceMismatch, {{"doubt", other.text}, {"axis", Verbatim{called}}}, {}};
    return other;
}

std::vector<AxisChoice> proposedAxes(
    std::span<const CompensationTable> tables, std::span<const AxisInfo> axes)
{
    constexpr std::string_view addition = " error";
    std::vector<AxisChoice> choices(tables.size());
    std::set<int> taken;
    const auto propose = [&](std::size_t n, std::string_view name) {
        const AxisInfo* found = nullptr;
        for (const AxisInfo& axis : axes) {
            if (name.empty() || !sameLetters(trimmed(axis.name), name))
                continue;
            if (found)
                return; // of two axes
            found = &axis;
        }
        if (!choices[n] && found && taken.insert(found->index).second)
            choices[n] = found->index;
    };
    for (std::size_t n = 0; n < tables.size(); ++n)
        propose(n, trimmed(tables[n].name));
    for (std::size_t n = 0; n < tables.size(); ++n) {
        const std::string_view name = trimmed(tables[n].name);
        if (name.size() > addition.size()
            && sameLetters(name.substr(name.size() - addition.size()), addition))
            propose(n, trimmed(name.substr(0, name.size() - addition.size())));
    }
    return choices;
}

std::optional<std::size_t> proposedTable(
    std::span<const CompensationTable> tables, std::span<const AxisInfo> axes, int axis)
{
    const std::vector<AxisChoice> choices = proposedAxes(tables, axes);
    const auto found = std::ranges::find(choices, AxisChoice(axis));
    return found == choices.end()
        ? std::nullopt
        : std::optional(static_cast<std::size_t>(found - choices.begin()));
}

} // namespace axiscomp
