// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/fanuc/pitch_data.h"
#include "core/formats/wrap_range.h"
#include "core/text/number_text.h"

#include <cmath>

namespace axiscomp::fanuc {

namespace {

auto refuseSetting(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

Result<double> numberAboveZero(
    const FormatFacts& facts, const SettingValues& settings, std::string_view key)
{
    AXISCOMP_CHECK(checkAboveZero(facts, key, settings.text(key)));
    return settings.number(key);
}

/// How many sections a turn has.
Result<std::int64_t> sectionsOfTurn(double turn, double interval)
{
    const double count = turn / interval;
    const bool fits = count >= 0.5 && count < static_cast<double>(mostNumbers)
        && std::abs(count - std::round(count)) <= 1e-9 * count;
    if (fits)
        return std::llround(count);
    return refuseSetting(AXISCOMP_TEXT("Error",
        "the setting wrap-range is {turn}, expected 1 to {most} times the interval of {interval}")
                             .with("turn", Quantity{toText(turn)})
                             .with("most", mostNumbers - 1)
                             .with("interval", Quantity{toText(interval)}));
}

} // namespace

Result<std::int64_t> wholeBetween(const FormatFacts& facts, const SettingValues& settings,
    std::string_view key, std::int64_t least, std::int64_t most)
{
    const std::int64_t number = settings.whole(key);
    if (least <= number && number <= most)
        return number;
    return refuseSetting(AXISCOMP_TEXT(
        "Error", "the setting {key} of the format {format} is {value}, expected {least} to {most}")
                             .with("key", key)
                             .with("format", facts.name)
                             .with("value", settings.text(key))
                             .with("least", least)
                             .with("most", most));
}

Result<PitchSetup> pitchSetup(const FormatFacts& facts, const SettingValues& settings)
{
    PitchSetup setup;
    AXISCOMP_TRY(
        setup.reference, wholeBetween(facts, settings, referenceNumberKey, 0, mostNumbers - 1));
    AXISCOMP_TRY(
        setup.firstRecord, wholeBetween(facts, settings, firstRecordKey, 0, 9 * mostNumbers));
    AXISCOMP_TRY(setup.magnification,
        wholeBetween(facts, settings, magnificationKey, 1, largestMagnification));
    setup.position = settings.number(referencePositionKey);
    AXISCOMP_TRY(const double detectionUnit, numberAboveZero(facts, settings, detectionUnitKey));
    // 3 steps of 0.001 are 0.003, and no digits more.
    const double inverse = 1.0 / detectionUnit;
    if (std::isfinite(inverse) && inverse >= 1.0
        && std::abs(inverse - std::round(inverse)) <= 1e-12 * inverse)
        setup.divisor = std::round(inverse);
    else
        setup.multiplier = detectionUnit;
    return setup;
}

Result<PitchSections> pitchSections(
    const FormatFacts& facts, const PitchSetup& setup, const SettingValues& settings)
{
    PitchSections sections;
    AXISCOMP_TRY(sections.interval, numberAboveZero(facts, settings, intervalKey));
    for (const auto& [key, number] :
        {std::pair(firstNumberKey, &sections.first), std::pair(lastNumberKey, &sections.last)}) {
        if (!settings.has(key))
            continue;
        AXISCOMP_TRY(*number, wholeBetween(facts, settings, key, 0, mostNumbers - 1));
    }
    if (!settings.has(wrapRangeKey))
        return sections;
    if (sections.first || sections.last)
        return refuseSetting(AXISCOMP_TEXT(
            "Error", "wrap-range says which numbers a rotary axis has; leave {key} and {key2} out")
                                 .with("key", firstNumberKey)
                                 .with("key2", lastNumberKey));
    sections.turn = settings.number(wrapRangeKey);
    AXISCOMP_TRY(const auto count, sectionsOfTurn(*sections.turn, sections.interval));
    sections.first = setup.reference + 1;
    sections.last = setup.reference + count;
    return sections;
}

} // namespace axiscomp::fanuc
