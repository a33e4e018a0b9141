// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/aerotech/aerotech_file.h"
#include "core/formats/formats.h"
#include "core/formats/units.h"
#include "core/text/text_file.h"

#include <algorithm>

namespace axiscomp::aerotech_2d {

namespace {

constexpr std::string_view directive = ":START2D";
constexpr std::string_view known[] = {"POSUNIT", "CORUNIT", "OFFSETROW", "OFFSETCOL", "OUTAXIS3",
    "NEGCOR", "SERIALNUMBER", "HOMEDIRECTION", "HOMEOFFSET"};
constexpr std::size_t mostOutputs = 3;

constexpr FormatSetting axisNumberSetting(
    std::string_view key, AxisOfTable axis, const TextPattern& meaning)
{
    return {.key = key,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = meaning,
        .forWriting = true,
        .namedAxis = axis};
}
constexpr std::array<std::string_view, 1> extensions{".cal"};
constexpr std::array settings{aerotech::rotaryAxes, aerotech::primaryUnit, aerotech::secondaryUnit,
    aerotech::countsPerUnit, aerotech::units,
    axisNumberSetting("column-axis", AxisOfTable::source(0),
        AXISCOMP_TEXT("Error", "number of the axis that changes along a line, from 1")),
    axisNumberSetting("row-axis", AxisOfTable::source(1),
        AXISCOMP_TEXT("Error", "number of the axis that changes from line to line, from 1")),
    axisNumberSetting("output-axis-1", AxisOfTable::target(0),
        AXISCOMP_TEXT("Error", "number of the axis of the first corrections, from 1")),
    axisNumberSetting("output-axis-2", AxisOfTable::target(1),
        AXISCOMP_TEXT("Error", "number of the axis of the second corrections, from 1")),
    axisNumberSetting("output-axis-3", AxisOfTable::target(2),
        AXISCOMP_TEXT("Error", "number of the axis of the third corrections, from 1"))};

constexpr std::array<std::string_view, 7> rules{
    ":START2D ROW COLUMN OUT1 OUT2 distRow distColumn columns begins a table, further :START2D "
    "lines add options, numbers follow, :END ends it; ; and ' begin comments.",
    "Axes are numbered from 1.",
    "Each point has a pair of corrections, for OUT1 and OUT2; with OUTAXIS3 a triple.",
    "The lines of the file go along the row axis, the points in a line along the column axis.",
    "Point k lies at distance * k - OFFSETROW or OFFSETCOL; distances may be negative. Blanks "
    "round = are allowed.",
    "A unit may be divided by a number: with METRIC/1000 values are in micrometres.",
    "The correction is added to the commanded position. Between the points it is bilinear; "
    "outside, that at the nearest end is held.",
};
constexpr std::array<std::string_view, 5> assumptions{
    "NEGCOR: the corrections count with the opposite sign.",
    "METRIC is mm, for axes that a setting calls rotary degrees; ENGLISH is inch, and refused for "
    "these.",
    "COUNTS are counts of the axis, which become primary units only with the setting "
    "counts-per-unit.",
    "A table of one column is written with corrections of 0 for one of its sources besides.",
    "SERIALNUMBER, HOMEDIRECTION and HOMEOFFSET say nothing about the table.",
};

/// What stands behind the first :START2D.
struct Head {
    std::array<std::int64_t, 2> sources{}; ///< column axis, row axis
    std::vector<std::int64_t> outputs;
    std::array<double, 2> distances{}; ///< likewise
    std::int64_t columns = 0;
};

std::optional<std::int64_t> axisOf(const Token& token, DiagnosticList& diagnostics)
{
    const auto number = readWholeNumber(
        token, AXISCOMP_TEXT("Error", "the number of an axis, from 1"), diagnostics);
    if (!number || *number >= 1)
        return number;
    diagnostics.error(DiagnosticCode::LimitExceeded, token.line, token.column,
        AXISCOMP_TEXT("Error", "axis {number}").with("number", *number),
        AXISCOMP_TEXT("Error", "the number of an axis, from 1"));
    return std::nullopt;
}

std::optional<Head> readHead(const aerotech::Block& block, DiagnosticList& diagnostics)
{
    const std::vector<Token>& numbers = block.numbers;
    if (numbers.size() != 7) {
        diagnostics.error(DiagnosticCode::Syntax, block.start.line, block.start.column,
            Verbatim{excerpt(block.start.text, Encoding::Utf8)},
            AXISCOMP_TEXT("Error",
                "7 numbers behind :START2D: row axis, column axis, two output axes, distance along "
                "rows, distance along columns, number of columns"));
        return std::nullopt;
    }
    Head head;
    const auto row = axisOf(numbers[0], diagnostics);
    const auto column = axisOf(numbers[1], diagnostics);
    const auto rowDistance =
        readNumber(numbers[4], AXISCOMP_TEXT("Error", "a distance"), diagnostics);
    const auto columnDistance =
        readNumber(numbers[5], AXISCOMP_TEXT("Error", "a distance"), diagnostics);
    const auto columns =
        readWholeNumber(numbers[6], AXISCOMP_TEXT("Error", "the number of columns"), diagnostics);
    std::vector<Token> outputs{numbers[2], numbers[3]};
    if (const aerotech::Option* const third = block.option("OUTAXIS3"))
        outputs.push_back(third->value ? third->value : third->key);
    for (const Token& output : outputs)
        if (const auto axis = axisOf(output, diagnostics))
            head.outputs.push_back(*axis);
    if (!row || !column || !rowDistance || !columnDistance || !columns
        || head.outputs.size() != outputs.size())
        return std::nullopt;
    head.sources = {*column, *row};
    head.distances = {*columnDistance, *rowDistance};
    head.columns = *columns;
    for (std::size_t n = 0; n < 2; ++n)
        if (head.distances[n] == 0.0)
            diagnostics.error(DiagnosticCode::LimitExceeded, numbers[5 - n].line,
                numbers[5 - n].column, AXISCOMP_TEXT("Error", "a distance of 0"),
                AXISCOMP_TEXT("Error", "a distance that is not 0"));
    if (*columns < 2)
        diagnostics.error(DiagnosticCode::LimitExceeded, numbers[6].line, numbers[6].column,
            AXISCOMP_COUNTED("Error", "{count} columns", "1 column").with("count", *columns),
            AXISCOMP_TEXT("Error", "at least 2"));
    if (head.sources[0] == head.sources[1])
        diagnostics.error(DiagnosticCode::Contradiction, numbers[1].line, numbers[1].column,
            AXISCOMP_TEXT("Error", "axis {number} for rows and columns").with("number", *column),
            AXISCOMP_TEXT("Error", "two axes"));
    return head;
}

/// How many rows there are; an error names the first line that does not have a whole row.
std::optional<std::size_t> rowCount(
    const aerotech::Block& block, const Head& head, DiagnosticList& diagnostics)
{
    const std::size_t outputs = head.outputs.size();
    const std::size_t points = block.values.size() / outputs;
    const auto columns = static_cast<std::size_t>(head.columns);
    if (block.values.size() % outputs == 0 && points % columns == 0) {
        const std::size_t rows = points / columns;
        if (rows >= 2)
            return rows;
        diagnostics.error(DiagnosticCode::TooFewPoints, block.start.line, 0,
            AXISCOMP_COUNTED("Error", "{count} rows", "1 row").with("count", rows),
            AXISCOMP_TEXT("Error", "at least 2"));
        return std::nullopt;
    }
    const auto odd = std::ranges::find_if(block.lines, [&](const aerotech::Block::Line& line) {
        return line.count % outputs != 0 || line.count / outputs != columns;
    });
    const std::size_t at = odd == block.lines.end() ? block.start.line : odd->line;
    diagnostics.error(DiagnosticCode::ColumnCount, at, 0,
        odd == block.lines.end()
            ? AXISCOMP_COUNTED("Error", "{count} corrections", "1 correction")
                  .with("count", block.values.size())
            : AXISCOMP_COUNTED("Error", "{count} corrections in this line, {all} in all",
                "1 correction in this line, {all} in all")
                  .with("count", odd->count)
                  .with("all", block.values.size()),
        AXISCOMP_TEXT("Error", "{number} points of {number2} corrections each in a row")
            .with("number", head.columns)
            .with("number2", outputs));
    return std::nullopt;
}

/// One output of the table, in the order of ascending positions.
std::vector<double> valuesOf(const aerotech::Block& block, std::size_t output, std::size_t outputs,
    const std::array<aerotech::Sampling, 2>& samplings, double factor)
{
    const std::size_t width = samplings[0].count;
    const std::size_t height = samplings[1].count;
    std::vector<double> values(width * height);
    for (std::size_t j = 0; j < height; ++j)
        for (std::size_t i = 0; i < width; ++i) {
            const std::size_t x = samplings[0].isDownwards() ? width - 1 - i : i;
            const std::size_t y = samplings[1].isDownwards() ? height - 1 - j : j;
            const double value = block.values[(j * width + i) * outputs + output];
            values[y * width + x] = value / factor;
        }
    return values;
}

std::optional<NeutralTable> tableOf(aerotech::Block& block, const TextReading& reading)
{
    DiagnosticList& diagnostics = reading.diagnostics;
    aerotech::checkOptions(block, known, diagnostics);
    const auto head = readHead(block, diagnostics);
    const auto offsetRow = aerotech::numberOption(block, "OFFSETROW", 0.0, diagnostics);
    const auto offsetColumn = aerotech::numberOption(block, "OFFSETCOL", 0.0, diagnostics);
    const auto positionUnit = aerotech::unitOption(block, "POSUNIT", reading);
    const auto valueUnit = aerotech::unitOption(block, "CORUNIT", reading);
    if (!head || !offsetRow || !offsetColumn || !positionUnit || !valueUnit
        || !aerotech::areKnownApart(*positionUnit, *valueUnit, diagnostics)
        || diagnostics.hasErrors())
        return std::nullopt;
    const auto rows = rowCount(block, *head, diagnostics);
    if (!rows)
        return std::nullopt;
    aerotech::remarkHome(block, diagnostics);
    const std::array samplings{aerotech::Sampling{head->distances[0], *offsetColumn,
                                   static_cast<std::size_t>(head->columns)},
        aerotech::Sampling{head->distances[1], *offsetRow, *rows}};
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.notes = std::move(block.notes);
    for (std::size_t n = 0; n < 2; ++n) {
        SourceAxis& axis = table.axes.emplace_back();
        axis.name = std::to_string(head->sources[n]);
        axis.unit = positionUnit->of(reading, axis.name);
        axis.knots = samplings[n].knots(positionUnit->perUnit);
        const std::size_t line = block.start.line;
        if (!checkKnots(axis.knots, std::span(&line, 1),
                AXISCOMP_TEXT("Error", "axis {number}").with("number", head->sources[n]),
                diagnostics))
            return std::nullopt;
    }
    const double factor = (block.option("NEGCOR") ? -1.0 : 1.0) * valueUnit->perUnit;
    for (std::size_t n = 0; n < head->outputs.size(); ++n) {
        CompensationColumn& column = table.columns.emplace_back();
        column.target = std::to_string(head->outputs[n]);
        column.unit = valueUnit->of(reading, column.target);
        column.values = valuesOf(block, n, head->outputs.size(), samplings, factor);
    }
    return aerotech::areFinite(table, block, diagnostics) ? std::optional(table) : std::nullopt;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    std::vector<NeutralTable> tables;
    for (aerotech::Block& block : aerotech::readBlocks(reading, directive))
        if (auto table = tableOf(block, reading))
            tables.push_back(std::move(*table));
    warnOfAddedTables(tables, reading.diagnostics);
    return tables;
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    AXISCOMP_CHECK(checkCounts(aerotech_2d::format().facts, options.settings));
    return readText(aerotech_2d::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return aerotech::recogniseFile(text, directive);
}

/// The table with the numbers of its axes, and with a second column at least.
Result<NeutralTable> numbered(const NeutralTable& source, const SettingValues& given)
{
    const FormatFacts& facts = aerotech_2d::format().facts;
    NeutralTable table = source;
    constexpr std::array<std::string_view, 2> sourceKeys{"column-axis", "row-axis"};
    for (std::size_t n = 0; n < 2; ++n) {
        AXISCOMP_TRY(const auto axis, axisNumber(facts, given, sourceKeys[n], source.axes[n].name));
        table.axes[n].name = std::to_string(axis);
    }
    AXISCOMP_CHECK(checkTwoSources(table.axes[0].name, table.axes[1].name, sourceKeys));
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        // A target that is one of the sources has the number of that source.
        const auto own = ownAxis(source, source.columns[n]);
        const std::string name =
            own ? table.axes[*own].name : targetName(source, source.columns[n]);
        AXISCOMP_TRY(const auto axis,
            axisNumber(facts, given, "output-axis-" + std::to_string(n + 1), name));
        table.columns[n].target = std::to_string(axis);
    }
    if (table.columns.size() > 1)
        return table;
    CompensationColumn idle;
    const bool isFirst = table.columns[0].target == table.axes[0].name;
    const SourceAxis& other = table.axes[isFirst ? 1 : 0];
    idle.target = other.name;
    idle.unit = other.unit;
    idle.values.assign(table.pointCount(), 0.0);
    table.columns.push_back(std::move(idle));
    return table;
}

std::string tableText(const NeutralTable& table, const std::string& unit)
{
    const aerotech::Sampling column = aerotech::samplingOf(table.axes[0]);
    const aerotech::Sampling row = aerotech::samplingOf(table.axes[1]);
    std::string text = noteLines(table, "; ");
    text += ":START2D " + table.axes[1].name + ' ' + table.axes[0].name + ' '
        + table.columns[0].target + ' ' + table.columns[1].target + ' ' + plainNumber(row.distance)
        + ' ' + plainNumber(column.distance) + ' ' + std::to_string(column.count) + '\n';
    text += ":START2D POSUNIT=" + unit + " CORUNIT=" + unit + '\n';
    text += ":START2D OFFSETROW=" + plainNumber(row.offset)
        + " OFFSETCOL=" + plainNumber(column.offset) + '\n';
    if (table.columns.size() == mostOutputs)
        text += ":START2D OUTAXIS3=" + table.columns[2].target + '\n';
    for (std::size_t i = 0; i < table.pointCount(); ++i) {
        for (const CompensationColumn& output : table.columns)
            text += plainNumber(output.values[i]) + (&output == &table.columns.back() ? "" : " ");
        text += (i + 1) % column.count == 0 ? "\n" : "  ";
    }
    return text + ":END\n";
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const TableFormat& format = aerotech_2d::format();
    AXISCOMP_TRY(const auto given, SettingValues::of(format.facts, options.settings, true));
    WrittenTables written;
    std::vector<NeutralTable> prepared;
    for (const NeutralTable& source : tables) {
        AXISCOMP_TRY(auto named, numbered(source, given));
        AXISCOMP_TRY(auto table, aerotech::inFileUnits(named, given, written.remarks));
        written.bytes += tableText(table, aerotech::unitWord(given));
        prepared.push_back(std::move(table));
    }
    AXISCOMP_TRY(
        auto held, readBack(format, written.bytes, aerotech::readingSettings(prepared, given)));
    if (given.text("units") == "primary")
        takeWrittenUnits(held, prepared);
    written.held = std::move(held);
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "aerotech-2d",
            .controller = "Aerotech",
            .description = AXISCOMP_TEXT("Error", "calibration file of two axes (:START2D)"),
            .extensions = extensions,
            .fewestDimensions = 2,
            .mostDimensions = 2,
            .knots = KnotRule::Even,
            .mostColumns = mostOutputs,
            .mostTables = 0,
            .addsTables = true,
            .holdsUnits = true,
            .holdsNotes = true,
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

} // namespace axiscomp::aerotech_2d
