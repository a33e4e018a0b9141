// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/axis/axis_reader.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

constexpr int sourceCount = 3;
constexpr int mostAttempts = 4; ///< to read an axis that somebody changes at the same time

std::string axisNameFrom(const RegisterAccess& access, const Readings& readings, int axis)
{
    std::vector<std::int32_t> words;
    for (int n = 0; n < access.registers().axisNameWords; ++n) {
        const auto word = readings.find(access.axisPath(access.registers().axisName, axis, n));
        const auto* value =
            word == readings.end() ? nullptr : std::get_if<std::int32_t>(&word->second.value);
        words.push_back(value ? *value : 0);
    }
    return unpackName(words);
}

void append(std::vector<std::string>& paths, const std::vector<std::string>& more)
{
    paths.insert(paths.end(), more.begin(), more.end());
}

std::vector<std::string> travelPaths(const RegisterAccess& access, int axis)
{
    const RegisterPaths& names = access.registers();
    if (names.positionMinimum.empty() || names.positionMaximum.empty())
        return {};
    return {
        access.axisPath(names.positionMinimum, axis), access.axisPath(names.positionMaximum, axis)};
}

std::optional<Travel> travelFrom(const RegisterAccess& access, const Readings& readings, int axis)
{
    const std::vector<std::string> paths = travelPaths(access, axis);
    if (paths.empty())
        return std::nullopt;
    return travelBetween(numberAt(readings, paths[0]), numberAt(readings, paths[1]));
}

std::vector<std::string> infoPaths(const RegisterAccess& access, int axis)
{
    const RegisterPaths& names = access.registers();
    std::vector<std::string> paths = access.axisPaths(names.axisName, axis, 0, names.axisNameWords);
    for (const std::string& pattern : {names.positionUnit, names.homingState, names.state})
        paths.push_back(access.axisPath(pattern, axis));
    append(paths, travelPaths(access, axis));
    return paths;
}

/// The folders of a path's pattern down to the one behind {axis}, or `more` further ones.
std::string folderOf(const RegisterAccess& access, const std::string& pattern, int axis, int more)
{
    std::size_t slash = pattern.find('/', pattern.find("{axis}"));
    for (; more > 0 && slash != std::string::npos; --more)
        slash = pattern.find('/', slash + 1);
    return slash == std::string::npos ? std::string()
                                      : access.axisPath(pattern.substr(0, slash), axis) + '/';
}

AxisInfo infoFrom(const RegisterAccess& access, const Readings& readings, int axis)
{
    const RegisterPaths& names = access.registers();
    AxisInfo info;
    info.index = axis;
    info.folder = folderOf(access, names.state, axis, 0);
    info.signalFolder = folderOf(access, names.state, axis, 1);
    info.name = axisNameFrom(access, readings, axis);
    info.unit = textAt(readings, access.axisPath(names.positionUnit, axis));
    info.travel = travelFrom(access, readings, axis);
    info.homingWord = textAt(readings, access.axisPath(names.homingState, axis));
    info.isHomed = info.homingWord == access.enums().homingDone;
    info.stateWord = textAt(readings, access.axisPath(names.state, axis));
    info.state = compensationState(access.enums(), info.stateWord);
    return info;
}

/// Everything about the axis that can be asked without knowing its slot and sources.
std::vector<std::string> statusPaths(const RegisterAccess& access, int axis)
{
    const RegisterPaths& names = access.registers();
    std::vector<std::string> paths = infoPaths(access, axis);
    append(paths, axisRegisterPaths(access.profile(), axis));
    for (const std::string& pattern : {names.activation, names.error, names.output})
        paths.push_back(access.axisPath(pattern, axis));
    append(paths, access.axisPaths(names.index, axis, 1, sourceCount));
    paths.push_back(names.driveError);
    return paths;
}

int dimensionalityOf(const CompensationSetup& setup, const std::optional<TableHeader>& table)
{
    const auto set = std::ranges::count_if(setup.sources, &DimSource::isSet);
    if (set > 0)
        return static_cast<int>(set);
    return table ? table->grid.dimensions() : 1;
}

/// What the axis uses, from a first reading; the second, complete one depends on it.
struct Wiring {
    std::string slot;
    std::array<DimSource, sourceCount> sources;
    friend bool operator==(const Wiring&, const Wiring&) = default;
};

Result<Wiring> wiringFrom(
    const RegisterAccess& access, const Readings& readings, int axis, SourceDirectory& sources)
{
    Wiring wiring;
    const std::string table = textAt(readings, access.axisPath(access.registers().table, axis));
    if (table != access.enums().tableDisabled)
        wiring.slot = table;
    for (int n = 0; n < sourceCount; ++n) {
        const std::string path = access.axisPath(access.registers().source, axis, n + 1);
        AXISCOMP_TRY(auto source, sources.sourceAt(access, unsignedAt(readings, path)));
        wiring.sources[static_cast<std::size_t>(n)] = source;
    }
    return wiring;
}

/// PositionUnit of the axis whose position a source is; empty: it is none.
std::string unitPathOf(const RegisterAccess& access, const DimSource& source)
{
    const auto owner = access.profile().axisOfPosition(source.path);
    return owner ? access.axisPath(access.registers().positionUnit, *owner) : std::string();
}

Result<Readings> readWired(const RegisterAccess& access, int axis, const Wiring& wiring,
    const std::vector<std::string>& more)
{
    std::vector<std::string> paths = statusPaths(access, axis);
    if (access.profile().slotNamed(wiring.slot))
        append(paths, headerPaths(access, wiring.slot));
    for (const DimSource& source : wiring.sources) {
        if (!source.path.empty())
            paths.push_back(source.path);
        if (auto unit = unitPathOf(access, source); !unit.empty())
            paths.push_back(std::move(unit));
    }
    append(paths, more);
    return access.readAvailable(std::move(paths));
}

AxisStatus statusFrom(
    const RegisterAccess& access, const Readings& readings, int axis, const Wiring& wiring)
{
    const RegisterPaths& names = access.registers();
    AxisStatus status;
    status.axis = infoFrom(access, readings, axis);
    status.setup.slot = wiring.slot;
    status.setup.sources = wiring.sources;
    if (!wiring.slot.empty())
        status.table = headerFrom(access, readings, wiring.slot);
    if (status.table) {
        status.setup.tableCrc = status.table->crc;
        status.setup.persistency =
            status.table->persistent ? Persistency::Persistent : Persistency::Volatile;
    }
    status.setup.dimensionality = dimensionalityOf(status.setup, status.table);
    status.activation = textAt(readings, access.axisPath(names.activation, axis));
    status.error = textAt(readings, access.axisPath(names.error, axis));
    status.fault = compensationFault(access.enums(), status.error);
    status.output = numberAt(readings, access.axisPath(names.output, axis));
    status.driveError = textAt(readings, names.driveError);
    status.hasDriveError =
        !status.driveError.empty() && status.driveError != access.enums().driveErrorNone;
    for (std::size_t n = 0; n < sourceCount; ++n) {
        const int number = static_cast<int>(n) + 1;
        status.indices[n] = numberAt(readings, access.axisPath(names.index, axis, number));
        if (!wiring.sources[n].path.empty())
            status.sourceValues[n] = numberAt(readings, wiring.sources[n].path);
        status.sourceUnits[n] = textAt(readings, unitPathOf(access, wiring.sources[n]));
    }
    return status;
}

} // namespace

Result<std::vector<AxisInfo>> readAxes(const RegisterAccess& access, const DriveIdentity& drive)
{
    std::vector<AxisInfo> axes;
    const std::size_t perAxis = infoPaths(access, 0).size();
    const int perRequest = static_cast<int>(DriveLink::maximumReads / perAxis);
    for (int first = 0; first < drive.axes; first += perRequest) {
        const int last = std::min(drive.axes, first + perRequest);
        std::vector<std::string> paths;
        for (int axis = first; axis < last; ++axis)
            append(paths, infoPaths(access, axis));
        AXISCOMP_TRY(auto readings, access.readAvailable(paths));
        for (int axis = first; axis < last; ++axis)
            axes.push_back(infoFrom(access, readings, axis));
    }
    return axes;
}

Result<PositionFacts> readPositionFacts(const RegisterAccess& access, int axis)
{
    const std::string unit = access.axisPath(access.registers().positionUnit, axis);
    const RegisterPaths& names = access.registers();
    std::vector<std::string> paths = access.axisPaths(names.axisName, axis, 0, names.axisNameWords);
    paths.push_back(unit);
    append(paths, travelPaths(access, axis));
    AXISCOMP_TRY(const auto readings, access.readAvailable(std::move(paths)));
    return PositionFacts{axisNameFrom(access, readings, axis), textAt(readings, unit),
        travelFrom(access, readings, axis)};
}

Result<std::vector<std::string>> readAxisNames(
    const RegisterAccess& access, const DriveIdentity& drive)
{
    const RegisterPaths& paths = access.registers();
    const int perRequest =
        std::max(1, static_cast<int>(DriveLink::maximumReads) / std::max(1, paths.axisNameWords));
    std::vector<std::string> names;
    for (int first = 0; first < drive.axes; first += perRequest) {
        const int last = std::min(drive.axes, first + perRequest);
        std::vector<std::string> words;
        for (int axis = first; axis < last; ++axis)
            append(words, access.axisPaths(paths.axisName, axis, 0, paths.axisNameWords));
        AXISCOMP_TRY(const auto readings, access.readAvailable(std::move(words)));
        for (int axis = first; axis < last; ++axis)
            names.push_back(axisNameFrom(access, readings, axis));
    }
    return names;
}

Result<AxisStatus> readStatus(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources)
{
    AXISCOMP_TRY(auto reading, readStatusWith(access, drive, axis, sources, {}));
    return std::move(reading.status);
}

CompensationState compensationState(const RegisterEnums& enums, std::string_view word)
{
    using enum CompensationState;
    const std::array words{std::pair(&enums.stateDisabled, Disabled),
        std::pair(&enums.stateEvaluating, Evaluating), std::pair(&enums.stateRamping, Ramping),
        std::pair(&enums.stateActive, Active), std::pair(&enums.stateError, Error)};
    for (const auto& [known, state] : words) {
        if (*known == word)
            return state;
    }
    return Unknown;
}

CompensationFault compensationFault(const RegisterEnums& enums, std::string_view word)
{
    using enum CompensationFault;
    // A drive without the register, and an axis without compensation, says nothing.
    if (word.empty() || word == enums.errorNone)
        return None;
    const std::array words{std::pair(&enums.errorNotHomed, NotHomed),
        std::pair(&enums.errorNoTable, NoTable),
        std::pair(&enums.errorDimensionMismatch, DimensionMismatch),
        std::pair(&enums.errorBadSource, BadSource), std::pair(&enums.errorBadTable, BadTable)};
    for (const auto& [known, fault] : words) {
        if (*known == word)
            return fault;
    }
    return Other;
}

Error compensationActive(const AxisStatus& status)
{
    return {ErrorCode::CompensationActive,
        {{"axis", status.axis.index}, {"name", status.axis.name}}, {}};
}

Result<StatusReading> readStatusWith(const RegisterAccess& access, const DriveIdentity& drive,
    int axis, SourceDirectory& sources, const std::vector<std::string>& more)
{
    AXISCOMP_TRY(auto first, access.readAvailable(statusPaths(access, axis)));
    if (!first.contains(access.axisPath(access.registers().table, axis))
        || !first.contains(access.axisPath(access.registers().state, axis)))
        return fail(ErrorCode::NoCompensation, {{"axis", axis}});
    auto wiring = wiringFrom(access, first, axis, sources);
    if (!wiring)
        return fail(wiring.error());
    Wiring known = *wiring;
    for (int attempt = 0; attempt < mostAttempts; ++attempt) {
        // Once more with the table's header and the sources' values, so that all belongs to one
        // instant; and again when the axis was changed before that instant.
        AXISCOMP_TRY(auto readings, readWired(access, axis, known, more));
        wiring = wiringFrom(access, readings, axis, sources);
        if (!wiring)
            return fail(wiring.error());
        if (*wiring == known) {
            AxisStatus status = statusFrom(access, readings, axis, known);
            status.drive = drive;
            return StatusReading{std::move(status), std::move(readings)};
        }
        std::swap(known, *wiring);
    }
    return fail(ErrorCode::ChangedMeanwhile,
        {{"what", AXISCOMP_TEXT("Error", "the settings of axis {axis}").with("axis", axis)},
            {"before", wiring->slot}, {"now", known.slot}});
}

Result<std::vector<RegisterWrite>> readAxisRegisters(const RegisterAccess& access, int axis)
{
    const std::vector<std::string> paths = axisRegisterPaths(access.profile(), axis);
    AXISCOMP_TRY(auto readings, access.link().readRegisters(paths, access.exchange()));
    std::vector<RegisterWrite> registers;
    for (RegisterReading& reading : readings)
        registers.push_back({std::move(reading.path), std::move(reading.value)});
    return registers;
}

std::vector<RegisterWrite> axisRegisters(
    const RegisterAccess& access, int axis, const CompensationSetup& setup)
{
    const std::vector<std::string> paths = axisRegisterPaths(access.profile(), axis);
    const std::string table = setup.slot.empty() ? access.enums().tableDisabled : setup.slot;
    std::vector<RegisterWrite> registers{{paths[0], table}};
    for (std::size_t n = 0; n < sourceCount; ++n)
        registers.push_back({paths[n + 1], setup.sources[n].address});
    return registers;
}

std::vector<std::string> headerPaths(const RegisterAccess& access, std::string_view slot)
{
    const RegisterPaths& names = access.registers();
    std::vector<std::string> paths;
    for (const std::string& pattern :
        {names.tablePersistent, names.tableDimensions, names.tableElements, names.tableCrc})
        paths.push_back(access.slotPath(pattern, slot));
    for (const std::string& pattern : {names.tableSize, names.tableStart, names.tableDistance}) {
        for (int n = 0; n < sourceCount; ++n)
            paths.push_back(access.slotPath(pattern, slot, n));
    }
    return paths;
}

std::optional<TableHeader> headerFrom(
    const RegisterAccess& access, const Readings& readings, std::string_view slot)
{
    const RegisterPaths& names = access.registers();
    TableHeader header;
    header.elements = unsignedAt(readings, access.slotPath(names.tableElements, slot));
    const auto dimensions = unsignedAt(readings, access.slotPath(names.tableDimensions, slot));
    if (header.elements == 0 || dimensions < 1 || dimensions > sourceCount)
        return std::nullopt;
    header.crc = unsignedAt(readings, access.slotPath(names.tableCrc, slot));
    header.persistent = numberAt(readings, access.slotPath(names.tablePersistent, slot)) == 1.0;
    for (int n = 0; n < static_cast<int>(dimensions); ++n) {
        GridAxis axis;
        axis.size = unsignedAt(readings, access.slotPath(names.tableSize, slot, n));
        axis.start = numberAt(readings, access.slotPath(names.tableStart, slot, n));
        axis.distance = numberAt(readings, access.slotPath(names.tableDistance, slot, n));
        header.grid.axes.push_back(axis);
    }
    return header;
}

} // namespace axiscomp
