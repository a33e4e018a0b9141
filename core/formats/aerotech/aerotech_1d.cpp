// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/aerotech/aerotech_file.h"
#include "core/formats/formats.h"
#include "core/formats/units.h"
#include "core/text/text_file.h"

#include <algorithm>

namespace axiscomp::aerotech_1d {

namespace {

constexpr std::string_view directive = ":START";
constexpr std::string_view known[] = {"SAMPLEDIST", "POSUNIT", "CORUNIT", "OFFSET", "HOMEDIRECTION",
    "HOMEOFFSET", "NEGCOR", "SERIALNUMBER"};

constexpr std::array<std::string_view, 1> extensions{".cal"};
constexpr std::array settings{aerotech::rotaryAxes, aerotech::primaryUnit, aerotech::secondaryUnit,
    aerotech::countsPerUnit, aerotech::units,
    FormatSetting{.key = "axis",
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT(
            "Error", "number of the axis, from 1, instead of the table's name for it"),
        .forWriting = true,
        .namedAxis = AxisOfTable::source(0)}};

constexpr std::array<std::string_view, 6> rules{
    ":START AXIS SAMPLEDIST=d POSUNIT=u CORUNIT=u begins a table, further :START lines add "
    "options, numbers follow in any arrangement, :END ends it; ; and ' begin comments.",
    "Axes are numbered from 1.",
    "A unit may be divided by a number: with METRIC/1000 values are in micrometres.",
    "Correction k is for the position SAMPLEDIST * k - OFFSET; SAMPLEDIST may be negative.",
    "The correction is added to the commanded position. Between the points it is linear; outside, "
    "that at the nearest end is held.",
    "A file may hold several tables.",
};
constexpr std::array<std::string_view, 5> assumptions{
    "NEGCOR: the corrections count with the opposite sign.",
    "METRIC is mm, for axes that a setting calls rotary degrees; ENGLISH is inch, and refused for "
    "these.",
    "COUNTS are counts of the axis, which become primary units only with the setting "
    "counts-per-unit.",
    "HOMEDIRECTION and HOMEOFFSET do not move the table.",
    "SERIALNUMBER says nothing about the table.",
};

std::optional<NeutralTable> tableOf(aerotech::Block& block, const TextReading& reading)
{
    DiagnosticList& diagnostics = reading.diagnostics;
    aerotech::checkOptions(block, known, diagnostics);
    const Token first = block.numbers.empty() ? block.start : block.numbers.front();
    const auto axisNumber = wholeNumberOf(block.numbers.empty() ? "" : first.text);
    if (block.numbers.size() != 1 || axisNumber.value_or(0) < 1) {
        diagnostics.error(DiagnosticCode::Syntax, first.line, first.column,
            Verbatim{excerpt(first.text, Encoding::Utf8)},
            AXISCOMP_TEXT("Error", "the number of one axis, from 1, behind :START"));
        return std::nullopt;
    }
    const auto distance = aerotech::numberOption(block, "SAMPLEDIST", 0.0, diagnostics);
    const auto offset = aerotech::numberOption(block, "OFFSET", 0.0, diagnostics);
    const auto positionUnit = aerotech::unitOption(block, "POSUNIT", reading);
    const auto valueUnit = aerotech::unitOption(block, "CORUNIT", reading);
    if (distance && *distance == 0.0)
        diagnostics.error(DiagnosticCode::Syntax, block.start.line, 0, {},
            AXISCOMP_TEXT(
                "Error", "SAMPLEDIST= and the distance of the corrections, which is not 0"));
    if (block.values.size() < 2)
        diagnostics.error(DiagnosticCode::TooFewPoints, block.start.line, 0,
            AXISCOMP_COUNTED("Error", "{count} corrections", "1 correction")
                .with("count", block.values.size()),
            AXISCOMP_TEXT("Error", "at least 2"));
    if (!distance || !offset || !positionUnit || !valueUnit
        || !aerotech::areKnownApart(*positionUnit, *valueUnit, diagnostics)
        || diagnostics.hasErrors())
        return std::nullopt;
    aerotech::remarkHome(block, diagnostics);
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.notes = std::move(block.notes);
    const aerotech::Sampling sampling{*distance, *offset, block.values.size()};
    SourceAxis& axis = table.axes.emplace_back();
    axis.name = std::to_string(*axisNumber);
    axis.unit = positionUnit->of(reading, axis.name);
    axis.knots = sampling.knots(positionUnit->perUnit);
    const std::size_t line = block.start.line;
    if (!checkKnots(axis.knots, std::span(&line, 1),
            AXISCOMP_TEXT("Error", "axis {number}").with("number", *axisNumber), diagnostics))
        return std::nullopt;
    CompensationColumn& column = table.columns.emplace_back();
    column.target = axis.name;
    column.unit = valueUnit->of(reading, axis.name);
    column.values = std::move(block.values);
    const double scale = block.option("NEGCOR") ? -1.0 : 1.0;
    for (double& value : column.values)
        value = scale * value / valueUnit->perUnit;
    if (sampling.isDownwards())
        std::ranges::reverse(column.values);
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
    AXISCOMP_CHECK(checkCounts(aerotech_1d::format().facts, options.settings));
    return readText(aerotech_1d::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return aerotech::recogniseFile(text, directive);
}

std::string tableText(const NeutralTable& table, const std::string& unit)
{
    const aerotech::Sampling sampling = aerotech::samplingOf(table.axes[0]);
    std::string text = noteLines(table, "; ");
    text += ":START " + table.axes[0].name + " SAMPLEDIST=" + plainNumber(sampling.distance)
        + " POSUNIT=" + unit + " CORUNIT=" + unit + '\n';
    text += ":START OFFSET=" + plainNumber(sampling.offset) + '\n';
    constexpr std::size_t perLine = 10;
    const std::vector<double>& values = table.columns[0].values;
    for (std::size_t i = 0; i < values.size(); ++i)
        text += plainNumber(values[i])
            + (i % perLine == perLine - 1 || i + 1 == values.size() ? '\n' : ' ');
    return text + ":END\n";
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const TableFormat& format = aerotech_1d::format();
    AXISCOMP_TRY(const auto given, SettingValues::of(format.facts, options.settings, true));
    WrittenTables written;
    std::vector<NeutralTable> prepared;
    for (const NeutralTable& source : tables) {
        AXISCOMP_CHECK(checkOwnAxis(
            format.facts, source, AXISCOMP_TEXT("Error", "choose a table of an axis for itself")));
        AXISCOMP_TRY(
            const auto axis, axisNumber(format.facts, given, "axis", source.axes.front().name));
        AXISCOMP_TRY(auto table, aerotech::inFileUnits(source, given, written.remarks));
        table.axes[0].name = std::to_string(axis);
        table.columns[0].target = table.axes[0].name;
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
        .facts = {.name = "aerotech-1d",
            .controller = "Aerotech",
            .description = AXISCOMP_TEXT("Error", "calibration file of single axes (:START)"),
            .extensions = extensions,
            .knots = KnotRule::Even,
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

} // namespace axiscomp::aerotech_1d
