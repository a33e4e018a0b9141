// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"
#include "core/formats/formats.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace axiscomp::reprap {

namespace {

constexpr std::string_view anyTitle = "RepRapFirmware height map file";
constexpr std::string_view oldTitle = "RepRapFirmware height map file v1";
constexpr std::string_view title = "RepRapFirmware height map file v2";

constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array<std::string_view, 7> rules{
    "The first line begins with RepRapFirmware height map file v2, the second names the entries of "
    "the third: until version 3.2 xmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum, or one "
    "spacing for "
    "both, from 3.3 "
    "axis0,axis1,min0,max0,min1,max1,radius,spacing0,spacing1,num0,num1.",
    "Then there is a line for each position of the second axis, with a height for each position of "
    "the first.",
    "Positions are minimum + i x spacing; the last one may lie before the maximum.",
    "A bare 0, without decimals, marks a point that was not probed; a height of zero is 0.000.",
    "The firmware fills points that were not probed from a plane through the others, or from their "
    "neighbours. This program fills or leaves them out only when it is told to (--fill, --crop).",
    "Heights are added to the commanded Z; between the points they are bilinear, in single "
    "precision.",
    "Outside of the map the heights at its edge are held.",
};
constexpr std::array<std::string_view, 3> assumptions{
    "A height of the bed is not an error of the Z axis. It is understood as the offset that the "
    "firmware adds to the commanded Z, so that the nozzle follows the bed; as a value for the "
    "feedback it is the opposite. The taper over the height (M376) is left out.",
    "A file whose radius leaves points out is read like any other: the points must be there.",
    "Positions and heights are in mm.",
};

/// The entries of the third line in their order.
struct Labels {
    std::string_view text;
    bool hasLetters; ///< of the axes, in front
    std::size_t spacings = 2; ///< 1: the same for both axes
};
constexpr std::array labelLines{
    Labels{"xmin,xmax,ymin,ymax,radius,spacing,xnum,ynum", false, 1},
    Labels{"xmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum", false},
    Labels{"axis0,axis1,min0,max0,min1,max1,radius,spacing0,spacing1,num0,num1", true},
};

struct Axis {
    std::string name;
    double minimum = 0.0;
    double maximum = 0.0;
    double spacing = 0.0;
    std::int64_t points = 0;
};

/// Checks that the entries of an axis fit each other, as far as their two decimals tell.
bool checkAxis(const Axis& axis, std::size_t line, TextReading& source)
{
    const Text found =
        AXISCOMP_TEXT("Error", "{axis} from {number} to {number2} by {number3} in {number4} points")
            .with("axis", axis.name)
            .with("number", Quantity{toText(axis.minimum)})
            .with("number2", Quantity{toText(axis.maximum)})
            .with("number3", Quantity{toText(axis.spacing)})
            .with("number4", axis.points);
    if (axis.points < 2) {
        source.diagnostics.error(DiagnosticCode::TooFewPoints, line, 0, found,
            AXISCOMP_TEXT("Error", "at least 2 along each axis"));
        return false;
    }
    const double steps = static_cast<double>(axis.points - 1);
    const double rest = axis.maximum - (axis.minimum + steps * axis.spacing);
    const double printed = 0.01 * (steps + 2.0);
    if (axis.spacing > 0.0 && rest > -printed && rest < axis.spacing + printed)
        return true;
    source.diagnostics.error(DiagnosticCode::Contradiction, line, 0, found,
        AXISCOMP_TEXT("Error", "as many points as lie between minimum and maximum"));
    return false;
}

/// The third line; nothing after an error.
std::optional<std::array<Axis, 2>> axesOf(
    const Token& line, const Labels& labels, TextReading& source)
{
    std::vector<Token> cells;
    splitCells(line, ',', cells);
    std::vector<Token> names;
    splitCells({labels.text, 0, 0}, ',', names);
    if (cells.size() != names.size()) {
        source.diagnostics.error(DiagnosticCode::ColumnCount, line.line, 0,
            AXISCOMP_COUNTED("Error", "{count} entries", "1 entry").with("count", cells.size()),
            AXISCOMP_TEXT("Error", "{number}: {names}")
                .with("number", names.size())
                .with("names", labels.text));
        return std::nullopt;
    }
    std::array<Axis, 2> axes{Axis{.name = "X"}, Axis{.name = "Y"}};
    const std::size_t first = labels.hasLetters ? 2 : 0;
    for (std::size_t n = 0; n < first; ++n)
        axes[n].name = toUtf8(cells[n].text, Encoding::Utf8);
    std::array<double, 7> numbers{};
    const std::size_t count = 5 + labels.spacings;
    bool isRead = true;
    for (std::size_t n = 0; n < count; ++n) {
        const auto number = readNumber(cells[first + n],
            AXISCOMP_TEXT("Error", "a number for {key}").with("key", names[first + n].text),
            source.diagnostics);
        isRead = isRead && number.has_value();
        numbers[n] = number.value_or(0.0);
    }
    for (std::size_t n = 0; n < axes.size(); ++n) {
        const Token& cell = cells[first + count + n];
        const auto points =
            readWholeNumber(cell, AXISCOMP_TEXT("Error", "a number of points"), source.diagnostics);
        isRead = isRead && points.has_value();
        axes[n].minimum = numbers[2 * n];
        axes[n].maximum = numbers[2 * n + 1];
        axes[n].spacing = numbers[labels.spacings == 1 ? 5 : 5 + n];
        axes[n].points = points.value_or(0);
    }
    if (isRead && (axes[0].name.empty() || axes[0].name == axes[1].name)) {
        source.diagnostics.error(DiagnosticCode::Contradiction, line.line, 0,
            AXISCOMP_TEXT("Error", "the axes \"{first}\" and \"{second}\"")
                .with("first", axes[0].name)
                .with("second", axes[1].name),
            AXISCOMP_TEXT("Error", "two different letters"));
        return std::nullopt;
    }
    isRead = isRead && checkAxis(axes[0], line.line, source);
    return isRead && checkAxis(axes[1], line.line, source) ? std::optional(axes) : std::nullopt;
}

/// cells: of the line.
void takeRow(const Token& line, const std::vector<Token>& cells, const std::array<Axis, 2>& axes,
    std::size_t row, std::vector<double>& heights, TextReading& source)
{
    if (static_cast<std::int64_t>(cells.size()) != axes[0].points) {
        source.diagnostics.error(DiagnosticCode::ColumnCount, line.line, 0,
            AXISCOMP_COUNTED("Error", "{count} heights", "1 height").with("count", cells.size()),
            AXISCOMP_TEXT("Error", "{number}, one for each position of {axis}")
                .with("number", axes[0].points)
                .with("axis", axes[0].name));
        return;
    }
    const auto position = [](const Axis& axis, std::size_t i) {
        return AXISCOMP_TEXT("Error", "{axis} = {position}")
            .with("axis", axis.name)
            .with("position",
                Quantity{roundedText(axis.minimum + static_cast<double>(i) * axis.spacing)});
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bool isProbed = cells[i].text != "0";
        if (!isProbed && source.options.missing == MissingPoints::Refuse)
            source.diagnostics.error(DiagnosticCode::MissingPoint, line.line, i + 1,
                AXISCOMP_TEXT("Error", "a point that was not probed at {position}, {other}")
                    .with("position", position(axes[0], i))
                    .with("other", position(axes[1], row)),
                AXISCOMP_TEXT("Error",
                    "a height with decimals; points without a value can be filled or left out "
                    "(--fill, --crop, or Missing points in the import)"));
        heights.push_back(isProbed
                ? readNumber(cells[i], AXISCOMP_TEXT("Error", "a height in mm"), source.diagnostics)
                      .value_or(0.0)
                : std::numeric_limits<double>::quiet_NaN());
    }
}

std::vector<double> heightsOf(
    TextLines& lines, const std::array<Axis, 2>& axes, TextReading& source)
{
    std::vector<double> heights;
    std::vector<Token> cells;
    std::int64_t rows = 0;
    while (const auto line = lines.next()) {
        if (source.isStopped())
            return {};
        if (trimmedToken(*line).text.empty())
            continue;
        if (rows == axes[1].points && !numberOf(line->text.substr(0, line->text.find(','))))
            continue; // what a slicer or a person has added
        if (rows == axes[1].points) {
            source.diagnostics.error(DiagnosticCode::Contradiction, line->line, 0,
                AXISCOMP_TEXT("Error", "a further line after {number}").with("number", rows),
                AXISCOMP_TEXT("Error", "{number} lines of heights").with("number", axes[1].points));
            return heights;
        }
        splitCells(*line, ',', cells);
        takeRow(*line, cells, axes, static_cast<std::size_t>(rows), heights, source);
        ++rows;
    }
    if (rows < axes[1].points)
        source.diagnostics.error(DiagnosticCode::MissingPoint, 0, 0,
            AXISCOMP_COUNTED("Error", "{count} lines of heights", "1 line of heights")
                .with("count", rows),
            AXISCOMP_TEXT("Error", "{number}, one for each position of {axis}")
                .with("number", axes[1].points)
                .with("axis", axes[1].name));
    return heights;
}

const Labels* labelsOf(const std::optional<Token>& line, TextReading& source)
{
    const std::string_view text = line ? line->text : std::string_view();
    const auto* const labels = std::ranges::find_if(
        labelLines, [&](const Labels& known) { return text.starts_with(known.text); });
    if (labels != labelLines.end())
        return labels;
    source.diagnostics.error(DiagnosticCode::Syntax, 2, 0, Verbatim{excerpt(text, Encoding::Utf8)},
        AXISCOMP_TEXT("Error", "the line {line}, or {other}")
            .with("line", labelLines[1].text)
            .with("other", labelLines[2].text));
    return nullptr;
}

std::vector<NeutralTable> parse(TextReading& source)
{
    TextLines lines(source.text);
    const Token first = lines.next().value_or(Token{});
    if (!first.text.starts_with(title)) {
        const bool isOld = first.text.starts_with(oldTitle);
        source.diagnostics.error(DiagnosticCode::Syntax, 1, 0,
            isOld ? AXISCOMP_TEXT("Error", "version 1 of the height map")
                  : Text(Verbatim{excerpt(first.text, Encoding::Utf8)}),
            isOld ? AXISCOMP_TEXT("Error", "version 2, which newer firmware writes")
                  : AXISCOMP_TEXT("Error", "the line {line}").with("line", title));
        return {};
    }
    const Labels* const labels = labelsOf(lines.next(), source);
    if (!labels)
        return {};
    const auto third = lines.next();
    const auto axes = axesOf(third.value_or(Token{{}, 3, 1}), *labels, source);
    if (!axes)
        return {};
    NeutralTable table;
    table.sign = SignConvention::Command;
    const std::string note = toUtf8(first.text.substr(title.size()), Encoding::Utf8);
    if (const std::size_t text = note.find_first_not_of(", "); text != std::string::npos)
        table.notes.push_back(note.substr(text));
    CompensationColumn column;
    column.target = "Z";
    column.unit = "mm";
    column.values = heightsOf(lines, *axes, source);
    if (source.diagnostics.hasErrors())
        return {};
    for (const Axis& from : *axes) {
        SourceAxis axis;
        axis.name = from.name;
        axis.unit = "mm";
        axis.knots = evenKnots(from.minimum, from.spacing, static_cast<std::size_t>(from.points));
        table.axes.push_back(std::move(axis));
    }
    table.columns.push_back(std::move(column));
    return {std::move(table)};
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(reprap::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    const auto line = TextLines(text).next();
    return line && line->text.starts_with(anyTitle) ? Recognition::Certain : Recognition::No;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "reprap",
            .controller = "RepRapFirmware (Duet)",
            .description = AXISCOMP_TEXT("Error", "heightmap.csv, version 2: heights of the bed"),
            .extensions = extensions,
            .fewestDimensions = 2,
            .mostDimensions = 2,
            .knots = KnotRule::Even,
            .holdsNames = true,
            .holdsUnits = true,
            .marksMissing = true,
            .holdsNotes = true,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Code,
            .behaviour = {.outside = Outside::Hold, .usesFloat = true},
            .outsideEvidence = Evidence::Code,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read};
    return format;
}

} // namespace axiscomp::reprap
