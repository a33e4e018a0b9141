// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/run_selection.h"

#include "core/metrology/header_texts.h"
#include "core/table/target_axis.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace axiscomp {

namespace {

tl::unexpected<Error> wrong(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

std::optional<Approach> approachNamed(std::string_view text)
{
    if (sameLetters(text, "up") || text == "+")
        return Approach::Up;
    if (sameLetters(text, "down") || text == "-")
        return Approach::Down;
    return std::nullopt;
}

/// A count from 1.
std::optional<std::int64_t> ordinal(const Token& token)
{
    const auto number = wholeNumberOf(token.text);
    constexpr std::int64_t largest = 1'000'000'000;
    return number && *number >= 1 && *number <= largest ? number : std::nullopt;
}

std::optional<Exclusion> exclusionOf(const Token& item)
{
    std::vector<Token> parts;
    splitCells(item, ':', parts);
    if (parts.size() == 2 && sameLetters(parts[0].text, "target")) {
        const auto target = ordinal(parts[1]);
        return target ? std::optional(Exclusion{{}, static_cast<std::size_t>(*target), {}})
                      : std::nullopt;
    }
    if (parts.size() != 3)
        return std::nullopt;
    const bool isRun = sameLetters(parts[0].text, "run");
    const auto direction = approachNamed(parts[isRun ? 1 : 0].text);
    const auto run = ordinal(parts[2]);
    const auto target = isRun ? std::optional<std::int64_t>(0) : ordinal(parts[1]);
    if (!direction || !run || !target)
        return std::nullopt;
    Exclusion exclusion{direction, {}, static_cast<int>(*run)};
    if (!isRun)
        exclusion.target = static_cast<std::size_t>(*target);
    return exclusion;
}

/// The values among which those of an exclusion are. They are sorted: one alone is found at once.
std::span<RunValue> candidates(Measurement& measurement, const Exclusion& exclusion)
{
    if (!exclusion.direction || !exclusion.target || !exclusion.run)
        return measurement.values;
    const std::tuple wanted(*exclusion.direction, *exclusion.target, *exclusion.run);
    const auto place = [](const RunValue& value) {
        return std::tuple(value.direction, value.target + 1, value.run);
    };
    return {std::ranges::lower_bound(measurement.values, wanted, {}, place),
        std::ranges::upper_bound(measurement.values, wanted, {}, place)};
}

/// The targets of all, each once.
std::vector<double> allTargets(std::span<const Measurement> measurements)
{
    std::vector<double> targets;
    for (const Measurement& measurement : measurements)
        targets.insert(targets.end(), measurement.targets.begin(), measurement.targets.end());
    return distinctTargets(std::move(targets));
}

/// Numbers that hold for all only where every file says the same.
struct HeaderNumber {
    const char* key;
    std::optional<double> MeasurementHeader::*member;
};
constexpr std::array headerNumbers{
    HeaderNumber{"air temperature", &MeasurementHeader::airTemperature},
    HeaderNumber{"material temperature", &MeasurementHeader::materialTemperature},
    HeaderNumber{"expansion", &MeasurementHeader::expansion}};

bool isSaidAlike(std::span<const Measurement> measurements, const HeaderNumber& number)
{
    const auto saidBy = [&](const Measurement& one) { return one.header.*number.member; };
    return std::ranges::all_of(measurements,
        [&](const Measurement& one) { return saidBy(one) == saidBy(measurements.front()); });
}

/// Empty: no file says it.
std::string firstStated(
    std::span<const Measurement> measurements, std::string MeasurementHeader::*text)
{
    for (const Measurement& measurement : measurements)
        if (!(measurement.header.*text).empty())
            return measurement.header.*text;
    return {};
}

/// The states that are said.
std::vector<MeasuredState> saidStates(std::span<const Measurement> measurements)
{
    std::vector<MeasuredState> states;
    for (const Measurement& measurement : measurements)
        if (measurement.header.compensation.kind != MeasuredState::Kind::NotSaid)
            states.push_back(measurement.header.compensation);
    return states;
}

/// What is measured twice counts twice: repeatability would be better than the machine's.
Result<void> checkEachOnce(std::span<const Measurement> measurements)
{
    for (std::size_t n = 1; n < measurements.size(); ++n)
        for (std::size_t earlier = 0; earlier < n; ++earlier)
            if (measurements[n] == measurements[earlier])
                return wrong(AXISCOMP_TEXT("Error",
                    "file {second} holds the same measurement as file {first}, value by value: "
                    "give it once")
                                 .with("second", n + 1)
                                 .with("first", earlier + 1));
    return {};
}

/// The axes X of two drives are not one.
Result<void> checkJoinedDrive(
    std::span<const Measurement> measurements, const Measurement& measurement)
{
    const auto serial = driveSerialOf(measurement.header);
    for (const Measurement& other : measurements) {
        const auto otherSerial = driveSerialOf(other.header);
        if (serial && otherSerial && *serial != *otherSerial)
            return wrong(AXISCOMP_TEXT("Error",
                "measurements of the drive with the serial number {drive} and of the one with "
                "{other} cannot be joined; take those of one drive, and where it was replaced in "
                "between, correct the line // drive: of the files")
                             .with("drive", Verbatim{std::to_string(*serial)})
                             .with("other", Verbatim{std::to_string(*otherSerial)}));
    }
    return {};
}

/// What decides what is made of the values has to be the same of all, since it is said of the whole
/// afterwards.
Result<void> checkJoinable(std::span<const Measurement> measurements)
{
    const Measurement& first = measurements.front();
    const std::string axis = firstStated(measurements, &MeasurementHeader::axis);
    for (const Measurement& measurement : measurements) {
        if (measurement.kind != MeasurementKind::Runs)
            return wrong(
                AXISCOMP_TEXT("Error", "only runs over targets can be joined; one file has {kind}")
                    .with("kind", measurementKindText(measurement.kind)));
        if (measurement.isAngular != first.isAngular)
            return wrong(AXISCOMP_TEXT(
                "Error", "a measurement of lengths and one of angles cannot be joined"));
        if (areDifferentAxes(measurement.header.axis, axis))
            return wrong(AXISCOMP_TEXT(
                "Error", "measurements of axis {axis} and of axis {other} cannot be joined")
                             .with("axis", axis)
                             .with("other", measurement.header.axis));
        AXISCOMP_CHECK(checkJoinedDrive(measurements, measurement));
        if (measurement.header.corrected != first.header.corrected)
            return wrong(AXISCOMP_TEXT("Error",
                "some of the files say otherwise than the others, or do not say, whether their "
                "values are corrected to 20 deg C, so that no correction would be right for all; "
                "say it in each of them (// corrected: 20C, or // corrected: none), or take those "
                "alone that agree"));
    }
    const auto states = saidStates(measurements);
    if (std::ranges::any_of(
            states, [&](const MeasuredState& state) { return state != states.front(); }))
        return wrong(AXISCOMP_TEXT("Error",
            "measurements with different tables, or with and without compensation, cannot be "
            "joined"));
    return checkEachOnce(measurements);
}

/// What is said of all at once.
MeasurementHeader commonHeader(std::span<const Measurement> measurements)
{
    MeasurementHeader header = measurements.front().header;
    for (const HeaderText& text : headerTexts)
        header.*text.member = firstStated(measurements, text.member);
    // A drive is told by its serial number: a name alone says less.
    const auto told = std::ranges::find_if(
        measurements, [](const Measurement& one) { return driveSerialOf(one.header).has_value(); });
    if (told != measurements.end())
        header.drive = told->header.drive;
    const auto states = saidStates(measurements);
    if (states.size() < measurements.size()) {
        header.compensation = {};
        header.compensationOfSome = states.empty() ? MeasuredState{} : states.front();
    }
    for (const HeaderNumber& number : headerNumbers)
        if (!isSaidAlike(measurements, number))
            (header.*number.member).reset();
    return header;
}

/// What cannot be said of all is kept as a note of each.
void keepNumbers(Measurement& whole, std::span<const Measurement> measurements)
{
    for (const HeaderNumber& number : headerNumbers) {
        if (isSaidAlike(measurements, number))
            continue;
        for (std::size_t n = 0; n < measurements.size(); ++n) {
            const auto& value = measurements[n].header.*number.member;
            whole.notes.push_back("file " + std::to_string(n + 1) + ", " + number.key + ": "
                + (value ? toText(*value) : std::string("not stated")));
        }
    }
}

/// What a joined file says otherwise than the first one is kept as a note.
void keepDifferences(Measurement& whole, const Measurement& other)
{
    for (const HeaderText& text : headerTexts) {
        const std::string& said = other.header.*text.member;
        if (!said.empty() && said != whole.header.*text.member)
            whole.notes.push_back(std::string(text.key) + ": " + said);
    }
    for (const std::string& note : other.notes)
        if (std::ranges::find(whole.notes, note) == whole.notes.end())
            whole.notes.push_back(note);
}

/// What was asked for one of the files is in the whole.
void keepAgainstFile(AgainstFile& whole, const AgainstFile& other)
{
    whole.swapsDirections = whole.swapsDirections || other.swapsDirections;
    whole.invertsReference = whole.invertsReference || other.invertsReference;
    whole.takesAsReference = whole.takesAsReference || other.takesAsReference;
    whole.takesAsDeviations = whole.takesAsDeviations || other.takesAsDeviations;
    for (const StatedUnit& unit : other.units)
        if (std::ranges::find(whole.units, unit) == whole.units.end())
            whole.units.push_back(unit);
}

} // namespace

Result<std::vector<Exclusion>> exclusionsFromText(std::string_view text)
{
    std::vector<Token> items;
    splitCells({text, 0, 1}, ',', items);
    std::vector<Exclusion> exclusions;
    for (const Token& item : items) {
        const auto exclusion = exclusionOf(item);
        if (!exclusion)
            return wrong(AXISCOMP_TEXT("Error",
                "\"{text}\" names nothing that can be excluded; write down:1:1 for a value "
                "(direction, target, run), run:up:3 or target:7")
                             .with("text", item.text));
        exclusions.push_back(*exclusion);
    }
    return exclusions;
}

std::string exclusionText(const Exclusion& exclusion)
{
    const std::string run = exclusion.run ? std::to_string(*exclusion.run) : std::string();
    if (!exclusion.direction)
        return "target:" + std::to_string(exclusion.target.value_or(0));
    const std::string direction(approachName(*exclusion.direction));
    return exclusion.target ? direction + ":" + std::to_string(*exclusion.target) + ":" + run
                            : "run:" + direction + ":" + run;
}

bool isOneValue(const Exclusion& exclusion)
{
    return exclusion.direction && exclusion.target && exclusion.run;
}

bool covers(const Exclusion& exclusion, const RunValue& value)
{
    return (!exclusion.direction || *exclusion.direction == value.direction)
        && (!exclusion.target || *exclusion.target == value.target + 1)
        && (!exclusion.run || *exclusion.run == value.run);
}

Result<void> exclude(Measurement& measurement, std::span<const Exclusion> exclusions)
{
    for (const Exclusion& exclusion : exclusions) {
        bool isThere = false;
        for (RunValue& value : candidates(measurement, exclusion)) {
            if (!covers(exclusion, value))
                continue;
            value.isUsed = false;
            isThere = true;
        }
        if (!isThere)
            return wrong(AXISCOMP_TEXT("Error",
                "there is no value {exclusion}: the measurement has {targets} targets, {up} runs "
                "up and {down} runs down")
                             .with("exclusion", exclusionText(exclusion))
                             .with("targets", measurement.targets.size())
                             .with("up", measurement.runCount(Approach::Up))
                             .with("down", measurement.runCount(Approach::Down)));
    }
    return {};
}

Measurement withAllValues(Measurement measurement)
{
    for (RunValue& value : measurement.values)
        value.isUsed = true;
    return measurement;
}

void swapDirections(Measurement& measurement)
{
    const auto swapped = [](Approach direction) {
        return direction == Approach::Up ? Approach::Down : Approach::Up;
    };
    for (RunValue& value : measurement.values)
        value.direction = swapped(value.direction);
    for (TrackSample& sample : measurement.track)
        sample.direction = swapped(sample.direction);
    for (PublishedFigure& figure : measurement.published) {
        if (figure.name == "Bmean")
            figure.value = -figure.value;
        else if (figure.name.ends_with("Up"))
            figure.name.replace(figure.name.size() - 2, 2, "Down");
        else if (figure.name.ends_with("Down"))
            figure.name.replace(figure.name.size() - 4, 4, "Up");
    }
    sortValues(measurement.values);
    measurement.againstFile.swapsDirections = !measurement.againstFile.swapsDirections;
}

Result<Measurement> joined(std::span<const Measurement> measurements)
{
    Measurement whole = measurements.front();
    if (measurements.size() == 1)
        return whole;
    AXISCOMP_CHECK(checkJoinable(measurements));
    whole.header = commonHeader(measurements);
    whole.targets = allTargets(measurements);
    whole.values.clear();
    whole.published.clear();
    for (const Measurement& measurement : measurements) {
        whole.joined.push_back(measurement.header);
        const int runs[] = {whole.lastRun(Approach::Up), whole.lastRun(Approach::Down)};
        for (RunValue value : measurement.values) {
            value.target = targetIndex(whole.targets, measurement.targets[value.target]);
            value.run += runs[static_cast<int>(value.direction)];
            value.line = 0;
            whole.values.push_back(value);
        }
        whole.halfPrintedUnit = std::max(whole.halfPrintedUnit, measurement.halfPrintedUnit);
        if (&measurement != &measurements.front())
            keepDifferences(whole, measurement);
        keepAgainstFile(whole.againstFile, measurement.againstFile);
    }
    keepNumbers(whole, measurements);
    sortValues(whole.values);
    return whole;
}

Result<Measurement> selected(std::span<const Measurement> measurements, bool swapsDirections,
    std::span<const Exclusion> exclusions)
{
    AXISCOMP_TRY(auto whole, joined(measurements));
    if (swapsDirections)
        swapDirections(whole);
    AXISCOMP_CHECK(exclude(whole, exclusions));
    return whole;
}

} // namespace axiscomp
