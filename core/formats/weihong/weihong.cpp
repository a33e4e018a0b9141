// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/axis_letter.h"
#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/formats/formats.h"
#include "core/formats/units.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <set>

namespace axiscomp::weihong {

namespace {

constexpr std::string_view usualAxes = "XYZ";

constexpr std::array<std::string_view, 1> extensions{".dat"};
constexpr std::array settings{FormatSetting{.key = "axis",
    .kind = FormatSetting::Kind::Choice,
    .meaning = AXISCOMP_TEXT("Error", "axis of the table, where the table names none of these"),
    .choices = "X, Y, Z",
    .forWriting = true,
    .namedAxis = AxisOfTable::source(0)}};

constexpr std::array<std::string_view, 8> rules{
    "A line unit=mm, a section [X], [Y] or [Z] for each axis, and in it lines nominal, forward "
    "error, backward error. Comments have lines of their own, which begin with ;.",
    "unit=mm stands behind ; in the published example, so a comment of that form counts as well; "
    "mm is the only unit.",
    "Nominal is the machine coordinate with its sign, from the reference point, strictly "
    "ascending, not necessarily even; outside of the stroke of the axis the compensation is "
    "invalid.",
    "Forward is the motion towards larger coordinates, backward towards smaller ones. Two lines "
    "are enough for the backlash alone.",
    "The file is axeserr.dat in the folder of the software, which reads it when it starts; the "
    "NK200 takes it from a USB stick.",
    "The parameter Screw error compensation is 0: none, 1: one direction, 2: both directions. With "
    "1, Backlash compensation valid adds the backlash.",
    "Three decimals are usual.",
    "The values are errors, and in the published case of backlash alone forward is 0.000 and "
    "backward +0.030.",
};
constexpr std::array<std::string_view, 4> assumptions{
    "An error is actual - nominal position, as in the case of the backlash: an axis with play that "
    "comes back stays behind, at a larger coordinate. No sentence of the manuals says it.",
    "Outside of the table the value at that end is held.",
    "Between the points the value is linear.",
    "Sections of other letters are read like those of X, Y and Z, with a warning.",
};

struct Entry {
    double nominal = 0.0;
    double forward = 0.0;
    double backward = 0.0;
    std::size_t line = 0;
};
struct Section {
    Token header;
    std::string axis;
    std::vector<Entry> entries;
};

/// "unit = mm": the unit; nothing: another line.
std::optional<Token> unitOf(const Token& line)
{
    const std::size_t equals = line.text.find('=');
    if (equals == std::string_view::npos
        || !sameLetters(trimmed(line.text.substr(0, equals)), "unit"))
        return std::nullopt;
    return trimmedToken(line.part(equals + 1));
}

/// "[X]": the letter; nothing: no line of that form.
std::optional<std::string> axisOf(std::string_view line)
{
    if (!line.starts_with('[') || !line.ends_with(']'))
        return std::nullopt;
    const std::string_view inner = trimmed(line.substr(1, line.size() - 2));
    if (inner.size() != 1)
        return std::nullopt;
    std::string letter = capitals(inner);
    if (letter.front() < 'A' || letter.front() > 'Z')
        return std::nullopt;
    return letter;
}

/// The lines of a file, section by section.
class FileReader {
public:
    explicit FileReader(TextReading& source) : m_source(source), m_diagnostics(source.diagnostics)
    {
    }

    [[nodiscard]] std::vector<NeutralTable> tables();

private:
    void take(const Token& line);
    void takeComment(const Token& comment);
    void takeUnit(const Token& unit);
    void takeHeader(const Token& line);
    void takeEntry(const Token& line);
    [[nodiscard]] std::optional<NeutralTable> tableOf(const Section& section);

    TextReading& m_source;
    DiagnosticList& m_diagnostics;
    std::vector<Section> m_sections;
    std::vector<std::string> m_notes;
    std::vector<Token> m_cells;
    bool m_hasUnit = false;
};

void FileReader::takeUnit(const Token& unit)
{
    m_hasUnit = true;
    if (!sameLetters(unit.text, "mm"))
        m_diagnostics.error(DiagnosticCode::Contradiction, unit.line, unit.column,
            AXISCOMP_TEXT("Error", "the unit \"{unit}\"").with("unit", quoted(unit)),
            AXISCOMP_TEXT("Error", "mm, the only unit of this file"));
}

void FileReader::takeComment(const Token& comment)
{
    if (const auto unit = unitOf(comment))
        takeUnit(*unit);
    else
        keepNote(m_notes, comment.text);
}

void FileReader::takeHeader(const Token& line)
{
    const auto axis = axisOf(line.text);
    if (!axis) {
        m_diagnostics.error(DiagnosticCode::Syntax, line.line, line.column, quoted(line),
            AXISCOMP_TEXT("Error", "the letter of an axis between brackets, such as [X]"));
        return;
    }
    if (usualAxes.find(*axis) == std::string_view::npos)
        m_diagnostics.warning(DiagnosticCode::Assumption, line.line, line.column,
            AXISCOMP_TEXT("Error", "a section of axis {axis}").with("axis", *axis),
            AXISCOMP_TEXT("Error", "X, Y or Z"));
    const auto other = std::ranges::find(m_sections, *axis, &Section::axis);
    if (other != m_sections.end())
        m_diagnostics.error(DiagnosticCode::Contradiction, line.line, line.column,
            AXISCOMP_TEXT("Error", "a second section of axis {axis}").with("axis", *axis),
            AXISCOMP_TEXT("Error", "each axis once; the first is in line {line}")
                .with("line", other->header.line));
    m_sections.push_back({line, *axis, {}});
}

void FileReader::takeEntry(const Token& line)
{
    if (m_sections.empty()) {
        m_diagnostics.error(DiagnosticCode::Syntax, line.line, line.column, quoted(line),
            AXISCOMP_TEXT("Error", "a section such as [X] before the first numbers"));
        return;
    }
    splitCells(line, ',', m_cells);
    if (m_cells.size() != 3) {
        m_diagnostics.error(DiagnosticCode::ColumnCount, line.line, 0,
            AXISCOMP_COUNTED("Error", "{count} numbers between commas", "1 number between commas")
                .with("count", m_cells.size()),
            AXISCOMP_TEXT("Error",
                "3, with decimal points: nominal position, forward error, backward error"));
        return;
    }
    const auto nominal =
        readNumber(m_cells[0], AXISCOMP_TEXT("Error", "a position in mm"), m_diagnostics);
    const auto forward =
        readNumber(m_cells[1], AXISCOMP_TEXT("Error", "a forward error in mm"), m_diagnostics);
    const auto backward =
        readNumber(m_cells[2], AXISCOMP_TEXT("Error", "a backward error in mm"), m_diagnostics);
    if (nominal && forward && backward)
        m_sections.back().entries.push_back({*nominal, *forward, *backward, line.line});
}

void FileReader::take(const Token& line)
{
    if (line.text.starts_with(';'))
        takeComment(trimmedToken(line.part(1)));
    else if (line.text.starts_with('['))
        takeHeader(line);
    else if (const auto unit = unitOf(line))
        takeUnit(*unit);
    else
        takeEntry(line);
}

std::optional<NeutralTable> FileReader::tableOf(const Section& section)
{
    NeutralTable table;
    table.sign = SignConvention::Feedback;
    SourceAxis& axis = table.axes.emplace_back();
    axis.name = section.axis;
    axis.unit = "mm";
    std::vector<std::size_t> lines;
    std::array<std::vector<double>, 2> errors;
    for (const Entry& entry : section.entries) {
        axis.knots.push_back(entry.nominal);
        lines.push_back(entry.line);
        errors[0].push_back(entry.forward);
        errors[1].push_back(entry.backward);
    }
    if (lines.empty())
        lines.push_back(section.header.line);
    if (!checkKnots(axis.knots, lines,
            AXISCOMP_TEXT("Error", "axis {axis}").with("axis", section.axis), m_diagnostics))
        return std::nullopt;
    const bool isPair = errors[0] != errors[1];
    for (std::size_t n = 0; n < (isPair ? 2U : 1U); ++n) {
        CompensationColumn& column = table.columns.emplace_back();
        column.target = section.axis;
        column.unit = "mm";
        if (isPair)
            column.direction = n == 0 ? Direction::Positive : Direction::Negative;
        column.values = std::move(errors[n]);
    }
    return table;
}

std::vector<NeutralTable> FileReader::tables()
{
    TextLines lines(m_source.text);
    while (const auto line = lines.next()) {
        if (m_source.isStopped())
            return {};
        if (const Token content = trimmedToken(*line))
            take(content);
    }
    if (m_sections.empty() && !m_diagnostics.hasErrors())
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "a section such as [X], of which there is none"));
    if (!m_hasUnit)
        m_diagnostics.warning(DiagnosticCode::UnitNotGiven, 0, 0,
            AXISCOMP_TEXT("Error", "no line unit=mm"),
            AXISCOMP_TEXT("Error", "that line; mm is the only unit"));
    std::vector<NeutralTable> tables;
    for (const Section& section : m_sections)
        if (auto table = tableOf(section))
            tables.push_back(std::move(*table));
    if (!tables.empty())
        tables.front().notes = std::move(m_notes);
    return tables;
}

std::vector<NeutralTable> parse(TextReading& source)
{
    return FileReader(source).tables();
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(weihong::format().facts, text, options, parse);
}

bool areThreeNumbers(const Token& line)
{
    std::vector<Token> cells;
    splitCells(line, ',', cells);
    return cells.size() == 3 && std::ranges::all_of(cells, [](const Token& cell) {
        return numberOf(cell.text).has_value();
    });
}

/// The section of an axis, and its first line of numbers.
Recognition recognise(std::string_view text)
{
    TextLines lines(text);
    bool isInAxis = false;
    while (const auto line = lines.next()) {
        const Token content = trimmedToken(*line);
        if (!content || content.text.starts_with(';'))
            continue;
        if (isInAxis && areThreeNumbers(content))
            return Recognition::Certain;
        const auto axis = axisOf(content.text);
        isInAxis = axis && usualAxes.find(*axis) != std::string_view::npos;
    }
    return Recognition::No;
}

/// Comments that would be taken for the unit are left out.
std::string commentLines(const NeutralTable& table)
{
    NeutralTable plain;
    for (const std::string& note : table.notes)
        if (!unitOf({note, 0, 0}))
            plain.notes.push_back(note);
    return noteLines(plain, "; ");
}

Result<std::string> sectionLines(
    const NeutralTable& source, const std::string& axis, std::vector<Text>& remarks)
{
    const FormatFacts& facts = weihong::format().facts;
    AXISCOMP_CHECK(checkOwnAxis(
        facts, source, AXISCOMP_TEXT("Error", "choose a format for cross compensation")));
    AXISCOMP_TRY(const auto table, inUnits(source, "mm", {}, remarks));
    AXISCOMP_TRY(const auto pair, directionPair(facts, table));
    const std::vector<double>& forward = pair.positive->values;
    const std::vector<double>& backward = pair.negative ? pair.negative->values : forward;
    std::string text = '[' + axis + "]\n";
    for (std::size_t i = 0; i < forward.size(); ++i)
        text += plainNumber(table.axes.front().knots[i]) + ", " + plainNumber(forward[i]) + ", "
            + plainNumber(backward[i]) + '\n';
    return text;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const TableFormat& format = weihong::format();
    AXISCOMP_TRY(const auto given, SettingValues::of(format.facts, options.settings, true));
    WrittenTables written;
    written.bytes = ";unit=mm\n";
    for (const NeutralTable& table : tables)
        written.bytes += commentLines(table);
    std::set<std::string> axes;
    bool hasDirections = false;
    for (const NeutralTable& table : tables) {
        AXISCOMP_TRY(const auto axis,
            axisLetter(format.facts, given, "axis", table.axes.front().name, usualAxes));
        if (!axes.insert(axis).second)
            return cannotHold(format.facts,
                AXISCOMP_TEXT("Error", "there are two tables for axis {axis}").with("axis", axis),
                AXISCOMP_TEXT("Error", "choose one of them"));
        AXISCOMP_TRY(auto lines, sectionLines(table, axis, written.remarks));
        written.bytes += lines;
        hasDirections = hasDirections || table.columns.size() > 1;
    }
    AXISCOMP_TRY(auto held, readBack(format, written.bytes, {}));
    written.held = std::move(held);
    written.remarks.push_back(AXISCOMP_TEXT("Error",
        "the file is axeserr.dat in the folder of the software (NK200: from a USB stick), read "
        "when the software starts"));
    written.remarks.push_back((hasDirections
            ? AXISCOMP_TEXT(
                "Error", "set the parameter Screw error compensation to 2: both directions")
            : AXISCOMP_TEXT("Error",
                "set the parameter Screw error compensation to 2, or to 1 with the backlash as a "
                "parameter of its own")));
    written.remarks.push_back(AXISCOMP_TEXT("Error",
        "positions are machine coordinates from the reference point and must lie within the "
        "stroke, else the compensation is invalid"));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{.facts = {.name = "weihong",
                                        .controller = "Weihong NcStudio, NK200, EasyRoute",
                                        .description = AXISCOMP_TEXT("Error",
                                            "axeserr.dat: screw errors forwards and backwards"),
                                        .extensions = extensions,
                                        .knots = KnotRule::Any,
                                        .mostTables = 0,
                                        .holdsNames = true,
                                        .holdsUnits = true,
                                        .holdsNotes = true,
                                        .holdsDirections = true,
                                        .numbers = "decimal text",
                                        .sign = SignConvention::Feedback,
                                        .signEvidence = Evidence::Assumed,
                                        .behaviour = {.outside = Outside::Hold},
                                        .outsideEvidence = Evidence::Assumed,
                                        .settings = settings,
                                        .rules = rules,
                                        .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::weihong
