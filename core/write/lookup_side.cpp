// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/write/lookup_side.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// The position of the axis itself; the end: it is none of the sources.
auto ownSource(const DriveProfile& profile, int axis, std::span<const std::string> sources)
{
    return std::ranges::find_if(
        sources, [&](const std::string& source) { return profile.axisOfPosition(source) == axis; });
}

} // namespace

std::optional<LookupAt> lookupAtSource(const DriveProfile& profile, std::string_view source)
{
    if (!profile.axisOfPosition(source))
        return std::nullopt;
    return profile.isBeforeCompensation(source) ? LookupAt::Encoder : LookupAt::Set;
}

std::optional<LookupAt> lookupAtSources(
    const DriveProfile& profile, int axis, std::span<const std::string> sources)
{
    std::optional<LookupAt> common;
    bool areOnBothSides = false;
    if (const auto own = ownSource(profile, axis, sources); own != sources.end())
        return lookupAtSource(profile, *own);
    for (const std::string& source : sources) {
        const auto side = lookupAtSource(profile, source);
        areOnBothSides = areOnBothSides || (common && side && common != side);
        common = side ? side : common;
    }
    return areOnBothSides ? std::nullopt : common;
}

std::optional<std::size_t> ownDimension(
    const DriveProfile& profile, int axis, std::span<const std::string> sources)
{
    const auto own = ownSource(profile, axis, sources);
    if (own == sources.end())
        return std::nullopt;
    return static_cast<std::size_t>(own - sources.begin());
}

std::string lookupSource(
    const DriveProfile& profile, int axis, std::span<const std::string> sources)
{
    if (const auto own = ownSource(profile, axis, sources); own != sources.end())
        return *own;
    return sources.empty() ? std::string() : sources.front();
}

Result<void> checkLookupSource(LookupAt made, const DriveProfile& profile, std::string_view source)
{
    const auto found = lookupAtSource(profile, source);
    if (!found || *found == made)
        return {};
    const TextPattern pattern = *found == LookupAt::Set
        ? AXISCOMP_TEXT("Error",
            "the table was made for a position before the compensation, and {source} is one after "
            "it: choose another source, or make the table anew for this one, from its measurement "
            "or the file of its controller (on the command line with --lookup-at set)")
        : AXISCOMP_TEXT("Error",
            "the table was made for a position after the compensation, and {source} is one before "
            "it: choose another source, or make the table anew for this one, from its measurement "
            "or the file of its controller (on the command line with --lookup-at encoder)");
    return fail(ErrorCode::InvalidArgument,
        {{"reason", pattern.with("source", Verbatim{std::string(source)})}});
}

Result<void> checkLookupSources(
    LookupAt made, const DriveProfile& profile, int axis, std::span<const std::string> sources)
{
    if (lookupAtSources(profile, axis, sources).value_or(made) == made)
        return {};
    if (const auto own = ownSource(profile, axis, sources); own != sources.end())
        return checkLookupSource(made, profile, *own);
    for (const std::string& source : sources)
        AXISCOMP_CHECK(checkLookupSource(made, profile, source));
    return {};
}

} // namespace axiscomp
