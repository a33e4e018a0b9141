// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/rapidcode/rapidcode_table.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <array>

namespace axiscomp::rapidcode_header {

namespace {

constexpr std::array<std::string_view, 1> extensions{".h"};
constexpr std::array settings{
    FormatSetting{.key = "counts-per-unit",
        .kind = FormatSetting::Kind::Number,
        .meaning =
            AXISCOMP_TEXT("Error", "raw counts of the output axis for one unit of the values"),
        .forWriting = true,
        .isNeeded = true},
    FormatSetting{.key = "name",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error", "namespace of the constants, a C++ name"),
        .standard = "compensator",
        .forWriting = true},
};
constexpr std::array<std::string_view, 4> rules{
    "The constants are what CompensatorConfigSet takes: minimum, maximum and delta of 1 or 2 input "
    "axes, and the table, the first axis fastest.",
    "maximum - minimum is an integer multiple of delta, and there are (maximum - minimum) / delta "
    "+ 1 points; with two input axes as many as the product of both.",
    "The values are raw counts of the output axis, which are added to the position right before "
    "it is sent to the drive.",
    "An axis can be input and output only with its command position as the input.",
};
constexpr std::array<std::string_view, 3> assumptions{
    "Minimum, maximum and delta are in user units of the input axes.",
    "Outside of the range there is no correction.",
    "Counts are whole numbers, at most 2147483647.",
};

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isCppName(std::string_view name)
{
    constexpr std::array<std::string_view, 14> taken{"bool", "class", "const", "constexpr",
        "default", "double", "float", "int", "long", "namespace", "new", "short", "struct", "this"};
    return !name.empty() && isLetter(name.front())
        && std::ranges::all_of(name, [](char c) { return isLetter(c) || (c >= '0' && c <= '9'); })
        && std::ranges::find(taken, name) == taken.end();
}

std::string quoted(const std::string& name)
{
    return '"' + oneLine(name) + '"';
}

/// Comments for the person who writes the call.
std::string explanation(const RapidCodeTable& table)
{
    const CompensationColumn& column = table.held.columns.front();
    std::string inputs;
    for (const SourceAxis& axis : table.held.axes)
        inputs += (inputs.empty() ? "" : ", ") + quoted(axis.name) + " in user units"
            + (axis.unit.empty() ? "" : " (" + oneLine(axis.unit) + ")");
    std::string text = "// Table of a RapidCode compensator, for CompensatorConfigSet.\n";
    text += "// Input: " + inputs + ".\n";
    text += "// Output: " + quoted(column.target) + " in raw counts, " + toText(table.countsPerUnit)
        + " for 1 " + (column.unit.empty() ? "unit" : oneLine(column.unit)) + ".\n";
    return text + "// Note: " + rapidCodeInputAdvice(table).english() + ".\n";
}

std::string constant(std::string_view type, const std::string& name, const std::string& value)
{
    return "constexpr " + std::string(type) + ' ' + name + " = " + value + ";\n";
}

std::string tableText(const RapidCodeTable& table)
{
    constexpr std::size_t most = 16; // in a line
    const std::size_t columns = table.inputs[0].points;
    std::string text = "// The first axis changes fastest.\n";
    text += "constexpr double table[points] = {\n";
    for (std::size_t i = 0; i < table.counts.size(); ++i) {
        const std::size_t inRow = i % columns;
        const bool endsLine = inRow + 1 == columns || (inRow + 1) % most == 0;
        text += (inRow % most == 0 ? "    " : " ") + std::to_string(table.counts[i]) + ','
            + (endsLine ? "\n" : "");
    }
    return text + "};\n";
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = rapidcode_header::format().facts;
    AXISCOMP_TRY(const auto values, SettingValues::of(facts, options.settings, true));
    const std::string name = values.text("name");
    if (!isCppName(name))
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the setting name is \"{name}\", expected a C++ name: letters, digits and _")
                    .with("name", name)}});
    WrittenTables written;
    AXISCOMP_TRY(auto table, rapidCodeTable(facts, tables.front(), values, written.remarks));
    std::string& text = written.bytes;
    text = explanation(table) + "#pragma once\n\nnamespace " + name + " {\n\n";
    constexpr std::array<const char*, 2> ordinals{"first", "second"};
    for (std::size_t n = 0; n < table.inputs.size(); ++n) {
        const RapidCodeInput& input = table.inputs[n];
        const std::string ordinal = ordinals[n];
        text += constant("double", ordinal + "Minimum", toText(input.minimum));
        text += constant("double", ordinal + "Maximum", toText(input.maximum));
        text += constant("double", ordinal + "Delta", toText(input.delta));
        text += constant("int", ordinal + "Points", std::to_string(input.points)) + '\n';
    }
    text += constant("int", "points", std::to_string(table.counts.size())) + '\n';
    text += tableText(table) + "\n} // namespace " + name + '\n';
    written.held.push_back(std::move(table.held));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "rapidcode-header",
            .controller = "RSI RapidCode (RMP)",
            .description = AXISCOMP_TEXT("Error", "C++ header with the table of a compensator"),
            .extensions = extensions,
            .mostDimensions = 2,
            .knots = KnotRule::Even,
            .mostPoints = rapidCodeMostPoints,
            .numbers = "whole counts of the output axis",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Zero},
            .outsideEvidence = Evidence::Assumed,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .write = write};
    return format;
}

} // namespace axiscomp::rapidcode_header
