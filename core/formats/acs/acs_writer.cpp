// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/acs/acs_program.h"

#include <algorithm>

namespace axiscomp::acs {

namespace {

/// Words that mean something else in a program that maps an array.
constexpr std::array<std::string_view, 33> reservedWords{"GLOBAL", "LOCAL", "STATIC", "REAL", "INT",
    "AXISDEF", "CONNECT", "DEPENDS", "RPOS", "APOS", "MFLAGS", "MAP", "MAP2", "MAPN", "MAPB",
    "MAPS", "STOP", "RET", "IF", "ELSE", "ELSEIF", "LOOP", "WHILE", "BLOCK", "SWITCH", "CASE",
    "DEFAULT", "END", "ON", "ERRORMAP1D", "ERRORMAPON", "ERRORMAPOFF", "ERRORUNMAP"};

bool isArrayName(std::string_view name)
{
    return isName(name) && name.front() != '_'
        && std::ranges::none_of(
            reservedWords, [&](std::string_view word) { return sameLetters(name, word); });
}

} // namespace

Result<std::string> nameOfArray(const FormatFacts& facts, const SettingValues& settings)
{
    std::string name = settings.text(arrayName.key);
    if (isArrayName(name))
        return name;
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "\"{name}\" is no name for an array of the format {format}, such as {example}; "
                "change the setting {key}")
                .with("name", name)
                .with("format", facts.name)
                .with("example", arrayName.standard)
                .with("key", arrayName.key)}});
}

Result<std::int64_t> numberFromZero(
    const FormatFacts& facts, const SettingValues& settings, std::string_view key)
{
    const std::int64_t number = settings.whole(key);
    if (number >= 0)
        return number;
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "the setting {key} of the format {format} is {value}; it is a number from 0")
                .with("key", key)
                .with("format", facts.name)
                .with("value", settings.text(key))}});
}

std::string gridArguments(const SourceAxis& axis)
{
    return plainNumber(axis.knots.front()) + ", " + plainNumber(evenDistance(axis));
}

std::string arrayLines(
    const NeutralTable& table, const std::string& name, std::size_t indices, bool isDeclared)
{
    const std::size_t columns = table.axes.front().knots.size();
    const auto indexText = [&](std::size_t row, std::size_t column) {
        std::string text = '(' + std::to_string(column) + ')';
        return indices == 2 ? '(' + std::to_string(row) + ')' + text : text;
    };
    std::string text = noteLines(table, "! ");
    if (isDeclared)
        text += "GLOBAL REAL STATIC " + name
            + indexText(indices == 2 ? table.axes[1].knots.size() : 0, columns) + '\n';
    const std::vector<double>& values = table.columns.front().values;
    for (std::size_t i = 0; i < values.size(); ++i)
        text += name + indexText(i / columns, i % columns) + " = " + plainNumber(values[i]) + '\n';
    return text;
}

void remarkOnArray(const std::string& name, bool isDeclared, std::vector<Text>& remarks)
{
    remarks.push_back((isDeclared
            ? AXISCOMP_TEXT("Error",
                "the controller must not have declared the array {name} before, since the "
                "program declares it; where it has, set declare=no")
            : AXISCOMP_TEXT("Error",
                "the controller must have declared the array {name}, with as many elements as the "
                "program gives it"))
                          .with("name", name));
}

} // namespace axiscomp::acs
