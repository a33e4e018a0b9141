// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/table_format.h"
#include "core/table/position_unit.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

constexpr std::array unitSettings{
    FormatSetting{.key = "position-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error", "unit of the positions, where the file does not say it"),
        .forReading = true,
        .forWriting = true},
    FormatSetting{.key = "value-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error", "unit of the values, where the file does not say it"),
        .forReading = true,
        .forWriting = true},
};

bool isAmong(std::span<const FormatSetting> settings, std::string_view key)
{
    return std::ranges::find(settings, key, &FormatSetting::key) != settings.end();
}

tl::unexpected<Error> unusableSetting(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

bool isFor(const FormatSetting& setting, bool isWriting)
{
    return isWriting ? setting.forWriting : setting.forReading;
}

Text expectedOf(const FormatSetting& setting)
{
    switch (setting.kind) {
    case FormatSetting::Kind::WholeNumber:
        return AXISCOMP_TEXT("Error", "a whole number");
    case FormatSetting::Kind::Number:
        return AXISCOMP_TEXT("Error", "a number such as {example}")
            .with("example", Verbatim{"0.5"});
    case FormatSetting::Kind::Choice:
        return AXISCOMP_TEXT("Error", "one of {choices}").with("choices", setting.choices);
    case FormatSetting::Kind::YesNo:
        return AXISCOMP_TEXT("Error", "yes or no");
    case FormatSetting::Kind::Text:
        break;
    }
    return AXISCOMP_TEXT("Error", "a text");
}

std::vector<Token> listed(std::string_view words)
{
    std::vector<Token> tokens;
    splitTokens({words, 0, 0}, ", ", tokens);
    return tokens;
}

bool isOneOf(std::string_view choices, std::string_view value)
{
    const std::vector<Token> tokens = listed(choices);
    return std::ranges::find(tokens, value, &Token::text) != tokens.end();
}

bool isMissing(const FormatSetting& setting, const FormatSettings& given)
{
    const auto isGiven = [&given](std::string_view key) { return given.find(key) != given.end(); };
    const std::vector<Token> others = listed(setting.unless);
    const bool isReplaced = !others.empty() && std::ranges::all_of(others, isGiven, &Token::text);
    return setting.isNeeded && !isReplaced && !isGiven(setting.key);
}

bool fits(const FormatSetting& setting, std::string_view value)
{
    switch (setting.kind) {
    case FormatSetting::Kind::WholeNumber:
        return wholeNumberOf(value).has_value();
    case FormatSetting::Kind::Number:
        return numberOf(value).has_value();
    case FormatSetting::Kind::Choice:
        return isOneOf(setting.choices, value);
    case FormatSetting::Kind::YesNo:
        return value == "yes" || value == "no";
    case FormatSetting::Kind::Text:
        break;
    }
    return !value.empty();
}

Argument keyList(const std::vector<FormatSetting>& settings)
{
    if (settings.empty())
        return AXISCOMP_TEXT("Error", "none");
    std::vector<std::string> keys;
    for (const FormatSetting& setting : settings)
        keys.emplace_back(setting.key);
    return keys;
}

} // namespace

bool takesAnyUnits(const FormatFacts& facts)
{
    const auto isOfUnits = [](const FormatSetting& setting) {
        return isAmong(unitSettings, setting.key);
    };
    return !facts.holdsUnits && std::ranges::none_of(facts.settings, isOfUnits);
}

std::vector<FormatSetting> formatSettings(const FormatFacts& facts, bool isWriting)
{
    std::vector<FormatSetting> settings;
    for (const FormatSetting& setting : facts.settings)
        if (isFor(setting, isWriting))
            settings.push_back(setting);
    if (takesAnyUnits(facts))
        settings.insert(settings.end(), unitSettings.begin(), unitSettings.end());
    return settings;
}

Result<FormatSettings> withStatedUnits(
    const FormatFacts& facts, FormatSettings settings, const StatedUnits& stated)
{
    const std::vector<FormatSetting> known = formatSettings(facts, false);
    const auto state = [&](std::string_view key, const std::string& unit) -> Result<void> {
        if (unit.empty() || !isAmong(known, key))
            return {};
        const auto given = settings.find(key);
        if (given != settings.end() && !isSameUnit(given->second, unit))
            return unusableSetting(AXISCOMP_TEXT("Error",
                "the unit {stated} is stated, and the setting {key} says {unit}; leave one of them "
                "out")
                                       .with("stated", unit)
                                       .with("key", key)
                                       .with("unit", given->second));
        if (unit != unitOfDrive)
            settings.emplace(key, unit);
        return {};
    };
    AXISCOMP_CHECK(state("position-unit", stated.positions));
    AXISCOMP_CHECK(state("value-unit", stated.values));
    return settings;
}

Result<SettingValues> SettingValues::of(
    const FormatFacts& facts, const FormatSettings& settings, bool isWriting)
{
    const std::vector<FormatSetting> known = formatSettings(facts, isWriting);
    for (const auto& [key, value] : settings) {
        if (!isAmong(known, key))
            return unusableSetting((isWriting
                    ? AXISCOMP_TEXT("Error",
                        "the format {format} has no setting {key} for writing; it has: {known}")
                    : AXISCOMP_TEXT("Error",
                        "the format {format} has no setting {key} for reading; it has: {known}"))
                                       .with("format", facts.name)
                                       .with("key", key)
                                       .with("known", keyList(known)));
        if (isAmong(unitSettings, key) && value == unitOfDrive)
            return unusableSetting(AXISCOMP_TEXT("Error",
                "the setting {key} is \"{value}\", expected a unit; that numbers are in the unit "
                "of "
                "the drive is stated as {option} of {command}, or as {key} beside the settings of "
                "a machine file")
                                       .with("key", key)
                                       .with("value", value)
                                       .with("option", Verbatim{"--" + key})
                                       .with("command", Verbatim{"axiscomp write"}));
    }
    SettingValues values;
    for (const FormatSetting& setting : known) {
        const auto given = settings.find(setting.key);
        if (isMissing(setting, settings))
            return unusableSetting(
                AXISCOMP_TEXT("Error", "the format {format} needs the setting {key} ({meaning})")
                    .with("format", facts.name)
                    .with("key", setting.key)
                    .with("meaning", setting.meaning));
        if (given == settings.end() && setting.standard.empty())
            continue;
        const std::string value =
            given == settings.end() ? std::string(setting.standard) : given->second;
        if (!fits(setting, value))
            return unusableSetting(AXISCOMP_TEXT(
                "Error", "the setting {key} is \"{value}\", expected {expected} ({meaning})")
                                       .with("key", setting.key)
                                       .with("value", value)
                                       .with("expected", expectedOf(setting))
                                       .with("meaning", setting.meaning));
        values.m_values.emplace(setting.key, value);
    }
    return values;
}

bool SettingValues::has(std::string_view key) const
{
    return m_values.find(key) != m_values.end();
}

std::string SettingValues::text(std::string_view key) const
{
    const auto found = m_values.find(key);
    return found == m_values.end() ? std::string() : found->second;
}

double SettingValues::number(std::string_view key) const
{
    return numberOf(text(key)).value_or(0.0);
}

std::int64_t SettingValues::whole(std::string_view key) const
{
    return wholeNumberOf(text(key)).value_or(0);
}

bool SettingValues::yes(std::string_view key) const
{
    return text(key) == "yes";
}

Result<void> checkAboveZero(
    const FormatFacts& facts, std::string_view key, const std::string& value)
{
    if (numberOf(value).value_or(0.0) > 0.0)
        return {};
    return unusableSetting(AXISCOMP_TEXT(
        "Error", "the setting {key} of the format {format} is {value}, expected a number above 0")
                               .with("key", key)
                               .with("format", facts.name)
                               .with("value", value));
}

} // namespace axiscomp
