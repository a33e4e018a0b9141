// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/configuration/compensation_parameters.h"

#include "core/drive/register_value.h"
#include "core/text/utf8.h"
#include "core/text/xml_tags.h"

#include <algorithm>
#include <utility>

namespace axiscomp {

namespace {

constexpr int axisLimit = 64;

auto wrongValue(const std::string& fileName, const TamRegister& found, Text problem)
{
    return fail(ErrorCode::InvalidConfiguration,
        {{"file", fileName}, {"line", found.line},
            {"reason",
                AXISCOMP_TEXT("Error", "{place}: {problem}")
                    .with("place", shownText(found.path))
                    .with("problem", std::move(problem))}});
}

std::string pathOf(const std::string& pattern, int axis, std::optional<int> n = {})
{
    return normalisedPath(expandPath(pattern, {.axis = axis, .slot = {}, .n = n}));
}

Result<std::string> slotIn(
    const TamRegister& table, const DriveProfile& profile, const std::string& fileName)
{
    if (table.value == profile.enums.tableDisabled)
        return std::string();
    if (!profile.slotNamed(table.value))
        return wrongValue(fileName, table,
            AXISCOMP_TEXT("Error", "the profile has no slot {slot}")
                .with("slot", shownText(table.value)));
    return table.value;
}

Result<std::uint32_t> addressIn(const TamRegister* source, const std::string& fileName)
{
    if (!source)
        return 0U;
    const auto value = registerValueFromText("UInt32", source->value);
    if (!value)
        return wrongValue(fileName, *source, textOf(value.error()));
    return std::get<std::uint32_t>(*value);
}

/// Where a value is replaced.
struct Change {
    std::size_t offset = 0;
    std::size_t size = 0;
    std::string value;
};

/// Collects the values of one station that become others.
class StationEditor {
public:
    StationEditor(const TamStation& station, const std::string& fileName)
        : m_station(station)
        , m_fileName(fileName)
    {
    }

    /// unset: the value that a register which is not there stands for.
    [[nodiscard]] Result<void> set(
        const std::string& path, const std::string& value, const std::string& unset)
    {
        bool isThere = false;
        for (const TamRegister& each : m_station.registers) {
            if (each.path != path)
                continue;
            isThere = true;
            if (each.value != value)
                m_changes.push_back({each.offset, each.size, xmlEscaped(value)});
        }
        if (isThere || value == unset)
            return {};
        return fail(ErrorCode::InvalidConfiguration,
            {{"file", m_fileName}, {"line", lineOfStation()},
                {"reason",
                    AXISCOMP_TEXT("Error", "the station {station} has no register {path}")
                        .with("station", stationName(m_station))
                        .with("path", path)}});
    }

    [[nodiscard]] std::string apply(std::string_view text)
    {
        std::ranges::sort(m_changes, {}, &Change::offset);
        std::string result;
        std::size_t done = 0;
        for (const Change& change : m_changes) {
            result += text.substr(done, change.offset - done);
            result += change.value;
            done = change.offset + change.size;
        }
        return result += text.substr(done);
    }

private:
    [[nodiscard]] std::size_t lineOfStation() const
    {
        return m_station.registers.empty() ? 1 : m_station.registers.front().line;
    }

    const TamStation& m_station;
    const std::string& m_fileName;
    std::vector<Change> m_changes;
};

Result<void> checkUnit(const TamStation& station, const AxisParameters& axis,
    const DriveProfile& profile, const std::string& fileName)
{
    const TamRegister* unit = station.find(pathOf(profile.registers.positionUnit, axis.axis));
    if (!unit || axis.unit.empty() || tamUnit(unit->value) == axis.unit)
        return {};
    return wrongValue(fileName, *unit,
        AXISCOMP_TEXT("Error", "the unit is {unit}, but the axis that is written has {other}")
            .with("unit", shownText(tamUnit(unit->value)))
            .with("other", axis.unit));
}

} // namespace

Result<CompensationParameters> stationParameters(
    const TamStation& station, const DriveProfile& profile, const std::string& fileName)
{
    const RegisterPaths& paths = profile.registers;
    CompensationParameters parameters{shownText(station.name), station.serialNumber, {}};
    for (int index = 0; index < axisLimit; ++index) {
        const TamRegister* table = station.find(pathOf(paths.table, index));
        if (!table)
            continue;
        AxisParameters axis;
        axis.axis = index;
        AXISCOMP_TRY(axis.slot, slotIn(*table, profile, fileName));
        if (const TamRegister* unit = station.find(pathOf(paths.positionUnit, index)))
            axis.unit = shownText(tamUnit(unit->value));
        for (int n = 1; n <= static_cast<int>(axis.sources.size()); ++n) {
            AXISCOMP_TRY(axis.sources.at(static_cast<std::size_t>(n - 1)),
                addressIn(station.find(pathOf(paths.source, index, n)), fileName));
        }
        parameters.axes.push_back(std::move(axis));
    }
    return parameters;
}

Result<void> checkStationOfDrive(
    const TamStation& station, std::optional<std::int32_t> serialNumber)
{
    if (serialNumber && station.serialNumber && station.serialNumber != serialNumber)
        return fail(
            ErrorCode::OtherDrive, {{"expected", *station.serialNumber}, {"found", *serialNumber}});
    return {};
}

Result<std::size_t> stationFor(std::span<const TamStation> stations, const std::string& fileName,
    std::optional<std::int32_t> serialNumber, const std::string& name, bool force)
{
    std::vector<std::size_t> matches;
    for (std::size_t n = 0; n < stations.size(); ++n) {
        const TamStation& station = stations[n];
        const bool isNamed = station.name == name
            || (station.serialNumber && std::to_string(*station.serialNumber) == name);
        const bool isOfDrive = serialNumber && station.serialNumber == serialNumber;
        if (name.empty() ? isOfDrive : isNamed)
            matches.push_back(n);
    }
    if (matches.empty() && name.empty() && stations.size() == 1)
        matches.push_back(0);
    if (matches.size() != 1) {
        std::vector<std::string> known;
        for (const TamStation& station : stations)
            known.push_back(stationName(station));
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "which station of {file} is meant is not certain; name one of: {known}")
                    .with("file", fileName)
                    .with("known", known)}});
    }
    if (!force)
        AXISCOMP_CHECK(checkStationOfDrive(stations[matches.front()], serialNumber));
    return matches.front();
}

Result<std::string> withParameters(std::string_view text, const TamStation& station,
    const CompensationParameters& parameters, const DriveProfile& profile,
    const std::string& fileName)
{
    const RegisterPaths& paths = profile.registers;
    const std::string& disabled = profile.enums.tableDisabled;
    StationEditor editor(station, fileName);
    for (const AxisParameters& axis : parameters.axes) {
        AXISCOMP_CHECK(checkUnit(station, axis, profile, fileName));
        AXISCOMP_CHECK(editor.set(
            pathOf(paths.table, axis.axis), axis.slot.empty() ? disabled : axis.slot, disabled));
        for (std::size_t n = 0; n < axis.sources.size(); ++n)
            AXISCOMP_CHECK(editor.set(pathOf(paths.source, axis.axis, static_cast<int>(n + 1)),
                std::to_string(axis.sources[n]), "0"));
    }
    return editor.apply(text);
}

} // namespace axiscomp
