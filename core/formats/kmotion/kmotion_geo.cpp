// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/formats/formats.h"
#include "core/formats/units.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp::kmotion_geo {

namespace {

constexpr std::int64_t fewestLines = 2; ///< rows, and columns
constexpr std::int64_t mostLines = 4000;
constexpr std::string_view unitKey = "unit";

// What the controller says of a file that it does not take.
constexpr std::string_view wrongSizes = "Invalid Geometric Correction File (NRows and NCols)";
constexpr std::string_view wrongSpacing =
    "Invalid Geometric Correction File (GeoSpacingX and GeoSpacingY)";
constexpr std::string_view wrongOffset =
    "Invalid Geometric Correction File (GeoOffsetX and GeoOffsetY)";
constexpr std::string_view wrongPoint = "Invalid Geometric Correction File (invalid data value)";

constexpr std::array<std::string_view, 1> extensions{".txt"};
constexpr std::array settings{
    FormatSetting{.key = unitKey,
        .kind = FormatSetting::Kind::Choice,
        .meaning = AXISCOMP_TEXT("Error",
            "unit of all numbers of the file; the controller takes them to be inches, and files in "
            "millimetres occur"),
        .choices = "inch, mm",
        .standard = "inch",
        .forReading = true,
        .forWriting = true},
};
constexpr std::array<std::string_view, 9> rules{
    "Numbers between commas: rows and columns; the distance of X and of Y; X and Y of row 0, "
    "column "
    "0; then row, column, X, Y and Z for each point. A comma stands directly behind a number, "
    "blanks "
    "and line ends may stand before one.",
    "Rows go along Y, columns along X, 2 to 4000 of each.",
    "X and Y of a point are where the machine must be commanded to go so that it really is at the "
    "grid point; Z is an offset of the commanded Z.",
    "The row and the column of a line say where its point belongs, not the order of the lines.",
    "As many lines are read as there are points; what follows is not read.",
    "A distance may be negative; with a distance of 0 nothing is corrected.",
    "The numbers are multiplied by the counts per inch.",
    "Between the points the correction is bilinear; outside, the nearest cell is extrapolated.",
    "Z is corrected for the plane Z = 0 only, and arcs are broken into short lines.",
};
constexpr std::array<std::string_view, 2> assumptions{
    "A line for each point is needed: the controller leaves a point without a line undefined. Of "
    "two "
    "lines for one point the last counts.",
    "An axis that is not corrected is written with zeros.",
};

/// The numbers of a text as the controller reads them.
class Numbers {
public:
    explicit Numbers(std::string_view text) : m_lines(text) { }

    /// Up to a blank, a comma or the end of the line; nothing at the end of the text. Empty where a
    /// comma stands instead of a number.
    [[nodiscard]] std::optional<Token> next()
    {
        m_rest = trimmedToken(m_rest);
        while (!m_rest) {
            const auto line = m_lines.next();
            if (!line)
                return std::nullopt;
            m_rest = trimmedToken(*line);
        }
        const std::size_t end = std::min(m_rest.text.find_first_of(", \t"), m_rest.text.size());
        const Token number = m_rest.part(0, end);
        m_rest = m_rest.part(end);
        return number;
    }
    /// The comma directly behind the number.
    [[nodiscard]] bool takeComma()
    {
        if (!m_rest.text.starts_with(','))
            return false;
        m_rest = m_rest.part(1);
        return true;
    }
    [[nodiscard]] const Token& rest() const { return m_rest; }

private:
    TextLines m_lines;
    Token m_rest;
};

class Reader {
public:
    explicit Reader(TextReading& reading) : m_reading(reading), m_numbers(reading.text) { }
    [[nodiscard]] std::vector<NeutralTable> read();

private:
    /// So many numbers with commas between; nothing at the end of the text, and after an error.
    [[nodiscard]] bool group(std::span<Token> tokens, std::string_view fault);
    [[nodiscard]] bool header();
    [[nodiscard]] std::optional<std::size_t> lineNumber(
        const Token& token, std::size_t count, const TextPattern& expected);
    [[nodiscard]] double number(
        const Token& token, const TextPattern& expected, std::string_view fault);
    void takePoint(std::span<const Token> tokens);
    void checkPoints();
    void checkRest();
    void fault(
        std::string_view fault, DiagnosticCode code, const Token& place, Text found, Text expected)
    {
        m_reading.error(
            fault, code, place.line, place.column, std::move(found), std::move(expected));
    }
    [[nodiscard]] double place(std::size_t n, std::size_t i) const
    {
        return m_starts[n] + static_cast<double>(i) * m_distances[n];
    }
    /// Ascending along both axes.
    [[nodiscard]] std::size_t indexOf(std::size_t column, std::size_t row) const
    {
        const auto along = [this](std::size_t n, std::size_t i) {
            return m_distances[n] < 0.0 ? m_counts[n] - 1 - i : i;
        };
        return along(0, column) + m_counts[0] * along(1, row);
    }

    TextReading& m_reading;
    Numbers m_numbers;
    std::array<std::size_t, 2> m_counts{}; ///< along X and Y
    std::array<double, 2> m_distances{};
    std::array<double, 2> m_starts{};
    struct Point {
        std::size_t column = 0;
        std::size_t row = 0;
        std::array<double, 3> position{};
    };
    std::vector<Point> m_points; ///< as they stand in the file
    std::size_t m_lastLine = 0;
};

bool Reader::group(std::span<Token> tokens, std::string_view fault)
{
    for (Token& token : tokens) {
        const auto next = m_numbers.next();
        const bool isFirst = &token == &tokens.front();
        if (!next && isFirst)
            return false;
        if (!next || !*next) {
            const Token& place = next ? *next : tokens.front();
            m_reading.error(fault, DiagnosticCode::Syntax, place.line, next ? place.column : 0,
                AXISCOMP_TEXT("Error", "a missing number"),
                AXISCOMP_COUNTED("Error", "{count} numbers with commas between", "1 number")
                    .with("count", tokens.size()));
            return false;
        }
        token = *next;
        if (&token == &tokens.back() || m_numbers.takeComma())
            continue;
        m_reading.error(fault, DiagnosticCode::Syntax, token.line, token.column + token.text.size(),
            quoted(m_numbers.rest()),
            AXISCOMP_TEXT("Error", "a comma directly behind the number \"{number}\"")
                .with("number", quoted(token)));
        return false;
    }
    return true;
}

double Reader::number(const Token& token, const TextPattern& expected, std::string_view fault)
{
    const auto number = numberOf(token.text);
    if (!number)
        this->fault(fault, DiagnosticCode::NotANumber, token, quoted(token), expected);
    return number.value_or(0.0);
}

bool Reader::header()
{
    std::array<Token, 2> sizes;
    std::array<Token, 2> distances;
    std::array<Token, 2> starts;
    if (!group(sizes, wrongSizes) || !group(distances, wrongSpacing)
        || !group(starts, wrongOffset)) {
        if (!m_reading.diagnostics.hasErrors())
            m_reading.error(wrongSizes, DiagnosticCode::Syntax, 0, 0, {},
                AXISCOMP_TEXT("Error",
                    "rows and columns, distances of X and Y, and X and Y of the first point"));
        return false;
    }
    for (std::size_t n = 0; n < 2; ++n) {
        const Token& size = sizes[1 - n]; // rows go along Y
        const auto count = wholeNumberOf(size.text);
        if (!count || *count < fewestLines || *count > mostLines)
            fault(wrongSizes, count ? DiagnosticCode::LimitExceeded : DiagnosticCode::NotANumber,
                size, quoted(size),
                AXISCOMP_TEXT("Error", "a number of rows or columns, {number} to {number2}")
                    .with("number", fewestLines)
                    .with("number2", mostLines));
        m_counts[n] = static_cast<std::size_t>(count.value_or(0));
        m_distances[n] =
            number(distances[n], AXISCOMP_TEXT("Error", "a distance such as 0.5"), wrongSpacing);
        if (m_distances[n] == 0.0 && !m_reading.diagnostics.hasErrors())
            fault(wrongSpacing, DiagnosticCode::LimitExceeded, distances[n],
                AXISCOMP_TEXT("Error", "a distance of 0"),
                AXISCOMP_TEXT("Error", "another one: with 0 the controller corrects nothing"));
        m_starts[n] = number(
            starts[n], AXISCOMP_TEXT("Error", "a position of row 0 and column 0"), wrongOffset);
    }
    return !m_reading.diagnostics.hasErrors();
}

std::optional<std::size_t> Reader::lineNumber(
    const Token& token, std::size_t count, const TextPattern& expected)
{
    const auto found = wholeNumberOf(token.text);
    if (found && *found >= 0 && static_cast<std::size_t>(*found) < count)
        return static_cast<std::size_t>(*found);
    fault(wrongPoint, found ? DiagnosticCode::LimitExceeded : DiagnosticCode::NotANumber, token,
        quoted(token), expected.with("last", count - 1));
    return std::nullopt;
}

void Reader::takePoint(std::span<const Token> tokens)
{
    const auto row = lineNumber(
        tokens[0], m_counts[1], AXISCOMP_TEXT("Error", "the number of a row, 0 to {last}"));
    const auto column = lineNumber(
        tokens[1], m_counts[0], AXISCOMP_TEXT("Error", "the number of a column, 0 to {last}"));
    Point point{column.value_or(0), row.value_or(0), {}};
    for (std::size_t n = 0; n < 3; ++n)
        point.position[n] =
            number(tokens[n + 2], AXISCOMP_TEXT("Error", "a position such as 0.25"), wrongPoint);
    m_lastLine = tokens[0].line;
    m_points.push_back(point);
}

/// Each point has its line; a second one is said.
void Reader::checkPoints()
{
    std::vector<bool> isThere(m_counts[0] * m_counts[1]);
    const auto name = [](std::size_t row, std::size_t column) {
        return AXISCOMP_TEXT("Error", "row {row}, column {column}")
            .with("row", row)
            .with("column", column);
    };
    for (const Point& point : m_points) {
        const std::size_t index = point.column + m_counts[0] * point.row;
        if (isThere[index])
            m_reading.diagnostics.warning(DiagnosticCode::DuplicateValue, 0, 0,
                name(point.row, point.column),
                AXISCOMP_TEXT("Error", "each point once; the last line counts"));
        isThere[index] = true;
    }
    const auto missing = std::ranges::count(isThere, false);
    if (missing == 0)
        return;
    const auto first =
        static_cast<std::size_t>(std::ranges::find(isThere, false) - isThere.begin());
    m_reading.error(wrongPoint, DiagnosticCode::MissingPoint, m_lastLine, 0,
        AXISCOMP_COUNTED(
            "Error", "no line for {count} points, the first of them {point}", "no line for {point}")
            .with("count", missing)
            .with("point", name(first / m_counts[0], first % m_counts[0])),
        AXISCOMP_TEXT("Error", "a line for each of the {rows} x {columns} points")
            .with("rows", m_counts[1])
            .with("columns", m_counts[0]));
}

void Reader::checkRest()
{
    const auto next = m_numbers.next();
    if (next && numberOf(next->text))
        m_reading.diagnostics.warning(DiagnosticCode::LeftOut, next->line, next->column,
            AXISCOMP_TEXT("Error", "further numbers behind the last point"),
            AXISCOMP_TEXT("Error", "{number} points; the controller does not read more either")
                .with("number", m_points.size()));
}

std::vector<NeutralTable> Reader::read()
{
    if (!header())
        return {};
    std::array<Token, 5> tokens;
    const std::size_t count = m_counts[0] * m_counts[1];
    while (m_points.size() < count && group(tokens, wrongPoint)) {
        if (m_reading.isStopped())
            return {};
        takePoint(tokens);
    }
    if (m_reading.diagnostics.hasErrors())
        return {};
    checkPoints();
    if (m_reading.diagnostics.hasErrors())
        return {};
    checkRest();
    const std::string unit = m_reading.settings.text(unitKey);
    if (!m_reading.options.settings.contains(unitKey))
        m_reading.diagnostics.warning(DiagnosticCode::UnitNotGiven, 0, 0,
            AXISCOMP_TEXT("Error", "numbers without a unit, taken to be {unit}").with("unit", unit),
            AXISCOMP_TEXT("Error", "the setting {key}, {value} or {value2}")
                .with("key", Verbatim{std::string(unitKey)})
                .with("value", Verbatim{"inch"})
                .with("value2", Verbatim{"mm"}));
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes.resize(2);
    table.columns.resize(3);
    constexpr std::array<const char*, 3> names{"X", "Y", "Z"};
    for (std::size_t n = 0; n < 2; ++n) {
        table.axes[n].name = names[n];
        table.axes[n].unit = unit;
        table.axes[n].knots.resize(m_counts[n]);
        for (std::size_t i = 0; i < m_counts[n]; ++i)
            table.axes[n].knots[m_distances[n] < 0.0 ? m_counts[n] - 1 - i : i] = place(n, i);
    }
    for (std::size_t n = 0; n < 3; ++n) {
        table.columns[n].target = names[n];
        table.columns[n].unit = unit;
        table.columns[n].values.resize(count);
    }
    for (const Point& point : m_points) {
        const std::size_t index = indexOf(point.column, point.row);
        table.columns[0].values[index] = point.position[0] - place(0, point.column);
        table.columns[1].values[index] = point.position[1] - place(1, point.row);
        table.columns[2].values[index] = point.position[2];
    }
    return {std::move(table)};
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    return Reader(reading).read();
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(kmotion_geo::format().facts, text, options, parse);
}

/// Three lines of two numbers, rows and columns the first of them, and the line of a point.
Recognition recognise(std::string_view text)
{
    TextLines lines(text);
    std::vector<Token> cells;
    std::array<std::int64_t, 2> sizes{};
    int found = 0;
    while (found < 4) {
        const auto line = lines.next();
        if (!line)
            return Recognition::No;
        if (!trimmedToken(*line))
            continue;
        splitCells(*line, ',', cells);
        const bool areNumbers = std::ranges::all_of(
            cells, [](const Token& cell) { return numberOf(cell.text).has_value(); });
        if (!areNumbers || cells.size() != (found < 3 ? std::size_t{2} : std::size_t{5}))
            return Recognition::No;
        for (std::size_t n = 0; n < 2 && (found == 0 || found == 3); ++n) {
            const auto whole = wholeNumberOf(cells[n].text);
            const bool fits = found == 0 ? whole && *whole >= fewestLines && *whole <= mostLines
                                         : whole && *whole >= 0 && *whole < sizes[n];
            if (!fits)
                return Recognition::No;
            if (found == 0)
                sizes[n] = *whole;
        }
        ++found;
    }
    return Recognition::Certain;
}

auto refuse(Text reason, Text wayOut)
{
    return cannotHold(kmotion_geo::format().facts, std::move(reason), std::move(wayOut));
}

/// The first source is X and the second Y, whatever they are called, unless they are called the
/// other way round.
Result<void> checkSources(const NeutralTable& table)
{
    constexpr std::array<std::string_view, 3> names{"X", "Y", "Z"};
    for (std::size_t n = 0; n < 2; ++n) {
        const SourceAxis& axis = table.axes[n];
        for (std::size_t other = 0; other < names.size(); ++other)
            if (other != n && sameLetters(axis.name, names[other]))
                return refuse(
                    AXISCOMP_TEXT("Error", "its source {number} is {axis}, and this one is {name}")
                        .with("number", n + 1)
                        .with("axis", names[n])
                        .with("name", axis.name),
                    AXISCOMP_TEXT("Error", "exchange the sources of the table"));
        if (static_cast<std::int64_t>(axis.knots.size()) > mostLines)
            return refuse(AXISCOMP_TEXT("Error",
                              "{count} points along {axis} are more than the {limit} that the "
                              "controller takes")
                              .with("count", axis.knots.size())
                              .with("axis", names[n])
                              .with("limit", mostLines),
                AXISCOMP_TEXT("Error", "resample it onto a coarser grid"));
    }
    return {};
}

/// The columns for X, Y and Z; null: not corrected.
using Targets = std::array<const CompensationColumn*, 3>;
Result<Targets> targetsOf(const NeutralTable& table)
{
    AXISCOMP_CHECK(checkTargets(table));
    Targets targets{};
    for (const CompensationColumn& column : table.columns) {
        const auto source = ownAxis(table, column);
        const std::string stated = targetName(table, column);
        const std::string_view name = stated.empty() ? axisOfColumn(column.name) : stated;
        if (!source && !name.empty() && !sameLetters(name, "Z"))
            return refuse(
                AXISCOMP_TEXT("Error", "it corrects X, Y and Z, and this table goes from {column}")
                    .with("column", columnText(table, column)),
                AXISCOMP_TEXT("Error", "state the target as Z, or as other, where it is Z"));
        const CompensationColumn*& target = targets[source.value_or(2)];
        if (target)
            return refuse(AXISCOMP_TEXT("Error", "two columns go from {column}")
                              .with("column", columnText(table, column)),
                AXISCOMP_TEXT("Error", "keep one of them"));
        target = &column;
    }
    return targets;
}

/// An axis as the controller computes its positions.
struct Spacing {
    explicit Spacing(const std::vector<double>& knots)
        : start(knots.front())
        , distance((knots.back() - knots.front()) / static_cast<double>(knots.size() - 1))
    {
    }
    [[nodiscard]] double at(std::size_t i) const
    {
        return start + static_cast<double>(i) * distance;
    }
    double start;
    double distance;
};

std::string textOf(const NeutralTable& table, const Targets& targets)
{
    const std::size_t columns = table.axes[0].knots.size();
    const std::size_t rows = table.axes[1].knots.size();
    const Spacing x(table.axes[0].knots);
    const Spacing y(table.axes[1].knots);
    std::string text = std::to_string(rows) + ',' + std::to_string(columns) + '\n';
    text += toText(x.distance) + ',' + toText(y.distance) + '\n';
    text += toText(x.start) + ',' + toText(y.start) + '\n';
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const auto value = [&](std::size_t n) {
                return targets[n] ? targets[n]->values[column + columns * row] : 0.0;
            };
            text += std::to_string(row) + ',' + std::to_string(column) + ','
                + toText(x.at(column) + value(0)) + ',' + toText(y.at(row) + value(1)) + ','
                + toText(value(2)) + '\n';
        }
    return text;
}

/// The columns of the file in the order of the table, those that it does not have behind them.
void orderColumns(NeutralTable& held, const NeutralTable& table, const Targets& targets)
{
    std::vector<CompensationColumn> columns;
    for (const CompensationColumn& column : table.columns)
        for (std::size_t n = 0; n < targets.size(); ++n)
            if (targets[n] == &column)
                columns.push_back(held.columns[n]);
    for (std::size_t n = 0; n < targets.size(); ++n)
        if (!targets[n])
            columns.push_back(held.columns[n]);
    held.columns = std::move(columns);
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = kmotion_geo::format().facts;
    AXISCOMP_TRY(const auto values, SettingValues::of(facts, options.settings, true));
    const std::string unit = values.text(unitKey);
    AXISCOMP_CHECK(checkSources(tables.front()));
    WrittenTables written;
    AXISCOMP_TRY(const auto table, inUnits(tables.front(), unit, {}, written.remarks));
    AXISCOMP_TRY(const auto targets, targetsOf(table));
    written.bytes = textOf(table, targets);
    AXISCOMP_TRY(
        auto held, readBack(kmotion_geo::format(), written.bytes, {{std::string(unitKey), unit}}));
    orderColumns(held.front(), table, targets);
    written.held = std::move(held);
    written.remarks.push_back(AXISCOMP_TEXT(
        "Error", "the numbers of the file are in {unit}; the controller takes them to be inches")
                                  .with("unit", unit));
    written.remarks.emplace_back(AXISCOMP_TEXT("Error",
        "name the file as Geo File in the tool setup of KMotionCNC; arcs are then broken into "
        "short lines, and Z is corrected for the plane Z = 0 only"));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "kmotion-geo",
            .controller = "KFLOP, KMotion (Dynomotion)",
            .description =
                AXISCOMP_TEXT("Error", "geometric correction of X, Y and Z over X and Y"),
            .extensions = extensions,
            .fewestDimensions = 2,
            .mostDimensions = 2,
            .knots = KnotRule::Even,
            .mostPoints = static_cast<std::size_t>(mostLines) * mostLines,
            .mostColumns = 3,
            .holdsNames = true,
            .holdsUnits = true,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Code,
            .behaviour = {.outside = Outside::Extrapolate},
            .outsideEvidence = Evidence::Published,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::kmotion_geo
