// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"
#include "core/formats/formats.h"
#include "core/formats/softmc/softmc_targets.h"
#include "core/formats/units.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::softmc {

namespace {

constexpr std::size_t mostSources = 3;
constexpr std::size_t mostRows = 4'000'000;

constexpr std::array<std::string_view, 1> extensions{".txt"};
constexpr std::array<std::string_view, 4> rules{
    "The first line is N k1 .. kN: the number of source axes and of points along each.",
    "k1 x .. x kN rows follow, the first source fastest: N positions, then the corrections.",
    "Sources are equally spaced and increasing, in source user units; corrections are in target "
    "user units.",
    "The compensation takes effect once every source has reached its first value.",
};
constexpr std::array<std::string_view, 3> assumptions{
    "Above the last value the last correction is held.",
    "The k-th correction belongs to the k-th target axis that the program defines for the table; "
    "there may be fewer or more than N of them.",
    "The manual's example has a header that does not fit its rows: the rule is followed, and such "
    "a "
    "file is refused. The binary .CMP file is not published and not supported.",
};

/// The header's promise: N sources with so many points each.
struct Shape {
    std::vector<std::size_t> sizes;
    std::size_t rows = 0;
};

std::optional<Shape> readShape(const std::vector<Token>& tokens, DiagnosticList& diagnostics)
{
    const Token& first = tokens.front();
    const auto count = readWholeNumber(
        first, AXISCOMP_TEXT("Error", "the number of source axes, 1 to 3"), diagnostics);
    if (!count)
        return std::nullopt;
    if (*count < 1 || *count > static_cast<std::int64_t>(mostSources)) {
        diagnostics.error(DiagnosticCode::LimitExceeded, first.line, first.column,
            AXISCOMP_COUNTED("Error", "{count} source axes", "1 source axis").with("count", *count),
            AXISCOMP_TEXT("Error", "{number} to {number2}")
                .with("number", 1)
                .with("number2", mostSources));
        return std::nullopt;
    }
    if (tokens.size() != static_cast<std::size_t>(*count) + 1) {
        diagnostics.error(DiagnosticCode::ColumnCount, first.line, 0,
            AXISCOMP_COUNTED("Error", "{count} sizes", "1 size").with("count", tokens.size() - 1),
            AXISCOMP_TEXT("Error", "{number}, one for each source axis").with("number", *count));
        return std::nullopt;
    }
    Shape shape{{}, 1};
    for (std::size_t n = 1; n < tokens.size(); ++n) {
        const Token& token = tokens[n];
        const auto size = readWholeNumber(
            token, AXISCOMP_TEXT("Error", "the number of points of a source"), diagnostics);
        if (!size)
            return std::nullopt;
        if (*size < 2 || static_cast<std::size_t>(*size) > mostRows / shape.rows) {
            diagnostics.error(DiagnosticCode::LimitExceeded, token.line, token.column,
                AXISCOMP_COUNTED("Error", "{count} points", "1 point").with("count", *size),
                AXISCOMP_TEXT("Error", "at least 2, and at most {number} rows in all")
                    .with("number", mostRows));
            return std::nullopt;
        }
        shape.sizes.push_back(static_cast<std::size_t>(*size));
        shape.rows *= shape.sizes.back();
    }
    return shape;
}

/// The rows as they stand: N positions, then the corrections.
struct Rows {
    std::size_t width = 0;
    std::vector<double> numbers; ///< width for each row
    std::vector<std::size_t> lines;

    [[nodiscard]] double at(std::size_t row, std::size_t i) const
    {
        return numbers[row * width + i];
    }
};

Text numbersText(const std::vector<Token>& tokens)
{
    return AXISCOMP_COUNTED("Error", "{count} numbers", "1 number").with("count", tokens.size());
}

/// False: the rest cannot be understood.
bool takeRow(const std::vector<Token>& tokens, const Shape& shape, Rows& rows, TextReading& reading)
{
    DiagnosticList& diagnostics = reading.diagnostics;
    const std::size_t sources = shape.sizes.size();
    const std::size_t line = tokens.front().line;
    if (rows.width == 0 && tokens.size() <= sources) {
        diagnostics.error(DiagnosticCode::TooFewColumns, line, 0, numbersText(tokens),
            AXISCOMP_COUNTED("Error", "{count} positions and at least one correction",
                "1 position and at least one correction")
                .with("count", sources));
        return false;
    }
    if (rows.width == 0) {
        rows.width = tokens.size();
        // No more than the text can have.
        const std::size_t most = std::min(shape.rows, reading.text.size() / (2 * rows.width));
        rows.numbers.reserve(most * rows.width);
        rows.lines.reserve(most);
    }
    if (tokens.size() != rows.width) {
        diagnostics.error(DiagnosticCode::ColumnCount, line, 0, numbersText(tokens),
            AXISCOMP_TEXT("Error", "{number}, as in the first row").with("number", rows.width));
        return false;
    }
    const std::span<const Token> all(tokens);
    readNumbers(
        all.first(sources), AXISCOMP_TEXT("Error", "a source position"), rows.numbers, diagnostics);
    readNumbers(
        all.subspan(sources), AXISCOMP_TEXT("Error", "a correction"), rows.numbers, diagnostics);
    rows.lines.push_back(line);
    return true;
}

void reportOtherOrder(const Rows& rows, std::size_t row, std::size_t source, double expected,
    DiagnosticList& diagnostics)
{
    diagnostics.error(DiagnosticCode::Contradiction, rows.lines[row], source + 1,
        AXISCOMP_TEXT("Error", "{number} for source {number2}")
            .with("number", Quantity{toText(rows.at(row, source))})
            .with("number2", source + 1),
        AXISCOMP_TEXT("Error", "{number}: the first source changes fastest")
            .with("number", Quantity{toText(expected)}));
}

/// The positions of one source, which every row must repeat in the order of the rule.
std::vector<double> knotsOf(
    const Rows& rows, const Shape& shape, std::size_t source, DiagnosticList& diagnostics)
{
    std::size_t stride = 1;
    for (std::size_t n = 0; n < source; ++n)
        stride *= shape.sizes[n];
    std::vector<double> knots(shape.sizes[source]);
    for (std::size_t i = 0; i < knots.size(); ++i)
        knots[i] = rows.at(i * stride, source);
    const double allowance = 1e-9 * (std::abs(knots.front()) + std::abs(knots.back()));
    std::size_t row = 0;
    while (row < shape.rows) {
        for (std::size_t i = 0; i < knots.size(); ++i) {
            for (const std::size_t next = row + stride; row < next; ++row) {
                if (std::abs(rows.at(row, source) - knots[i]) <= allowance)
                    continue;
                reportOtherOrder(rows, row, source, knots[i], diagnostics);
                return knots;
            }
        }
    }
    return knots;
}

void checkEven(const SourceAxis& axis, DiagnosticList& diagnostics)
{
    if (isEven(axis))
        return;
    diagnostics.error(DiagnosticCode::UnevenSpacing, 0, 0,
        AXISCOMP_TEXT("Error", "positions of source {axis} from {first} to {last}")
            .with("axis", axis.name)
            .with("first", Quantity{toText(axis.knots.front())})
            .with("last", Quantity{toText(axis.knots.back())}),
        AXISCOMP_TEXT("Error", "equal distances"));
}

NeutralTable tableOf(const Rows& rows, const Shape& shape, DiagnosticList& diagnostics)
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    const std::size_t sources = shape.sizes.size();
    for (std::size_t n = 0; n < sources; ++n) {
        SourceAxis axis;
        axis.name = std::to_string(n + 1);
        axis.knots = knotsOf(rows, shape, n, diagnostics);
        const Text name = AXISCOMP_TEXT("Error", "source {number}").with("number", n + 1);
        if (checkKnots(axis.knots, {}, name, diagnostics))
            checkEven(axis, diagnostics);
        table.axes.push_back(std::move(axis));
    }
    for (std::size_t i = sources; i < rows.width; ++i) {
        CompensationColumn column;
        column.name = "Column " + std::to_string(i - sources + 1);
        column.values.resize(shape.rows);
        for (std::size_t row = 0; row < shape.rows; ++row)
            column.values[row] = rows.at(row, i);
        table.columns.push_back(std::move(column));
    }
    return table;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    DiagnosticList& diagnostics = reading.diagnostics;
    TextLines lines(reading.text);
    std::vector<Token> tokens;
    std::optional<Shape> shape;
    Rows rows;
    while (const auto line = lines.next()) {
        splitTokens(*line, " \t", tokens);
        if (tokens.empty())
            continue;
        if (reading.isStopped())
            return {};
        if (shape) {
            if (!takeRow(tokens, *shape, rows, reading))
                return {};
            continue;
        }
        shape = readShape(tokens, diagnostics);
        if (!shape)
            return {};
    }
    if (rows.lines.size() != shape->rows) {
        diagnostics.error(DiagnosticCode::Contradiction, 1, 0,
            AXISCOMP_TEXT("Error", "a header of {sizes} = {number} rows, and {number2} rows")
                .with("sizes", sizeText(shape->sizes))
                .with("number", shape->rows)
                .with("number2", rows.lines.size()),
            AXISCOMP_TEXT("Error", "as many rows as the header says"));
        return {};
    }
    NeutralTable table = tableOf(rows, *shape, diagnostics);
    takeUnits(table, reading.settings, diagnostics);
    return {std::move(table)};
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(softmc::format().facts, text, options, parse);
}

/// A first line "N k1 .. kN" that says as many sizes as it should, and a row of more numbers.
Recognition recognise(std::string_view text)
{
    TextLines lines(text);
    std::vector<Token> header;
    std::vector<Token> row;
    while (const auto line = lines.next()) {
        splitTokens(*line, " \t", header.empty() ? header : row);
        if (!row.empty())
            break;
    }
    if (header.empty() || row.size() < header.size())
        return Recognition::No;
    const auto sources = wholeNumberOf(header.front().text);
    const bool isHeader = sources && *sources >= 1
        && *sources <= static_cast<std::int64_t>(mostSources)
        && header.size() == static_cast<std::size_t>(*sources) + 1;
    for (const Token& token : header)
        if (!isHeader || wholeNumberOf(token.text).value_or(0) < 1)
            return Recognition::No;
    for (const Token& token : row)
        if (!numberOf(token.text))
            return Recognition::No;
    return Recognition::Certain;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    AXISCOMP_TRY(
        const auto settings, SettingValues::of(softmc::format().facts, options.settings, true));
    WrittenTables written;
    AXISCOMP_TRY(auto table, inSettingUnits(tables.front(), settings, written.remarks));
    AXISCOMP_CHECK(checkOneUnit(softmc::format().facts, unitContradiction(table)));
    std::string& text = written.bytes;
    text = std::to_string(table.axes.size());
    for (const SourceAxis& axis : table.axes)
        text += ' ' + std::to_string(axis.knots.size());
    text += '\n';
    for (std::size_t row = 0; row < table.pointCount(); ++row) {
        std::size_t rest = row;
        for (const SourceAxis& axis : table.axes) {
            text += toText(axis.knots[rest % axis.knots.size()]) + ' ';
            rest /= axis.knots.size();
        }
        for (const CompensationColumn& column : table.columns)
            text += toText(column.values[row]) + (&column == &table.columns.back() ? '\n' : ' ');
    }
    remarkTargets(table, written.remarks);
    // The file has no names; what they said stays known.
    table.name.clear();
    table.notes.clear();
    for (CompensationColumn& column : table.columns)
        if (const auto target = targetOf(table, column))
            column.target = target->source ? sourceTarget(*target->source) : std::string(otherAxis);
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        table.axes[n].name = std::to_string(n + 1);
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        table.columns[n].name = "Column " + std::to_string(n + 1);
    }
    written.held.push_back(std::move(table));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "softmc",
            .controller = "softMC (Danaher, Servotronix, Kollmorgen)",
            .description = AXISCOMP_TEXT("Error", "text table of positions and corrections"),
            .extensions = extensions,
            .mostDimensions = mostSources,
            .knots = KnotRule::Even,
            .mostPoints = mostRows,
            .mostColumns = 0,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Hold, .startsAtFirst = true},
            .outsideEvidence = Evidence::Assumed,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::softmc
