// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/axis_target.h"

#include "core/table/target_axis.h"

#include <algorithm>
#include <utility>

namespace axiscomp {

namespace {

/// "dimension 1 (X)"
Text sourceText(const Grid& grid, std::size_t source)
{
    const std::string& name = grid.axes[source].name;
    return (name.empty() ? AXISCOMP_TEXT("Error", "the axis of dimension {number}")
                         : AXISCOMP_TEXT("Error", "the axis of dimension {number} ({axis})"))
        .with("number", source + 1)
        .with("axis", name);
}

/// What the axis is among its sources.
Text roleText(const std::optional<TargetAxis>& actual)
{
    if (!actual)
        return AXISCOMP_TEXT("Error", "a source is no position of an axis");
    if (!actual->source)
        return AXISCOMP_TEXT("Error", "all sources are positions of other axes");
    return AXISCOMP_TEXT("Error", "dimension {number} is its own position")
        .with("number", *actual->source + 1);
}

} // namespace

std::string axisTarget(const DriveProfile& profile, int axis, std::span<const std::string> sources)
{
    bool areOthers = !sources.empty();
    for (std::size_t n = 0; n < sources.size(); ++n) {
        const auto owner = profile.axisOfPosition(sources[n]);
        if (owner == axis)
            return sourceTarget(n);
        areOthers = areOthers && owner.has_value();
    }
    return areOthers ? std::string(otherAxis) : std::string();
}

Result<void> checkTarget(const DriveProfile& profile, int axis,
    std::span<const std::string> sources, const CompensationTable& table)
{
    const auto stated = targetOf(table);
    const std::vector<std::string> nameless(table.grid.axes.size());
    const std::string statement = axisTarget(profile, axis, sources);
    const auto actual = targetAxis(statement, nameless);
    if (!stated || stated == actual || (!actual && !table.isTargetOfDrive))
        return {};
    Text target = AXISCOMP_TEXT("Error", "an axis that is no source");
    if (stated->source)
        target = sourceText(table.grid, *stated->source);
    else if (table.target != otherAxis)
        target = Verbatim{table.target};
    Error error{ErrorCode::TargetMismatch,
        {{"table", table.name}, {"target", target}, {"axis", axis}, {"role", roleText(actual)},
            {"statement", statement}},
        {}};
    if (table.isTargetOfDrive)
        error.context.set("suggested", Verbatim{"target"});
    return fail(std::move(error));
}

std::vector<std::string> sourcePaths(const CompensationSetup& setup)
{
    std::vector<std::string> paths;
    for (const DimSource& source : setup.sources)
        if (source.isSet())
            paths.push_back(source.path);
    return paths;
}

} // namespace axiscomp
