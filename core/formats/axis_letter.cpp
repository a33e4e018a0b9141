// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/axis_letter.h"

#include "core/table/target_axis.h"
#include "core/text/token_scanner.h"

namespace axiscomp {

namespace {

/// Empty: none of them.
std::string letterOf(std::string_view name, std::string_view letters)
{
    if (name.size() != 1)
        return {};
    for (const char letter : letters)
        if (sameLetters(name, std::string_view(&letter, 1)))
            return std::string(1, letter);
    return {};
}

} // namespace

Result<std::string> axisLetter(const FormatFacts& facts, const SettingValues& settings,
    std::string_view key, const std::string& name, std::string_view letters)
{
    const auto refuse = [&](Text reason) {
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                std::move(reason)
                    .with("format", facts.name)
                    .with("key", key)
                    .with("letters", letters)
                    .with("name", name)
                    .with("value", settings.text(key))}});
    };
    if (!settings.has(key)) {
        std::string letter = letterOf(name, letters);
        if (letter.empty())
            return refuse(AXISCOMP_TEXT("Error",
                "the format {format} names its axes by one of the letters {letters}, and the axis "
                "name is \"{name}\"; give the setting {key}"));
        return letter;
    }
    std::string letter = letterOf(settings.text(key), letters);
    if (letter.empty())
        return refuse(AXISCOMP_TEXT("Error",
            "the format {format} names its axes by one of the letters {letters}; the setting {key} "
            "is {value}"));
    if (areDifferentAxes(name, letter))
        return refuse(AXISCOMP_TEXT("Error",
            "the table is of axis \"{name}\", and the setting {key} of the format {format} says "
            "{value}"));
    return letter;
}

} // namespace axiscomp
