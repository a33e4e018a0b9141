// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/source_directory.h"

#include "core/text/edit_distance.h"

#include <algorithm>
#include <charconv>

namespace axiscomp {

namespace {

constexpr std::string_view uriStart = "tam://";

bool isAllowed(const DriveProfile& profile, const std::string& type)
{
    return std::ranges::find(profile.sourceTypes, type) != profile.sourceTypes.end();
}

Result<DimSource> checkedType(const RegisterAccess& access, const std::string& path,
    const std::string& type, std::uint32_t address)
{
    if (!isAllowed(access.profile(), type))
        return fail(ErrorCode::SourceWrongType,
            {{"source", path}, {"type", type}, {"allowed", access.profile().sourceTypes}});
    return DimSource{address, path};
}

} // namespace

void SourceDirectory::useDrive(const DriveIdentity& drive)
{
    if (!(drive == m_drive))
        *this = SourceDirectory{};
    m_drive = drive;
}

Result<DimSource> SourceDirectory::resolve(const RegisterAccess& access, const std::string& text)
{
    if (text.starts_with("0x") || text.starts_with("0X"))
        return resolveAddress(access, text);
    if (!text.starts_with(uriStart))
        return resolvePath(access, normalisedPath(text), text);
    // tam://mc/<drive>/<path>
    const std::size_t drive = text.find('/', uriStart.size());
    const std::size_t path = drive == std::string::npos ? drive : text.find('/', drive + 1);
    if (path == std::string::npos)
        return fail(ErrorCode::SourceNotFound,
            {{"source", text},
                {"nearest", AXISCOMP_TEXT("Error", "; a URI is written tam://mc/<drive>/<path>")}});
    const std::string named = text.substr(drive + 1, path - drive - 1);
    if (named != m_drive.name)
        return fail(ErrorCode::SourceOtherDrive,
            {{"source", text}, {"other", named}, {"drive", m_drive.name}});
    return resolvePath(access, normalisedPath(text.substr(path + 1)), text);
}

Result<DimSource> SourceDirectory::resolvePath(
    const RegisterAccess& access, const std::string& path, const std::string& asWritten)
{
    auto readings = access.read({path});
    if (readings) {
        const RegisterReading& reading = readings->begin()->second;
        remember(reading);
        return checkedType(access, path, reading.type, reading.address);
    }
    if (readings.error().code != ErrorCode::UnknownRegister)
        return fail(readings.error());
    if (auto loaded = loadTree(access); !loaded && isUnreachable(loaded.error().code))
        return fail(loaded.error());
    return fail(ErrorCode::SourceNotFound, {{"source", asWritten}, {"nearest", nearest(path)}});
}

Result<DimSource> SourceDirectory::resolveAddress(
    const RegisterAccess& access, const std::string& text)
{
    std::uint32_t address = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data() + 2, end, address, 16);
    if (parsed.ec != std::errc{} || parsed.ptr != end || address == 0)
        return fail(ErrorCode::SourceNotFound,
            {{"source", text},
                {"nearest",
                    AXISCOMP_TEXT("Error", "; an address is written 0x and 1 to 8 hex digits")}});
    const auto source = sourceAt(access, address);
    if (!source)
        return source;
    const auto known = m_registers.find(address);
    if (known == m_registers.end())
        return fail(ErrorCode::SourceNotFound,
            {{"source", text},
                {"nearest", AXISCOMP_TEXT("Error", ": no register has this address")}});
    return checkedType(access, known->second.path, known->second.type, address);
}

Result<DimSource> SourceDirectory::sourceAt(const RegisterAccess& access, std::uint32_t address)
{
    if (address == 0)
        return DimSource{};
    const auto known = [&] { return m_registers.find(address); };
    if (known() == m_registers.end()) {
        AXISCOMP_CHECK(loadShortlist(access));
    }
    if (known() == m_registers.end()) {
        if (auto loaded = loadTree(access); !loaded && isUncertain(loaded.error().code))
            return fail(loaded.error());
    }
    return DimSource{address, known() == m_registers.end() ? std::string() : known()->second.path};
}

Result<std::vector<DimSource>> SourceDirectory::shortlist(const RegisterAccess& access)
{
    AXISCOMP_CHECK(loadShortlist(access));
    return m_shortlist;
}

Result<void> SourceDirectory::loadShortlist(const RegisterAccess& access)
{
    if (m_shortlistLoaded)
        return {};
    std::vector<std::string> paths;
    for (const std::string& pattern : access.profile().sourceShortlist) {
        if (pattern.find("{axis}") == std::string::npos) {
            paths.push_back(pattern);
            continue;
        }
        for (int axis = 0; axis < m_drive.axes; ++axis)
            paths.push_back(access.axisPath(pattern, axis));
    }
    AXISCOMP_TRY(auto readings, access.readAvailable(paths));
    for (const std::string& path : paths) {
        const auto reading = readings.find(path);
        if (reading == readings.end())
            continue;
        remember(reading->second);
        if (isAllowed(access.profile(), reading->second.type))
            m_shortlist.push_back({reading->second.address, path});
    }
    m_shortlistLoaded = true;
    return {};
}

Result<void> SourceDirectory::loadTree(const RegisterAccess& access)
{
    if (m_treeLoaded)
        return {};
    AXISCOMP_TRY(auto tree, access.link().readTree("", access.exchange()));
    for (const RegisterReading& reading : tree)
        remember(reading);
    m_treeLoaded = true;
    return {};
}

Text SourceDirectory::nearest(const std::string& path) const
{
    std::vector<std::pair<std::size_t, std::string_view>> candidates;
    for (const auto& [address, known] : m_registers) {
        // A number at most: a source is never an enum.
        if (known.type == "Single" || known.type == "Double")
            candidates.emplace_back(editDistance(path, known.path), known.path);
    }
    const std::size_t count = std::min<std::size_t>(3, candidates.size());
    const auto middle = candidates.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(candidates.begin(), middle, candidates.end());
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) {
        if (candidates[i].first <= std::max<std::size_t>(8, path.size() / 2))
            names.emplace_back(candidates[i].second);
    }
    if (names.empty())
        return {};
    return AXISCOMP_TEXT("Error", "; the nearest are {names}").with("names", names);
}

void SourceDirectory::remember(const RegisterReading& reading)
{
    if (reading.address != 0)
        m_registers.insert_or_assign(reading.address, Register{reading.path, reading.type});
}

} // namespace axiscomp
