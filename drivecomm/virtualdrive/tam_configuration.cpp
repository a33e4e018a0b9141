// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/tam_configuration.h"

#include "core/configuration/tam_configuration.h"
#include "core/io/local_file.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/firmware/drive_registers.h"

#include <QStringDecoder>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace axiscomp::drivecomm {

namespace {

constexpr std::size_t longestValue = 64;
constexpr int axisLimit = 64;
constexpr std::int32_t firstSerialNumber = 100001; ///< for stations that have none

struct Station {
    std::string name;
    std::optional<std::int32_t> serialNumber;
    int axes = 0;
    std::vector<RegisterReading> registers;
    std::unordered_map<std::string, std::size_t> places; ///< in registers, by path

    [[nodiscard]] RegisterReading* find(std::string_view pattern, const PathArguments& arguments)
    {
        const auto found = places.find(normalisedPath(expandPath(pattern, arguments)));
        return found == places.end() ? nullptr : &registers[found->second];
    }
};

/// The number of axes that a register's path asks for: 3 for "Axes[2]/...". None when the index is
/// none that a drive can have.
std::optional<int> axesNeeded(std::string_view path)
{
    constexpr std::string_view axes = "Axes[";
    if (!path.starts_with(axes))
        return 0;
    int index = -1;
    const auto end = std::from_chars(path.data() + axes.size(), path.data() + path.size(), index);
    if (end.ec != std::errc{} || index < 0 || index >= axisLimit
        || end.ptr == path.data() + path.size() || *end.ptr != ']')
        return {};
    return index + 1;
}

/// A register's value as the file writes it. Any type but the five is an enum.
Result<RegisterValue> parseValue(const std::string& type, const std::string& value)
{
    if (type == "Boolean" || type == "Int32" || type == "UInt32")
        return registerValueFromText(type, value);
    if (type == "Single" || type == "Double") {
        const Result<RegisterValue> parsed = registerValueFromText("Double", value);
        if (!parsed)
            return fail(parsed.error());
        // Neither a drive's web server nor a person can do anything with NaN.
        const double number = std::isfinite(toDouble(*parsed)) ? toDouble(*parsed) : 0.0;
        if (type == "Double")
            return number;
        if (std::abs(number) > std::numeric_limits<float>::max())
            return fail(ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error", "\"{value}\" is too large for a Single")
                        .with("value", value)}});
        return static_cast<float>(number);
    }
    if (value.size() > longestValue)
        return fail(ErrorCode::InvalidArgument,
            {{"reason", AXISCOMP_TEXT("Error", "the value is longer than any name of an enum")}});
    return value;
}

Text located(std::string_view place, Text problem)
{
    return AXISCOMP_TEXT("Error", "{place}: {problem}")
        .with("place", place)
        .with("problem", std::move(problem));
}

/// A station's registers with their values.
Result<Station> stationOf(const TamStation& read, const std::string& fileName)
{
    Station station;
    station.name = read.name;
    station.serialNumber = read.serialNumber;
    for (const TamRegister& each : read.registers) {
        const auto wrong = [&](Text problem) {
            return fail(ErrorCode::InvalidConfiguration,
                {{"file", fileName}, {"line", each.line},
                    {"reason", located(each.path, std::move(problem))}});
        };
        const std::optional<int> axes = axesNeeded(each.path);
        if (!axes)
            return wrong(AXISCOMP_TEXT("Error", "the axis index must be from 0 to {most}")
                             .with("most", axisLimit - 1));
        Result<RegisterValue> value = parseValue(each.type, each.value);
        if (!value)
            return wrong(textOf(value.error()));
        station.axes = std::max(station.axes, *axes);
        RegisterReading reading{each.path, 0, each.type, *std::move(value)};
        const auto [place, isNew] = station.places.emplace(each.path, station.registers.size());
        if (isNew)
            station.registers.push_back(std::move(reading));
        else
            station.registers[place->second] = std::move(reading);
    }
    return station;
}

/// In UTF-8. What says by its first bytes that it is UTF-16 is converted.
std::string utf8Of(std::string_view xml)
{
    if (!xml.starts_with("\xFF\xFE") && !xml.starts_with("\xFE\xFF"))
        return std::string(xml);
    QStringDecoder decoder(QStringDecoder::Utf16);
    const QString decoded = decoder(QByteArrayView(xml.data(), static_cast<qsizetype>(xml.size())));
    return decoded.toStdString();
}

/// Makes a drive of what the file says about a station.
class DriveMaker {
public:
    explicit DriveMaker(Station station)
        : m_station(std::move(station))
        , m_paths(genericProfile().registers)
    {
    }

    [[nodiscard]] VirtualDriveOptions make(std::int32_t ownSerialNumber)
    {
        VirtualDriveOptions options;
        options.serialNumber = m_station.serialNumber.value_or(ownSerialNumber);
        options.name = name(m_paths.deviceName, m_paths.deviceNameWords, {});
        if (options.name.empty()) {
            options.name = m_station.name.empty() ? "Drive" : m_station.name;
            setDeviceName(options.name);
        }
        for (int axis = 0; axis < m_station.axes; ++axis)
            options.axes.push_back(makeAxis(axis));
        options.parameters = std::move(m_station.registers);
        return options;
    }

private:
    [[nodiscard]] std::string name(std::string_view pattern, int words, std::optional<int> axis)
    {
        std::vector<std::int32_t> packed;
        for (int n = 0; n < words; ++n) {
            const RegisterReading* word = m_station.find(pattern, {.axis = axis, .n = n});
            const auto* number = word ? std::get_if<std::int32_t>(&word->value) : nullptr;
            packed.push_back(number ? *number : 0);
        }
        return unpackName(packed);
    }

    void setDeviceName(const std::string& name)
    {
        int n = 0;
        for (const std::int32_t word : packName(name, m_paths.deviceNameWords))
            if (RegisterReading* kept = m_station.find(m_paths.deviceName, {.n = n++}))
                kept->value = word;
    }

    [[nodiscard]] VirtualAxis makeAxis(int index)
    {
        VirtualAxis axis;
        axis.name = name(m_paths.axisName, m_paths.axisNameWords, index);
        if (RegisterReading* unit = m_station.find(m_paths.positionUnit, {.axis = index}))
            if (auto* found = std::get_if<std::string>(&unit->value))
                axis.unit = *found = tamUnit(*found);
        const auto number = [&](std::string_view pattern) {
            const RegisterReading* found = m_station.find(pattern, {.axis = index});
            return found ? toDouble(found->value) : 0.0;
        };
        axis.low = number(m_paths.positionMinimum);
        axis.high = number(m_paths.positionMaximum);
        if (!(axis.low < axis.high)) {
            axis.low = 0.0;
            axis.high = usualRange(axis.unit);
        }
        return axis;
    }

    [[nodiscard]] static double usualRange(std::string_view unit)
    {
        if (unit == "Degree")
            return 360.0;
        if (unit == "Radian")
            return 2.0 * std::numbers::pi;
        return unit == "Meter" ? 0.1 : 100.0;
    }

    Station m_station;
    const RegisterPaths& m_paths;
};

} // namespace

Result<std::vector<VirtualDriveOptions>> parseTamConfiguration(
    std::string_view xml, const std::string& fileName)
{
    const std::string text = utf8Of(xml);
    AXISCOMP_TRY(const auto stations, readTamStations(text, fileName));
    std::vector<VirtualDriveOptions> drives;
    for (const TamStation& read : stations) {
        AXISCOMP_TRY(auto station, stationOf(read, fileName));
        if (station.axes > 0)
            drives.push_back(
                DriveMaker(std::move(station))
                    .make(firstSerialNumber + static_cast<std::int32_t>(drives.size())));
    }
    if (drives.empty())
        return fail(ErrorCode::InvalidConfiguration,
            {{"file", fileName}, {"line", 1},
                {"reason",
                    AXISCOMP_TEXT(
                        "Error", "there is no TamStation with registers of an axis in it")}});
    return drives;
}

Result<std::vector<VirtualDriveOptions>> loadTamConfiguration(const std::filesystem::path& file)
{
    const Result<Bytes> bytes = loadFile(file, maximumConfigurationSize);
    if (!bytes)
        return fail(bytes.error());
    return parseTamConfiguration(asText(*bytes), file.string());
}

} // namespace axiscomp::drivecomm
