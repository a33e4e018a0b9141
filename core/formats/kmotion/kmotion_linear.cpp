// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/formats/formats.h"
#include "core/formats/own_axis.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::kmotion_linear {

namespace {

constexpr std::size_t mostPositions = 1'000'000;

constexpr std::array<std::string_view, 1> extensions{".txt"};
constexpr std::array<std::string_view, 4> rules{
    "A line each for the number of positions, the size of a range and the first position; then the "
    "positions that must be commanded to reach start + i * size.",
    "N ranges have N + 1 positions.",
    "Between the positions the correction is linear.",
    "It is applied after the geometric correction.",
};
constexpr std::array<std::string_view, 4> assumptions{
    "A line holds the index of the position, from 0, and the position, as an excerpt of the page "
    "shows; lines of the position alone are read as well.",
    "Outside of the table the correction at that end is held; the page says that an axis may go on "
    "for ever, and not how.",
    "Positions increase: what does not is likely a list of corrections, and refused.",
    "The unit is the user unit of the axis, which the file does not say.",
};

/// The lines of the file that say something.
class Lines {
public:
    explicit Lines(std::string_view text) : m_lines(text) { }
    [[nodiscard]] std::optional<Token> next()
    {
        while (const auto line = m_lines.next())
            if (const Token content = trimmedToken(*line))
                return content;
        return std::nullopt;
    }

private:
    TextLines m_lines;
};

struct Header {
    std::size_t count = 0;
    std::size_t countLine = 0;
    double size = 0.0;
    double start = 0.0;
};

std::optional<Header> readHeader(Lines& lines, DiagnosticList& diagnostics)
{
    std::array<Token, 3> tokens;
    for (Token& token : tokens) {
        const auto line = lines.next();
        if (!line) {
            diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
                AXISCOMP_TEXT("Error",
                    "a line each for the number of positions, the size of a range and the first "
                    "position"));
            return std::nullopt;
        }
        token = *line;
    }
    const auto count =
        readWholeNumber(tokens[0], AXISCOMP_TEXT("Error", "a number of positions"), diagnostics);
    const auto size =
        readNumber(tokens[1], AXISCOMP_TEXT("Error", "the size of a range"), diagnostics);
    const auto start =
        readNumber(tokens[2], AXISCOMP_TEXT("Error", "the first position"), diagnostics);
    if (!count || !size || !start)
        return std::nullopt;
    if (*count < 2 || *count > static_cast<std::int64_t>(mostPositions))
        diagnostics.error(DiagnosticCode::LimitExceeded, tokens[0].line, tokens[0].column,
            AXISCOMP_COUNTED("Error", "{count} positions", "1 position").with("count", *count),
            AXISCOMP_TEXT("Error", "{number} to {number2}")
                .with("number", 2)
                .with("number2", mostPositions));
    if (!(*size > 0.0))
        diagnostics.error(DiagnosticCode::LimitExceeded, tokens[1].line, tokens[1].column,
            AXISCOMP_TEXT("Error", "a range of {size}").with("size", Quantity{toText(*size)}),
            AXISCOMP_TEXT("Error", "more than 0"));
    if (diagnostics.hasErrors())
        return std::nullopt;
    return Header{static_cast<std::size_t>(*count), tokens[0].line, *size, *start};
}

struct Positions {
    std::vector<double> values;
    std::vector<std::size_t> lines;
    std::size_t width = 0; ///< of each line: index and position, or the position alone
};

/// "3,-174.1", or the position alone.
void takeLine(const Token& line, Positions& positions, DiagnosticList& diagnostics)
{
    std::vector<Token> cells;
    splitCells(line, ',', cells);
    const std::size_t index = positions.values.size();
    if (cells.size() > 2) {
        diagnostics.error(DiagnosticCode::ColumnCount, line.line, 0,
            AXISCOMP_COUNTED("Error", "{count} numbers", "1 number").with("count", cells.size()),
            AXISCOMP_TEXT("Error", "index and position, or the position alone"));
        return;
    }
    if (positions.width == 0)
        positions.width = cells.size();
    if (cells.size() != positions.width) // an index alone, where the file is cut off
        diagnostics.error(DiagnosticCode::ColumnCount, line.line, 0,
            AXISCOMP_COUNTED("Error", "{count} numbers", "1 number").with("count", cells.size()),
            AXISCOMP_TEXT("Error", "{number}, as in the first row")
                .with("number", positions.width));
    if (cells.size() == 2) {
        const auto said =
            readWholeNumber(cells[0], AXISCOMP_TEXT("Error", "an index from 0"), diagnostics);
        if (said && *said != static_cast<std::int64_t>(index))
            diagnostics.error(DiagnosticCode::Contradiction, line.line, cells[0].column,
                AXISCOMP_TEXT("Error", "the index {number}").with("number", *said),
                AXISCOMP_TEXT("Error", "{number}: indices count from 0 in the order of the lines")
                    .with("number", index));
    }
    positions.values.push_back(
        readNumber(cells.back(), AXISCOMP_TEXT("Error", "a position to command"), diagnostics)
            .value_or(0.0));
    positions.lines.push_back(line.line);
}

bool checkPositions(const Header& header, const Positions& positions, DiagnosticList& diagnostics)
{
    if (positions.values.size() != header.count) {
        diagnostics.error(positions.values.size() < header.count ? DiagnosticCode::MissingPoint
                                                                 : DiagnosticCode::Contradiction,
            header.countLine, 0,
            AXISCOMP_COUNTED("Error", "{count} positions", "1 position")
                .with("count", positions.values.size()),
            AXISCOMP_TEXT("Error", "{value}, as the first line says").with("value", header.count));
        return false;
    }
    for (std::size_t i = 1; i < header.count; ++i)
        if (!(positions.values[i] > positions.values[i - 1])) {
            diagnostics.error(DiagnosticCode::NotMonotonic, positions.lines[i], 0,
                AXISCOMP_TEXT("Error", "{number} after {number2}")
                    .with("number", Quantity{toText(positions.values[i])})
                    .with("number2", Quantity{toText(positions.values[i - 1])}),
                AXISCOMP_TEXT("Error",
                    "strictly increasing positions to command; a list of corrections is no such "
                    "file"));
            return false;
        }
    // Positions to command are near those that are reached; corrections are near 0.
    const std::vector<double> reached = evenKnots(header.start, header.size, header.count);
    for (std::size_t i = 0; i < header.count; ++i) {
        if (std::abs(positions.values[i] - reached[i]) <= header.size / 2)
            continue;
        diagnostics.error(DiagnosticCode::Contradiction, positions.lines[i], 0,
            AXISCOMP_TEXT("Error", "{number} to command, to reach {number2}")
                .with("number", Quantity{toText(positions.values[i])})
                .with("number2", Quantity{toText(reached[i])}),
            AXISCOMP_TEXT(
                "Error", "at most half a range away; a list of corrections is no such file"));
        return false;
    }
    return true;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    DiagnosticList& diagnostics = reading.diagnostics;
    Lines lines(reading.text);
    const auto header = readHeader(lines, diagnostics);
    if (!header)
        return {};
    Positions positions;
    while (const auto line = lines.next()) {
        if (reading.isStopped())
            return {};
        takeLine(*line, positions, diagnostics);
    }
    if (diagnostics.hasErrors() || !checkPositions(*header, positions, diagnostics))
        return {};
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes.resize(1);
    table.columns.resize(1);
    table.axes[0].knots = evenKnots(header->start, header->size, header->count);
    for (std::size_t i = 0; i < header->count; ++i)
        table.columns[0].values.push_back(positions.values[i] - table.axes[0].knots[i]);
    takeOneUnit(table, reading.settings, diagnostics);
    return {std::move(table)};
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(kmotion_linear::format().facts, text, options, parse);
}

/// Three lines of one number, and then as many lines "index,position" as the first one says.
Recognition recognise(std::string_view text)
{
    Lines lines(text);
    std::array<std::optional<Token>, 3> header;
    for (auto& token : header) {
        token = lines.next();
        if (!token || !numberOf(token->text))
            return Recognition::No;
    }
    const std::int64_t count = wholeNumberOf(header[0]->text).value_or(0);
    std::vector<Token> cells;
    std::int64_t index = 0;
    auto line = lines.next();
    for (auto following = lines.next(); line; line = following, following = lines.next()) {
        splitCells(*line, ',', cells);
        const bool isRow =
            cells.size() == 2 && wholeNumberOf(cells[0].text) == index && numberOf(cells[1].text);
        if (isRow)
            ++index;
        else if (following || text.size() < longestBeginning) // the last line may be cut off
            return Recognition::No;
    }
    const bool fits = text.size() < longestBeginning ? index == count : index <= count;
    return count >= 2 && index > 0 && fits ? Recognition::Certain : Recognition::No;
}

Result<void> checkWritable(const FormatFacts& facts, const NeutralTable& table)
{
    const std::vector<double>& knots = table.axes[0].knots;
    const std::vector<double>& values = table.columns[0].values;
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (!(knots[i] + values[i] > knots[i - 1] + values[i - 1]))
            return cannotHold(facts,
                AXISCOMP_TEXT("Error",
                    "at {position} the position to command, {sum}, is not larger than the one "
                    "before, {before}")
                    .with("position", Quantity{toText(knots[i])})
                    .with("sum", Quantity{roundedText(knots[i] + values[i])})
                    .with("before", Quantity{roundedText(knots[i - 1] + values[i - 1])}),
                AXISCOMP_TEXT("Error", "check the unit of the values, or smooth them"));
    return {};
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = kmotion_linear::format().facts;
    AXISCOMP_TRY(const auto values, SettingValues::of(facts, options.settings, true));
    WrittenTables written;
    AXISCOMP_TRY(const auto table, asOwnAxisTable(facts, tables.front(), values, written.remarks));
    AXISCOMP_CHECK(checkWritable(facts, table));
    const std::vector<double>& knots = table.axes[0].knots;
    const double size = (knots.back() - knots.front()) / static_cast<double>(knots.size() - 1);
    const std::vector<double> places = evenKnots(knots.front(), size, knots.size());
    written.bytes =
        std::to_string(places.size()) + '\n' + toText(size) + '\n' + toText(places.front()) + '\n';
    for (std::size_t i = 0; i < places.size(); ++i)
        written.bytes +=
            std::to_string(i) + ',' + toText(places[i] + table.columns[0].values[i]) + '\n';
    FormatSettings reading;
    if (!table.axes[0].unit.empty())
        reading["position-unit"] = table.axes[0].unit;
    AXISCOMP_TRY(auto held, readBack(kmotion_linear::format(), written.bytes, std::move(reading)));
    written.held = std::move(held);
    written.remarks.emplace_back(AXISCOMP_TEXT("Error",
        "the file holds positions to command, not corrections; KMotionCNC applies them after the "
        "geometric correction"));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "kmotion-linear",
            .controller = "KFLOP, KMotion (Dynomotion)",
            .description = AXISCOMP_TEXT("Error", "linear table of one axis: positions to command"),
            .extensions = extensions,
            .knots = KnotRule::Even,
            .mostPoints = mostPositions,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Hold},
            .outsideEvidence = Evidence::Assumed,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::kmotion_linear
