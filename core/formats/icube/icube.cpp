// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/header.h"
#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/formats/formats.h"
#include "core/formats/own_axis.h"
#include "core/formats/wrap_range.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::icube {

namespace {

constexpr std::string_view invalidFormat = "4900";
constexpr std::string_view wrongRange = "4902";
constexpr TextPattern twoNumbers =
    AXISCOMP_TEXT("Error", "two numbers such as 0.25,0.001: position and offset");

constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array settings{wrapRangeSetting};
constexpr std::array<std::string_view, 10> rules{
    "Each line is a position and the offset there, both in user units of the axis. The offset is "
    "added to the commanded position.",
    "The numbers stand between commas, semicolons, tabs or blanks; a comma is written.",
    "Leading lines that are not two numbers are headers; there need be none.",
    "Positions go strictly in one direction, up or down, and need not be evenly spaced; position + "
    "offset goes in the same direction (otherwise error 4900, invalid format).",
    "Between the points the offset is linear.",
    "Outside of the table the offset at that end is held.",
    "Of a rotary axis the positions span its wrap range exactly, and the first offset is the last "
    "one (otherwise error 4902).",
    "The file is smaller than 1 MB.",
    "Parameter 1020 of the axis is the commanded position with the compensation in it.",
    "Without a path in axis.xml the file is looked for under the name of the axis followed by "
    "PosComp.CSV, such as Axis1PosComp.CSV; error 4899: it was not found.",
};
constexpr std::array<std::string_view, 3> assumptions{
    "The example on the page of the manual gives an offset at -4.00 that contradicts the rule for "
    "positions outside of the table: the rule is followed, also at -3.999.",
    "Two equal values of position + offset are refused as well.",
    "Empty lines between the points are skipped.",
};

/// The pieces of a line between semicolons, else commas, else blanks.
void splitRow(const Token& line, std::vector<Token>& cells)
{
    if (line.text.find(';') != std::string_view::npos)
        splitCells(line, ';', cells);
    else if (line.text.find(',') != std::string_view::npos)
        splitCells(line, ',', cells);
    else
        splitTokens(line, " \t", cells);
}

bool isPair(const std::vector<Token>& cells)
{
    return cells.size() == 2 && numberOf(cells[0].text) && numberOf(cells[1].text);
}

/// Whether a header begins as a row would, or has no words but digits, as with a Unicode minus or
/// in quotation marks: perhaps it was meant to be one.
bool looksLikeRow(const Token& line, const std::vector<Token>& cells)
{
    constexpr std::string_view digits = "0123456789";
    const Token first = trimmedToken(line);
    const auto isLetter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    return digits.find(first.text[0]) != std::string_view::npos
        || std::string_view("+-.").find(first.text[0]) != std::string_view::npos
        || (cells.size() > 1 && line.text.find_first_of(digits) != std::string_view::npos
            && std::ranges::none_of(line.text, isLetter));
}

/// The leading lines that are not two numbers.
struct Headers {
    Token row; ///< the first one that may be a point
    std::size_t rows = 0; ///< how many may be points
    std::string positionUnit;
    std::string offsetUnit;
};

void takeHeader(
    const Token& line, const std::vector<Token>& cells, Headers& headers, TextReading& source)
{
    if (looksLikeRow(line, cells)) {
        headers.row = headers.rows++ == 0 ? line : headers.row;
        return;
    }
    if (cells.size() != 2 || !headers.positionUnit.empty() || !headers.offsetUnit.empty())
        return;
    const auto unitIn = [](const Token& cell) {
        const std::string unit =
            csv::columnName(excerpt(trimmedToken(cell).text, Encoding::Utf8)).unit;
        return isPositionUnit(unit) ? unit : std::string();
    };
    headers.positionUnit = unitIn(cells[0]);
    headers.offsetUnit = unitIn(cells[1]);
    const std::string& unit = headers.positionUnit;
    if (!unit.empty() && !headers.offsetUnit.empty() && !isSameUnit(unit, headers.offsetUnit))
        source.diagnostics.error(DiagnosticCode::Contradiction, line.line, 0,
            Verbatim{excerpt(line.text, Encoding::Utf8)},
            AXISCOMP_TEXT("Error",
                "one unit for positions and offsets, which the controller adds; a calibration file "
                "is read with --from {format}")
                .with("format", Verbatim{"csv"}));
}

void reportRowsInHeader(const Headers& headers, TextReading& source)
{
    const Verbatim found{excerpt(headers.row.text, Encoding::Utf8)};
    source.diagnostics.warning(DiagnosticCode::Assumption, headers.row.line, 0,
        headers.rows == 1
            ? AXISCOMP_TEXT("Error", "\"{line}\", which is taken to be a header")
                  .with("line", found)
            : AXISCOMP_TEXT(
                "Error", "{count} lines that are taken to be headers, the first of them \"{line}\"")
                  .with("count", headers.rows)
                  .with("line", found),
        AXISCOMP_TEXT("Error", "{expected}, if it is a point").with("expected", twoNumbers));
}

struct Points {
    std::vector<double> positions;
    std::vector<double> offsets;
    std::vector<std::size_t> lines;
    std::string unit; ///< that the header says
};

void takeRow(const std::vector<Token>& cells, Points& points, TextReading& source)
{
    const Token& first = cells.front();
    if (cells.size() != 2) {
        source.error(invalidFormat, DiagnosticCode::ColumnCount, first.line, 0,
            AXISCOMP_COUNTED("Error", "{count} numbers", "1 number").with("count", cells.size()),
            twoNumbers);
        return;
    }
    const auto position = numberOf(cells[0].text);
    const auto offset = numberOf(cells[1].text);
    for (const Token& cell : cells)
        if (!numberOf(cell.text))
            source.error(invalidFormat, DiagnosticCode::NotANumber, cell.line, cell.column,
                Verbatim{excerpt(cell.text, Encoding::Utf8)},
                &cell == &first ? AXISCOMP_TEXT("Error", "a position such as 0.25")
                                : AXISCOMP_TEXT("Error", "an offset such as 0.001"));
    points.positions.push_back(position.value_or(0.0));
    points.offsets.push_back(offset.value_or(0.0));
    points.lines.push_back(first.line);
}

Points pointsOf(TextReading& source)
{
    Points points;
    TextLines lines(source.text);
    std::vector<Token> cells;
    Headers headers;
    bool isInHeader = true;
    while (const auto line = lines.next()) {
        if (trimmedToken(*line).text.empty())
            continue;
        if (source.isStopped())
            return points;
        splitRow(*line, cells);
        isInHeader = isInHeader && !isPair(cells);
        if (!isInHeader)
            takeRow(cells, points, source);
        else
            takeHeader(*line, cells, headers, source);
    }
    if (isInHeader)
        source.error(invalidFormat, DiagnosticCode::Syntax, headers.row.line, 0,
            Verbatim{excerpt(headers.row.text, Encoding::Utf8)},
            AXISCOMP_TEXT("Error", "lines of {expected}").with("expected", twoNumbers));
    else if (headers.rows > 0)
        reportRowsInHeader(headers, source);
    // Of the offsets alone it says nothing of the positions, but it must not contradict a setting.
    const SettingValues& settings = source.settings;
    const bool isSet = settings.has("position-unit") || settings.has("value-unit");
    points.unit = headers.positionUnit.empty() && isSet ? headers.offsetUnit : headers.positionUnit;
    return points;
}

/// The first point that does not go on in the direction of the first two; 0: all do. Offsets are
/// added to the positions unless there are none.
std::size_t turningPoint(const std::vector<double>& positions, const std::vector<double>& offsets)
{
    const bool isDown = positions.size() > 1 && positions[1] < positions[0];
    const auto sum = [&](std::size_t i) {
        return offsets.empty() ? positions[i] : positions[i] + offsets[i];
    };
    for (std::size_t i = 1; i < positions.size(); ++i)
        if (isDown ? !(sum(i) < sum(i - 1)) : !(sum(i) > sum(i - 1)))
            return i;
    return 0;
}

Quantity sumAt(
    const std::vector<double>& positions, const std::vector<double>& offsets, std::size_t i)
{
    return {roundedText(positions[i] + offsets[i])};
}

bool checkDirection(const Points& points, TextReading& source)
{
    const std::vector<double>& positions = points.positions;
    const std::vector<double>& offsets = points.offsets;
    const std::vector<std::size_t>& lines = points.lines;
    if (positions.size() < 2) {
        source.error(invalidFormat, DiagnosticCode::TooFewPoints, lines.front(), 0,
            AXISCOMP_TEXT("Error", "1 point"), AXISCOMP_TEXT("Error", "at least 2"));
        return false;
    }
    const bool isDown = positions[1] < positions[0];
    if (const std::size_t i = turningPoint(positions, {}); i > 0) {
        source.error(invalidFormat, DiagnosticCode::NotMonotonic, lines[i], 0,
            AXISCOMP_TEXT("Error", "{number} after {number2}")
                .with("number", Quantity{toText(positions[i])})
                .with("number2", Quantity{toText(positions[i - 1])}),
            isDown ? AXISCOMP_TEXT("Error", "strictly decreasing positions")
                   : AXISCOMP_TEXT("Error", "strictly increasing positions"));
        return false;
    }
    if (const std::size_t i = turningPoint(positions, offsets); i > 0)
        source.error(invalidFormat, DiagnosticCode::NotMonotonic, lines[i], 0,
            AXISCOMP_TEXT("Error", "position + offset {number} after {number2}")
                .with("number", sumAt(positions, offsets, i))
                .with("number2", sumAt(positions, offsets, i - 1)),
            isDown ? AXISCOMP_TEXT("Error", "strictly decreasing values, as the positions are")
                   : AXISCOMP_TEXT("Error", "strictly increasing values, as the positions are"));
    return true;
}

/// What is wrong with the table of a rotary axis: found and expected; nothing: it closes.
struct RangeFault {
    Text found;
    Text expected;
};
std::optional<RangeFault> rangeFault(
    const std::vector<double>& positions, const std::vector<double>& offsets, double wrap)
{
    const double span = std::abs(positions.back() - positions.front());
    const double size = std::abs(positions.front()) + std::abs(positions.back());
    if (!(std::abs(span - wrap) <= 1e-12 * size))
        return RangeFault{AXISCOMP_TEXT("Error", "positions from {first} to {last}")
                              .with("first", Quantity{toText(positions.front())})
                              .with("last", Quantity{toText(positions.back())}),
            AXISCOMP_TEXT("Error", "a span of exactly {range}, the wrap range")
                .with("range", Quantity{toText(wrap)})};
    if (offsets.front() != offsets.back())
        return RangeFault{AXISCOMP_TEXT("Error", "the offsets {first} and {last} at the ends")
                              .with("first", Quantity{toText(offsets.front())})
                              .with("last", Quantity{toText(offsets.back())}),
            AXISCOMP_TEXT("Error", "the same offset at both ends, which are one place")};
    return std::nullopt;
}

std::vector<NeutralTable> parse(TextReading& source)
{
    Points points = pointsOf(source);
    if (source.diagnostics.hasErrors() || points.positions.empty()
        || !checkDirection(points, source))
        return {};
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes.resize(1);
    table.columns.resize(1);
    if (source.settings.has(wrapRangeKey)) {
        const double wrap = source.settings.number(wrapRangeKey);
        table.axes[0].wrap = wrap;
        if (auto fault = rangeFault(points.positions, points.offsets, wrap))
            source.error(wrongRange, DiagnosticCode::NotPeriodic, points.lines.back(), 0,
                std::move(fault->found), std::move(fault->expected));
    }
    if (points.positions[1] < points.positions[0]) {
        std::ranges::reverse(points.positions);
        std::ranges::reverse(points.offsets);
    }
    table.axes[0].knots = std::move(points.positions);
    table.columns[0].values = std::move(points.offsets);
    takeOneUnit(table, source.settings, source.diagnostics, points.unit);
    return {std::move(table)};
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    AXISCOMP_CHECK(checkWrapRange(options.settings));
    return readText(icube::format().facts, text, options, parse);
}

/// At most a few lines of header and then pairs in one direction.
Recognition recognise(std::string_view text)
{
    constexpr std::size_t mostHeaders = 5;
    TextLines lines(text);
    std::vector<Token> cells;
    Points points;
    std::size_t headers = 0;
    auto line = lines.next();
    for (auto following = lines.next(); line; line = following, following = lines.next()) {
        if (trimmedToken(*line).text.empty())
            continue;
        splitRow(*line, cells);
        if (isPair(cells)) {
            points.positions.push_back(*numberOf(cells[0].text));
            points.offsets.push_back(*numberOf(cells[1].text));
        } else if (points.positions.empty() && cells.size() == 1 && numberOf(cells.front().text)) {
            return Recognition::No; // sizes, as other controllers have them above their rows
        } else if (points.positions.empty() && ++headers <= mostHeaders) {
            continue;
        } else if (following || points.positions.empty()) { // the last line may be cut off
            return Recognition::No;
        }
    }
    const bool isTable = points.positions.size() >= 2 && turningPoint(points.positions, {}) == 0
        && turningPoint(points.positions, points.offsets) == 0;
    return isTable ? Recognition::Possible : Recognition::No;
}

auto refuse(Text reason, Text wayOut)
{
    return cannotHold(icube::format().facts, std::move(reason), std::move(wayOut));
}

Result<void> checkWritable(const NeutralTable& table)
{
    const std::vector<double>& positions = table.axes[0].knots;
    const std::vector<double>& offsets = table.columns[0].values;
    if (const std::size_t i = turningPoint(positions, offsets); i > 0)
        return refuse(AXISCOMP_TEXT("Error",
                          "at {position} position + offset {sum} after {before} does not increase "
                          "(error 4900 of the controller)")
                          .with("position", Quantity{toText(positions[i])})
                          .with("sum", sumAt(positions, offsets, i))
                          .with("before", sumAt(positions, offsets, i - 1)),
            AXISCOMP_TEXT("Error", "check the unit of the values, or smooth them"));
    if (!table.axes[0].wrap)
        return {};
    if (const auto fault = rangeFault(positions, offsets, *table.axes[0].wrap))
        return refuse(AXISCOMP_TEXT("Error",
                          "of a rotary axis it wants {expected}, and this table has {found} (error "
                          "4902 of the controller)")
                          .with("expected", fault->expected)
                          .with("found", fault->found),
            AXISCOMP_TEXT("Error", "add the point that closes the revolution"));
    return {};
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = icube::format().facts;
    AXISCOMP_CHECK(checkWrapRange(options.settings));
    AXISCOMP_TRY(const auto values, SettingValues::of(facts, options.settings, true));
    WrittenTables written;
    AXISCOMP_TRY(auto table, asOwnAxisTable(facts, tables.front(), values, written.remarks));
    AXISCOMP_CHECK(takeWrapRange(table.axes[0], values));
    AXISCOMP_CHECK(checkWritable(table));
    for (std::size_t i = 0; i < table.pointCount(); ++i)
        written.bytes +=
            toText(table.axes[0].knots[i]) + ',' + toText(table.columns[0].values[i]) + '\n';
    if (written.bytes.size() > facts.mostBytes)
        return refuse(AXISCOMP_TEXT("Error", "{size} bytes are more than the {limit} of a file")
                          .with("size", written.bytes.size())
                          .with("limit", facts.mostBytes),
            AXISCOMP_TEXT("Error", "resample it onto a coarser grid"));
    const std::string& name = tables.front().axes[0].name;
    written.remarks.push_back(
        (name.empty() ? AXISCOMP_TEXT("Error",
             "the controller looks for the file as the name of the axis and PosComp.CSV, unless "
             "axis.xml names another one")
                      : AXISCOMP_TEXT("Error",
                          "the controller looks for the file as {name}PosComp.CSV, unless axis.xml "
                          "names another one"))
            .with("name", name));
    written.remarks.emplace_back(AXISCOMP_TEXT("Error",
        "parameter 1020 of the axis shows the commanded position with the compensation in it"));
    written.held.push_back(std::move(table));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "icube",
            .controller = "Yaskawa iCube Control",
            .description = AXISCOMP_TEXT("Error", "CSV file of positions and offsets"),
            .extensions = extensions,
            .knots = KnotRule::Any,
            .mostBytes = 999'999,
            .holdsWrap = true,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Hold},
            .outsideEvidence = Evidence::Published,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::icube
