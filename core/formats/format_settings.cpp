// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/table_format.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

constexpr std::array unitSettings{
    FormatSetting{.key = "position-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = "unit of the positions, where the file does not say it",
        .forReading = true,
        .forWriting = true},
    FormatSetting{.key = "value-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = "unit of the values, where the file does not say it",
        .forReading = true,
        .forWriting = true},
};

bool isFor(const FormatSetting& setting, bool isWriting)
{
    return isWriting ? setting.forWriting : setting.forReading;
}

std::string expectedOf(const FormatSetting& setting)
{
    switch (setting.kind) {
    case FormatSetting::Kind::WholeNumber:
        return "a whole number";
    case FormatSetting::Kind::Number:
        return "a number such as 0.5";
    case FormatSetting::Kind::Choice:
        return "one of " + std::string(setting.choices);
    case FormatSetting::Kind::YesNo:
        return "yes or no";
    case FormatSetting::Kind::Text:
        break;
    }
    return "a text";
}

bool isOneOf(std::string_view choices, std::string_view value)
{
    std::vector<Token> tokens;
    splitTokens({choices, 0, 0}, ", ", tokens);
    return std::ranges::find(tokens, value, &Token::text) != tokens.end();
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

std::string keyList(const std::vector<FormatSetting>& settings)
{
    std::string list;
    for (const FormatSetting& setting : settings)
        list += (list.empty() ? "" : ", ") + std::string(setting.key);
    return list.empty() ? "none" : list;
}

} // namespace

std::vector<FormatSetting> formatSettings(const FormatFacts& facts, bool isWriting)
{
    std::vector<FormatSetting> settings;
    for (const FormatSetting& setting : facts.settings)
        if (isFor(setting, isWriting))
            settings.push_back(setting);
    if (!facts.holdsUnits)
        settings.insert(settings.end(), unitSettings.begin(), unitSettings.end());
    return settings;
}

Result<SettingValues> SettingValues::of(
    const FormatFacts& facts, const FormatSettings& settings, bool isWriting)
{
    const auto refuse = [](std::string reason) {
        return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
    };
    const std::string format(facts.name);
    const std::vector<FormatSetting> known = formatSettings(facts, isWriting);
    for (const auto& [key, value] : settings)
        if (std::ranges::find(known, key, &FormatSetting::key) == known.end())
            return refuse("the format " + format + " has no setting " + key
                + (isWriting ? " for writing" : " for reading") + "; it has: " + keyList(known));
    SettingValues values;
    for (const FormatSetting& setting : known) {
        const auto given = settings.find(setting.key);
        const std::string key(setting.key);
        if (given == settings.end() && setting.isNeeded)
            return refuse("the format " + format + " needs the setting " + key + " ("
                + std::string(setting.meaning) + ")");
        if (given == settings.end() && setting.standard.empty())
            continue;
        const std::string value =
            given == settings.end() ? std::string(setting.standard) : given->second;
        if (!fits(setting, value))
            return refuse("the setting " + key + " is \"" + value + "\", expected "
                + expectedOf(setting) + " (" + std::string(setting.meaning) + ")");
        values.m_values.emplace(key, value);
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

long SettingValues::whole(std::string_view key) const
{
    return wholeNumberOf(text(key)).value_or(0);
}

bool SettingValues::yes(std::string_view key) const
{
    return text(key) == "yes";
}

} // namespace axiscomp
