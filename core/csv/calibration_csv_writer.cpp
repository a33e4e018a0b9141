// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/csv/calibration_csv.h"
#include "core/csv/header.h"
#include "core/csv/value_writer.h"
#include "core/io/large_memory.h"
#include "core/table/target_axis.h"
#include "core/text/number_parser.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>

namespace axiscomp {

namespace {

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

std::vector<std::string> noteLines(const CalibrationData& data)
{
    std::vector<std::string> result;
    for (const std::string& note : data.notes) {
        std::string lines = note;
        std::ranges::replace(lines, '\r', '\n');
        for (std::size_t begin = 0; begin <= lines.size();) {
            const std::size_t end = std::min(lines.find('\n', begin), lines.size());
            result.push_back(oneLine(lines.substr(begin, end - begin)));
            begin = end + 1;
        }
    }
    return result;
}

bool statesTarget(const std::string& note)
{
    return targetInComment(trimmed(note)).has_value();
}

/// The targets, where the names of the columns do not say them, or notes would say others.
std::string targetLine(const CalibrationData& data, bool hasOtherStatement)
{
    std::vector<std::string> headers;
    for (const GridAxis& axis : data.grid.axes)
        headers.push_back(oneLine(axis.name));
    std::vector<std::string> targets;
    bool isNeeded = false;
    for (const CompensationTable& table : data.tables) {
        const std::string name = oneLine(table.name);
        // Where nothing is stated a reader takes what the name says.
        const std::string target =
            statedOrInHeader(portableTarget(table.target, headers), name, headers);
        isNeeded = isNeeded || target != targetInHeader(name, headers)
            || (hasOtherStatement && !target.empty());
        targets.push_back(target);
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

/// The notes and the targets, which no note contradicts.
std::string comments(const CalibrationData& data)
{
    const std::vector<std::string> notes = noteLines(data);
    const std::string targets = targetLine(data, std::ranges::any_of(notes, statesTarget));
    std::string text;
    for (const std::string& note : notes)
        text += "// " + (!targets.empty() && statesTarget(note) ? mereNote(note) : note) + '\n';
    return text + targets;
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

    /// What so many lines may need.
    [[nodiscard]] std::size_t roomFor(std::size_t points) const
    {
        const std::size_t longestLine = (m_positions.size() + m_tables.size()) * (longestText + 1);
        return points * longestLine + sizeof(PositionText) + shortNumberReach;
    }
    [[nodiscard]] std::string_view write(
        std::size_t firstPoint, std::size_t lastPoint, char* room) const
    {
        char* end = room;
        csv::ValueWriter values;
        for (std::size_t point = firstPoint; point < lastPoint; ++point)
            end = writeLine(point, values, end);
        return {room, static_cast<std::size_t>(end - room)};
    }

private:
    char* writeLine(std::size_t point, csv::ValueWriter& values, char* end) const
    {
        std::size_t rest = point;
        for (const std::vector<PositionText>& axis : m_positions) {
            end = axis[rest % axis.size()].copyTo(end);
            rest /= axis.size();
        }
        for (const CompensationTable& table : m_tables)
            end = values.write(table.values[point], end);
        end[-1] = '\n';
        return end;
    }

    const std::vector<CompensationTable>& m_tables;
    std::vector<std::vector<PositionText>> m_positions; ///< per dimension
};

/// A text of pieces that are made beside each other, each put behind the one before it.
class OrderedPieces {
public:
    OrderedPieces(std::string& text, std::size_t count) : m_text(text), m_count(count) { }

    /// Returns when all pieces before this one have their places, and this one has.
    void append(std::size_t n, std::string_view piece)
    {
        std::unique_lock lock(m_mutex);
        m_turn.wait(lock, [&] { return m_next == n; });
        ++m_next; // whether there is memory for this one or not: no other waits for ever
        m_turn.notify_all();
        if (n == 0) // the others are about as long
            reserveLarge(m_text, m_text.size() + piece.size() * (m_count + m_count / 16 + 1));
        m_text.append(piece);
    }

private:
    std::string& m_text;
    std::size_t m_count;
    std::mutex m_mutex;
    std::condition_variable m_turn;
    std::size_t m_next = 0;
};

} // namespace

std::string writeCalibrationCsv(const CalibrationData& data, std::size_t threads)
{
    constexpr std::size_t cellsAtOnce = 32768;
    const std::size_t points = data.grid.pointCount();
    const std::size_t pointsAtOnce = 1 + cellsAtOnce / (data.grid.axes.size() + data.tables.size());
    const PointWriter writer(data);
    const std::size_t pieceCount = (points + pointsAtOnce - 1) / pointsAtOnce;
    if (threads == 0)
        threads = processorCount();
    // They end in their order, so that one of them begins where the last one to use its room has.
    std::vector<std::unique_ptr<char[]>> rooms(std::min(threads, pieceCount));
    for (std::unique_ptr<char[]>& room : rooms)
        room =
            std::make_unique_for_overwrite<char[]>(writer.roomFor(std::min(points, pointsAtOnce)));
    std::string text = comments(data) + headerLine(data);
    OrderedPieces pieces(text, pieceCount);
    shareWork(pieceCount, threads, [&](std::size_t n) {
        pieces.append(n,
            writer.write(n * pointsAtOnce, std::min(points, (n + 1) * pointsAtOnce),
                rooms[n % rooms.size()].get()));
    });
    return text;
}

} // namespace axiscomp
