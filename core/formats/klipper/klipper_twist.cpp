// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"
#include "core/formats/formats.h"
#include "core/formats/klipper/klipper_config.h"
#include "core/text/decimal_comma.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <map>

namespace axiscomp::klipper_twist {

namespace {

using klipper::AutosavedPart;
using klipper::configLine;
using klipper::sectionOf;

constexpr std::string_view sectionName = "axis_twist_compensation";
constexpr std::string_view meshPrefix = "bed_mesh ";

constexpr std::array<std::string_view, 1> extensions{".cfg"};
constexpr std::array<std::string_view, 6> rules{
    "The section [axis_twist_compensation] of printer.cfg, which may stand behind #*# as "
    "SAVE_CONFIG "
    "writes it.",
    "z_compensations holds values evenly from compensation_start_x to compensation_end_x, "
    "zy_compensations from compensation_start_y to compensation_end_y.",
    "Earlier firmware looked the values up between calibrate_start_x and calibrate_end_x, the "
    "first "
    "one between start_x and end_x.",
    "The value is added to the height that the probe measures: the mean of probe - nozzle less "
    "probe "
    "- nozzle at the point.",
    "Between the values it is linear; outside, the cell at that end is extrapolated.",
    "It corrects what the probe measures, not how the machine moves.",
};
constexpr std::array<std::string_view, 2> assumptions{
    "The table is read as an error of Z over X or over Y. Written to a drive it corrects motion, "
    "which the firmware does not do with it: use it only where the nozzle itself tilts or sags as "
    "was measured.",
    "Positions and values are in mm.",
};

/// The lines of an entry: a list may go on in lines that begin with a blank.
using Entry = std::vector<Token>;
using Entries = std::map<std::string, Entry, std::less<>>;

/// What is said in all sections of this name, which the firmware joins.
struct Section {
    bool isThere = false;
    std::size_t line = 0;
    Entries entries;
};

Section sectionIn(TextReading& reading)
{
    Section section;
    bool isInside = false;
    Entry* last = nullptr;
    TextLines lines(reading.text);
    AutosavedPart autosaved;
    while (const auto whole = lines.next()) {
        if (reading.isStopped())
            return {};
        if (autosaved.beginsAt(*whole))
            isInside = false;
        const Token line = configLine(*whole);
        const Token content = trimmedToken(line);
        if (!content)
            continue;
        if (const auto name = sectionOf(line)) {
            isInside = name->text == sectionName;
            last = nullptr;
            if (isInside && !section.isThere)
                section.line = name->line;
            section.isThere = section.isThere || isInside;
            continue;
        }
        if (!isInside)
            continue;
        const bool isContinued = line.text.front() == ' ' || line.text.front() == '\t';
        const std::size_t equals = content.text.find_first_of("=:");
        if (isContinued && last) {
            last->push_back(content);
        } else if (equals == std::string_view::npos) {
            reading.diagnostics.error(DiagnosticCode::Syntax, content.line, content.column,
                Verbatim{excerpt(content.text, Encoding::Utf8)},
                AXISCOMP_TEXT("Error", "an entry such as {example}")
                    .with("example", Verbatim{"calibrate_start_x = 20"}));
        } else {
            const Token key = trimmedToken(content.part(0, equals));
            const auto [entry, isNew] = section.entries.try_emplace(std::string(key.text));
            if (!isNew)
                reading.diagnostics.warning(DiagnosticCode::Assumption, key.line, key.column,
                    AXISCOMP_TEXT("Error", "a second {key}").with("key", key.text),
                    AXISCOMP_TEXT("Error", "each entry once; the last one counts"));
            last = &entry->second;
            last->clear();
            const Token value = trimmedToken(content.part(equals + 1));
            if (value)
                last->push_back(value);
        }
    }
    return section;
}

/// One of the two lists, and the entries that may say from where to where it goes.
struct List {
    const char* axis;
    std::string_view values;
    std::array<std::string_view, 3> starts; ///< the one of today first; empty: there is none
    std::array<std::string_view, 3> ends;
};
constexpr std::array lists{
    List{"X", "z_compensations", {"compensation_start_x", "calibrate_start_x", "start_x"},
        {"compensation_end_x", "calibrate_end_x", "end_x"}},
    List{"Y", "zy_compensations", {"compensation_start_y", "calibrate_start_y", ""},
        {"compensation_end_y", "calibrate_end_y", ""}},
};

std::vector<double> valuesOf(const Entry& entry, DiagnosticList& diagnostics)
{
    std::vector<double> values;
    std::vector<Token> cells;
    DecimalCommaCheck commas;
    for (const Token& line : entry) {
        commas.take(line);
        splitCells(line, ',', cells);
        if (cells.size() > 1 && !cells.back() && &line != &entry.back())
            cells.pop_back(); // the list goes on in the next line
        for (const Token& cell : cells)
            values.push_back(readNumber(cell, AXISCOMP_TEXT("Error", "a value in mm"), diagnostics)
                                 .value_or(0.0));
    }
    if (const Token number = commas.doubtful())
        diagnostics.error(DiagnosticCode::NotANumber, number.line, number.column,
            Verbatim{excerpt(number.text, Encoding::Utf8)},
            AXISCOMP_TEXT("Error",
                "decimal points, and a comma with a blank between the values; nobody can tell a "
                "decimal comma from one that separates two values"));
    return values;
}

std::optional<double> positionOf(const Entry& entry, DiagnosticList& diagnostics)
{
    if (entry.empty())
        return std::nullopt;
    return readNumber(entry.front(), AXISCOMP_TEXT("Error", "a position in mm"), diagnostics);
}

class ListReader {
public:
    ListReader(const List& list, const Section& section, TextReading& reading)
        : m_list(list)
        , m_section(section)
        , m_diagnostics(reading.diagnostics)
    {
    }
    /// Without knots after an error.
    [[nodiscard]] NeutralTable table();

private:
    struct Range {
        const Entry* start = nullptr;
        const Entry* end = nullptr;
    };
    [[nodiscard]] std::optional<Range> range();

    const List& m_list;
    const Section& m_section;
    DiagnosticList& m_diagnostics;
};

std::optional<ListReader::Range> ListReader::range()
{
    const auto entry = [this](std::string_view key) -> const Entry* {
        const auto found = m_section.entries.find(key);
        return key.empty() || found == m_section.entries.end() || found->second.empty()
            ? nullptr
            : &found->second;
    };
    for (std::size_t n = 0; n < m_list.starts.size(); ++n) {
        const Range range{entry(m_list.starts[n]), entry(m_list.ends[n])};
        if (!range.start || !range.end)
            continue;
        if (n > 0)
            m_diagnostics.warning(DiagnosticCode::Assumption, range.start->front().line, 0,
                AXISCOMP_TEXT("Error", "{key} and {key2} as the ends of {list}")
                    .with("key", m_list.starts[n])
                    .with("key2", m_list.ends[n])
                    .with("list", m_list.values),
                AXISCOMP_TEXT("Error", "{key} and {key2}, as later firmware writes them")
                    .with("key", m_list.starts[0])
                    .with("key2", m_list.ends[0]));
        return range;
    }
    m_diagnostics.error(DiagnosticCode::Syntax, m_section.line, 0,
        Verbatim{std::string(sectionName)},
        AXISCOMP_TEXT("Error", "entries {key} and {key2} for {list}")
            .with("key", m_list.starts[0])
            .with("key2", m_list.ends[0])
            .with("list", m_list.values));
    return std::nullopt;
}

NeutralTable ListReader::table()
{
    NeutralTable table;
    table.sign = SignConvention::Feedback;
    const Entry& entry = m_section.entries.find(m_list.values)->second;
    std::vector<double> values = valuesOf(entry, m_diagnostics);
    const std::size_t count = values.size();
    if (count < 2)
        m_diagnostics.error(DiagnosticCode::TooFewPoints,
            entry.empty() ? m_section.line : entry.front().line, 0,
            AXISCOMP_COUNTED("Error", "{count} values", "1 value").with("count", count),
            AXISCOMP_TEXT("Error", "at least 2"));
    const auto found = range();
    if (!found)
        return table;
    const auto start = positionOf(*found->start, m_diagnostics);
    const auto end = positionOf(*found->end, m_diagnostics);
    if (start && end && !(*end > *start))
        m_diagnostics.error(DiagnosticCode::NotMonotonic, found->end->front().line, 0,
            AXISCOMP_TEXT("Error", "{number} after {number2}")
                .with("number", Quantity{toText(*end)})
                .with("number2", Quantity{toText(*start)}),
            AXISCOMP_TEXT("Error", "an end above the start"));
    if (m_diagnostics.hasErrors() || !start || !end)
        return table;
    SourceAxis axis;
    axis.name = m_list.axis;
    axis.unit = "mm";
    axis.knots = evenKnots(*start, (*end - *start) / static_cast<double>(count - 1), count);
    axis.knots.back() = *end;
    CompensationColumn column;
    column.target = "Z";
    column.unit = "mm";
    column.values = std::move(values);
    table.axes = {std::move(axis)};
    table.columns = {std::move(column)};
    return table;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    const Section section = sectionIn(reading);
    if (reading.diagnostics.hasErrors())
        return {};
    std::vector<NeutralTable> tables;
    for (const List& list : lists)
        if (section.entries.contains(list.values))
            tables.push_back(ListReader(list, section, reading).table());
    if (tables.empty() && !reading.isStopped())
        reading.diagnostics.error(DiagnosticCode::Syntax, section.line, 0, {},
            AXISCOMP_TEXT("Error", "a section [{section}] with {list} or {list2}")
                .with("section", Verbatim{std::string(sectionName)})
                .with("list", lists[0].values)
                .with("list2", lists[1].values));
    warnOfAddedTables(tables, reading.diagnostics);
    return tables;
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(klipper_twist::format().facts, text, options, parse);
}

/// A section with values, and no mesh, which would be what the file is looked at for.
Recognition recognise(std::string_view text)
{
    enum class Inside { Other, Twist, Mesh };
    Inside inside = Inside::Other;
    bool hasValues = false;
    TextLines lines(text);
    while (const auto whole = lines.next()) {
        const Token line = configLine(*whole);
        if (const auto section = sectionOf(line)) {
            inside = section->text == sectionName       ? Inside::Twist
                : section->text.starts_with(meshPrefix) ? Inside::Mesh
                                                        : Inside::Other;
            continue;
        }
        const std::size_t equals = line.text.find_first_of("=:");
        if (inside == Inside::Other || equals == std::string_view::npos)
            continue;
        const std::string_view key = trimmed(line.text.substr(0, equals));
        if (inside == Inside::Mesh && key == "points")
            return Recognition::No;
        const bool isList = key == lists[0].values || key == lists[1].values;
        hasValues = hasValues || (inside == Inside::Twist && isList);
    }
    return hasValues ? Recognition::Certain : Recognition::No;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "klipper-twist",
            .controller = "Klipper",
            .description = AXISCOMP_TEXT("Error",
                "[axis_twist_compensation] of printer.cfg: errors of the probe over X or Y"),
            .extensions = extensions,
            .knots = KnotRule::Even,
            .mostTables = lists.size(),
            .addsTables = true,
            .holdsNames = true,
            .holdsUnits = true,
            .numbers = "decimal text",
            .sign = SignConvention::Feedback,
            .signEvidence = Evidence::Code,
            .behaviour = {.outside = Outside::Extrapolate},
            .outsideEvidence = Evidence::Code,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read};
    return format;
}

} // namespace axiscomp::klipper_twist
