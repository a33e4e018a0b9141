// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/measurement.h"

#include "core/base/wall_time.h"
#include "core/neutral/drive_note.h"
#include "core/text/crc_text.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace axiscomp {

namespace {

/// "2026-11-20" of "2026-11-20 08:15"; days in this form are in order as texts.
std::optional<std::string_view> dayOfDate(std::string_view date)
{
    constexpr std::string_view form = "0000-00-00";
    const std::string_view day = date.substr(0, form.size());
    std::string found(day);
    std::ranges::replace_if(
        found, [](char c) { return c >= '0' && c <= '9'; }, '0');
    return found == form ? std::optional(day) : std::nullopt;
}

} // namespace

std::string_view approachName(Approach direction)
{
    return direction == Approach::Up ? "up" : "down";
}

TextPattern approachText(Approach direction)
{
    return direction == Approach::Up ? AXISCOMP_TEXT("Measurement", "up")
                                     : AXISCOMP_TEXT("Measurement", "down");
}

std::string_view measurementKindName(MeasurementKind kind)
{
    switch (kind) {
    case MeasurementKind::Averages:
        return "averages";
    case MeasurementKind::Track:
        return "track";
    case MeasurementKind::Points:
        return "points";
    case MeasurementKind::Runs:
        break;
    }
    return "runs";
}

TextPattern measurementKindText(MeasurementKind kind)
{
    switch (kind) {
    case MeasurementKind::Averages:
        return AXISCOMP_TEXT("Measurement", "means of runs");
    case MeasurementKind::Track:
        return AXISCOMP_TEXT("Measurement", "a track without targets");
    case MeasurementKind::Points:
        return AXISCOMP_TEXT("Measurement", "points of a plane or space");
    case MeasurementKind::Runs:
        break;
    }
    return AXISCOMP_TEXT("Measurement", "runs over targets");
}

std::vector<Text> againstFileTexts(const AgainstFile& asked)
{
    const auto shown = [](const std::string& ofFile) {
        constexpr std::size_t mostBytes = 80;
        return shownText(ofFile, mostBytes);
    };
    std::vector<Text> list;
    if (asked.swapsDirections)
        list.emplace_back(AXISCOMP_TEXT("Report", "up and down exchanged"));
    if (asked.invertsReference)
        list.emplace_back(AXISCOMP_TEXT("Report", "reference taken with the opposite sign"));
    if (asked.takesAsReference)
        list.emplace_back(AXISCOMP_TEXT(
            "Report", "values taken as positions of the reference, the file says deviations"));
    if (asked.takesAsDeviations)
        list.emplace_back(AXISCOMP_TEXT(
            "Report", "values taken as deviations, the file says positions of the reference"));
    for (const StatedUnit& unit : asked.units)
        list.push_back(
            AXISCOMP_TEXT("Report", "unit of {what} taken as {stated}, the file says {unit}")
                .with("what", Verbatim{shown(unit.what)})
                .with("stated", Verbatim{unit.stated})
                .with("unit", Verbatim{shown(unit.ofFile)}));
    return list;
}

std::optional<std::int32_t> driveSerialOf(const MeasurementHeader& header)
{
    return driveSerialIn(header.drive);
}

bool isEarlier(std::string_view date, std::string_view other)
{
    const auto time = utcFromText(date);
    const auto otherTime = utcFromText(other);
    if (time && otherTime)
        return *time < *otherTime;
    const auto day = dayOfDate(date);
    const auto otherDay = dayOfDate(other);
    return day && otherDay && *day < *otherDay;
}

double Measurement::range() const
{
    if (hasTargets())
        return targets.empty() ? 0.0 : targets.back() - targets.front();
    if (track.empty())
        return 0.0;
    const auto [low, high] = std::ranges::minmax_element(track, {}, &TrackSample::encoder);
    return high->encoder - low->encoder;
}

std::vector<int> Measurement::runNumbers(Approach direction) const
{
    std::set<int> runs;
    for (const RunValue& value : values)
        if (value.direction == direction)
            runs.insert(value.run);
    return {runs.begin(), runs.end()};
}

int Measurement::runCount(Approach direction) const
{
    return static_cast<int>(runNumbers(direction).size());
}

int Measurement::lastRun(Approach direction) const
{
    const std::vector<int> numbers = runNumbers(direction);
    return numbers.empty() ? 0 : numbers.back();
}

std::size_t Measurement::excludedCount() const
{
    return static_cast<std::size_t>(std::ranges::count(values, false, &RunValue::isUsed));
}

std::string_view positionUnit(const Measurement& measurement)
{
    return measurement.isAngular ? "deg" : "mm";
}

std::optional<TemperatureRange> temperaturesOfValues(const Measurement& measurement)
{
    std::optional<TemperatureRange> range;
    for (const RunValue& value : measurement.values) {
        if (!value.isUsed)
            continue;
        if (!value.temperature)
            return std::nullopt;
        const double celsius = *value.temperature;
        range = range
            ? TemperatureRange{std::min(range->lowest, celsius), std::max(range->highest, celsius)}
            : TemperatureRange{celsius, celsius};
    }
    return range;
}

std::vector<double> distinctTargets(std::vector<double> positions)
{
    std::ranges::sort(positions);
    if (positions.empty())
        return positions;
    const double reach = 1e-9 * (positions.back() - positions.front());
    std::vector<double> targets;
    for (const double position : positions)
        if (targets.empty() || position - targets.back() > reach)
            targets.push_back(position);
    return targets;
}

std::size_t targetIndex(const std::vector<double>& targets, double position)
{
    const auto after = std::ranges::lower_bound(targets, position);
    if (after == targets.begin())
        return 0;
    const auto index = static_cast<std::size_t>(after - targets.begin());
    const bool isBeyond = after == targets.end() || position - *(after - 1) < *after - position;
    return isBeyond ? index - 1 : index;
}

std::string measuredStateText(const MeasuredState& state)
{
    if (state.kind == MeasuredState::Kind::NotSaid)
        return {};
    if (state.kind == MeasuredState::Kind::Off)
        return "off";
    return state.tableCrc ? "crc:" + crcText(*state.tableCrc) : "on";
}

std::vector<double> targetsWithoutValues(const Measurement& measurement)
{
    std::vector<bool> isMeasured(measurement.targets.size());
    for (const RunValue& value : measurement.values)
        isMeasured[value.target] = true;
    std::vector<double> targets;
    for (std::size_t i = 0; i < isMeasured.size(); ++i)
        if (!isMeasured[i])
            targets.push_back(measurement.targets[i]);
    return targets;
}

std::span<const RunValue> valuesAt(
    const Measurement& measurement, Approach direction, std::size_t target)
{
    const auto place = [](const RunValue& value) {
        return std::pair(value.direction, value.target);
    };
    const std::pair wanted(direction, target);
    return {std::ranges::lower_bound(measurement.values, wanted, {}, place),
        std::ranges::upper_bound(measurement.values, wanted, {}, place)};
}

const RunValue* findValue(
    const Measurement& measurement, Approach direction, std::size_t target, int run)
{
    const auto values = valuesAt(measurement, direction, target);
    const auto found = std::ranges::lower_bound(values, run, {}, &RunValue::run);
    return found != values.end() && found->run == run ? &*found : nullptr;
}

void sortValues(std::vector<RunValue>& values)
{
    std::ranges::sort(values, {}, [](const RunValue& value) {
        return std::tuple(value.direction, value.target, value.run, value.line);
    });
}

} // namespace axiscomp
