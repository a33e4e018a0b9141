// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "core/table/target_axis.h"
#include "core/text/number_parser.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>

namespace axiscomp {

namespace {

/// The shortest text that is read back as the same float32. The reader goes by way of a double,
/// which in rare cases rounds the shortest float32 text twice.
std::string valueText(float value)
{
    std::string text = toText(value);
    Number read;
    const bool same = parseNumber(text, '.', read) == NumberFault::None
        && static_cast<float>(read.value) == value;
    return same ? text : toText(static_cast<double>(value));
}

std::string oneLine(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
    return text;
}

/// "X [mm]". A name that ends in brackets itself is told from its unit by empty brackets.
std::string headerText(const std::string& name, const std::string& unit)
{
    std::string text = oneLine(name);
    std::string inBrackets = oneLine(unit);
    std::ranges::replace(inBrackets, '[', '(');
    std::ranges::replace(inBrackets, ']', ')');
    if (!inBrackets.empty() || trimmed(text).ends_with(']'))
        text += (text.empty() ? "[" : " [") + inBrackets + ']';
    return text;
}

std::string quotedField(const std::string& text)
{
    if (text.find_first_of(",;\"") == std::string::npos && !text.starts_with("//"))
        return text;
    std::string result = "\"";
    for (const char c : text)
        result.append(c == '"' ? 2 : 1, c);
    return result + '"';
}

bool isNumber(const std::string& text)
{
    Number number;
    return parseNumber(trimmed(text), '.', number) != NumberFault::NotANumber
        || parseNumber(trimmed(text), ',', number) != NumberFault::NotANumber;
}

std::string headerLine(const CalibrationData& data)
{
    std::vector<std::string> names;
    for (const GridAxis& axis : data.grid.axes)
        names.push_back(headerText(axis.name, axis.unit));
    for (const CompensationTable& table : data.tables)
        names.push_back(headerText(table.name, table.unit));
    // A line of nothing but numbers is data, a name with brackets is none.
    if (!names.empty() && std::ranges::all_of(names, isNumber))
        names.front() += " []";
    std::string line;
    for (std::size_t i = 0; i < names.size(); ++i)
        line += (i == 0 ? "" : ",") + quotedField(names[i]);
    return line + '\n';
}

std::string notes(const CalibrationData& data)
{
    std::string text;
    for (const std::string& note : data.notes) {
        std::string lines = note;
        std::ranges::replace(lines, '\r', '\n');
        for (std::size_t begin = 0; begin <= lines.size();) {
            const std::size_t end = std::min(lines.find('\n', begin), lines.size());
            text += "// " + oneLine(lines.substr(begin, end - begin)) + '\n';
            begin = end + 1;
        }
    }
    return text;
}

/// The targets, where the names of the columns do not say them.
std::string targetLine(const CalibrationData& data)
{
    std::vector<std::string> headers;
    for (const GridAxis& axis : data.grid.axes)
        headers.push_back(oneLine(axis.name));
    std::vector<std::string> targets;
    bool isNeeded = false;
    for (const CompensationTable& table : data.tables) {
        targets.push_back(portableTarget(table.target, headers));
        isNeeded = isNeeded || targets.back() != targetInHeader(oneLine(table.name), headers);
    }
    if (!isNeeded)
        return {};
    const bool isOne = std::ranges::all_of(
        targets, [&](const std::string& target) { return target == targets.front(); });
    std::string line = "// target: " + targets.front();
    for (std::size_t n = 1; n < targets.size() && !isOne; ++n)
        line += ", " + targets[n];
    return line + '\n';
}

} // namespace

std::string writeCalibrationCsv(const CalibrationData& data)
{
    std::vector<std::vector<std::string>> positions;
    for (const GridAxis& axis : data.grid.axes) {
        positions.emplace_back();
        for (std::uint32_t i = 0; i < axis.size; ++i)
            positions.back().push_back(toText(axis.position(i)));
    }
    std::string text = notes(data) + targetLine(data) + headerLine(data);
    const std::size_t points = data.grid.pointCount();
    for (std::size_t point = 0; point < points; ++point) {
        std::size_t rest = point;
        for (const std::vector<std::string>& axis : positions) {
            text.append(axis[rest % axis.size()]).append(1, ',');
            rest /= axis.size();
        }
        for (const CompensationTable& table : data.tables)
            text.append(valueText(table.values[point])).append(1, ',');
        text.back() = '\n';
    }
    return text;
}

} // namespace axiscomp
