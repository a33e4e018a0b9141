// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/csv/calibration_csv.h"
#include "core/csv/header.h"
#include "core/io/large_memory.h"
#include "core/table/target_axis.h"
#include "core/text/number_parser.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

namespace axiscomp {

namespace {

/// The shortest text that is read back as the same float32. The reader goes by way of a double,
/// which in rare cases rounds the shortest float32 text twice. shortNumberReach characters behind
/// the buffer's beginning must be there. Writes a comma behind the text, and returns its end.
char* writeValue(float value, char* buffer)
{
    char* end = writeText(value, buffer);
    *end = ',';
    Number read;
    const bool isRead = parseShortNumber(buffer, '.', read) == end
        || parseNumber({buffer, end}, '.', read) == NumberFault::None;
    if (!isRead || static_cast<float>(read.value) != value)
        end = writeText(static_cast<double>(value), buffer);
    *end = ',';
    return end + 1;
}

std::string oneLine(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, ' ');
    return text;
}

/// "X [mm]". A name that would be read as one with a unit is told from its own by empty brackets.
std::string headerText(const std::string& name, const std::string& unit)
{
    std::string text = oneLine(name);
    std::string inBrackets = oneLine(unit);
    std::ranges::replace(inBrackets, '[', '(');
    std::ranges::replace(inBrackets, ']', ')');
    if (!inBrackets.empty() || csv::columnName(text).name != trimmed(text))
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

/// A position and the separator behind it, with room, so that it is copied without asking how long
/// it is.
struct PositionText {
    std::array<char, longestText + 8> text{};
    std::size_t size = 0;

    explicit PositionText(double position)
    {
        char* const end = writeText(position, text.data());
        *end = ',';
        size = static_cast<std::size_t>(end + 1 - text.data());
    }
    char* copyTo(char* to) const
    {
        std::memcpy(to, text.data(), text.size());
        return to + size;
    }
};

/// The lines of the points.
class PointWriter {
public:
    explicit PointWriter(const CalibrationData& data) : m_tables(data.tables)
    {
        for (const GridAxis& axis : data.grid.axes)
            for (std::vector<PositionText>& texts = m_positions.emplace_back();
                 texts.size() < axis.size;)
                texts.emplace_back(axis.position(texts.size()));
    }

    struct Lines {
        std::unique_ptr<char[]> text;
        std::size_t size = 0;
    };
    [[nodiscard]] Lines write(std::size_t firstPoint, std::size_t lastPoint) const
    {
        const std::size_t longestLine = (m_positions.size() + m_tables.size()) * (longestText + 1);
        const std::size_t room =
            (lastPoint - firstPoint) * longestLine + sizeof(PositionText) + shortNumberReach;
        Lines lines{std::make_unique_for_overwrite<char[]>(room), 0};
        char* end = lines.text.get();
        for (std::size_t point = firstPoint; point < lastPoint; ++point)
            end = writeLine(point, end);
        lines.size = static_cast<std::size_t>(end - lines.text.get());
        return lines;
    }

private:
    char* writeLine(std::size_t point, char* end) const
    {
        std::size_t rest = point;
        for (const std::vector<PositionText>& axis : m_positions) {
            end = axis[rest % axis.size()].copyTo(end);
            rest /= axis.size();
        }
        for (const CompensationTable& table : m_tables)
            end = writeValue(table.values[point], end);
        end[-1] = '\n';
        return end;
    }

    const std::vector<CompensationTable>& m_tables;
    std::vector<std::vector<PositionText>> m_positions; ///< per dimension
};

} // namespace

std::string writeCalibrationCsv(const CalibrationData& data, std::size_t threads)
{
    constexpr std::size_t cellsAtOnce = 32768;
    const std::size_t points = data.grid.pointCount();
    const std::size_t pointsAtOnce = 1 + cellsAtOnce / (data.grid.axes.size() + data.tables.size());
    const PointWriter writer(data);
    std::vector<PointWriter::Lines> pieces((points + pointsAtOnce - 1) / pointsAtOnce);
    shareWork(pieces.size(), threads, [&](std::size_t n) {
        pieces[n] = writer.write(n * pointsAtOnce, std::min(points, (n + 1) * pointsAtOnce));
    });
    std::string text = notes(data) + targetLine(data) + headerLine(data);
    std::size_t size = text.size();
    for (const PointWriter::Lines& piece : pieces)
        size += piece.size;
    reserveLarge(text, size);
    for (PointWriter::Lines& piece : pieces) {
        text.append(piece.text.get(), piece.size);
        piece.text.reset();
    }
    return text;
}

} // namespace axiscomp
