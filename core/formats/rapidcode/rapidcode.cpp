// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format_reader.h"
#include "core/formats/formats.h"
#include "core/formats/rapidcode/rapidcode_table.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::rapidcode {

namespace {

constexpr std::string_view firstLine = "# RapidCode compensator table";

constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array settings{
    FormatSetting{.key = "counts-per-unit",
        .kind = FormatSetting::Kind::Number,
        .meaning =
            AXISCOMP_TEXT("Error", "raw counts of the output axis for one unit of the values"),
        .forWriting = true,
        .isNeeded = true},
    FormatSetting{.key = "counts-per-unit",
        .kind = FormatSetting::Kind::Number,
        .meaning = AXISCOMP_TEXT("Error", "the same, where the file does not say it"),
        .forReading = true},
    FormatSetting{.key = "position-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error", "unit of the positions, the user unit of the input axes"),
        .forReading = true,
        .forWriting = true},
    FormatSetting{.key = "value-unit",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error",
            "unit of the values, the user unit of the output axis; otherwise that of the "
            "positions"),
        .forReading = true,
        .forWriting = true},
};
constexpr std::array<std::string_view, 6> rules{
    "A compensator has a minimum, a maximum and a delta for each of 1 or 2 input axes; maximum - "
    "minimum is an integer multiple of delta, and there are (maximum - minimum) / delta + 1 "
    "points.",
    "With two input axes there are as many points as the product of both; the first axis changes "
    "fastest.",
    "The values are raw counts of the output axis.",
    "The value is added to the position right before it is sent to the drive; the command position "
    "itself does not change.",
    "Between the points the value is linear.",
    "An axis can be input and output only with its command position as the input.",
};
constexpr std::array<std::string_view, 5> assumptions{
    "RSI takes tables by a function call, not from a file. This file is one of this program: lines "
    "that begin with # say axes, minimum, maximum, delta, units and counts per unit; then one line "
    "of counts for each position of the second axis.",
    "Minimum, maximum and delta are in user units of the input axes.",
    "Outside of the range there is no correction.",
    "Counts are written as whole numbers, at most 2147483647; decimals are read.",
    "A factor counts-per-unit may be negative, as user units may be.",
};

/// "input.1.min": what may stand in the comment lines, and where it stood.
struct Header {
    std::map<std::string, Token, std::less<>> entries;
    std::vector<std::string> notes;

    [[nodiscard]] const Token* find(std::string_view key) const
    {
        const auto entry = entries.find(key);
        return entry == entries.end() ? nullptr : &entry->second;
    }
    [[nodiscard]] std::string text(std::string_view key) const
    {
        const Token* const entry = find(key);
        return entry ? oneLine(entry->text) : std::string();
    }
};

bool isKnownKey(std::string_view key)
{
    constexpr std::array<std::string_view, 14> keys{"name", "input.1.axis", "input.1.unit",
        "input.1.min", "input.1.max", "input.1.delta", "input.2.axis", "input.2.unit",
        "input.2.min", "input.2.max", "input.2.delta", "output.axis", "output.unit",
        "output.counts-per-unit"};
    return std::ranges::find(keys, key) != keys.end();
}

/// A comment without an assignment is for people.
void takeComment(const Token& line, Header& header, TextReading& source)
{
    const std::size_t equals = line.text.find('=');
    if (equals == std::string_view::npos)
        return;
    const std::size_t hash = line.text.find('#') + 1;
    const Token key = trimmedToken(line.part(hash, equals - hash));
    const Token value = trimmedToken(line.part(equals + 1));
    if (key.text == "note") {
        header.notes.push_back(oneLine(value.text));
    } else if (!isKnownKey(key.text)) {
        source.diagnostics.warning(DiagnosticCode::UnknownKey, key.line, key.column,
            Verbatim{excerpt(key.text, Encoding::Utf8)}, {});
    } else if (!header.entries.emplace(std::string(key.text), value).second) {
        source.diagnostics.error(DiagnosticCode::Contradiction, key.line, key.column,
            AXISCOMP_TEXT("Error", "a second {key}").with("key", key.text),
            AXISCOMP_TEXT("Error", "each entry once"));
    }
}

/// The lines of counts, not yet looked into.
struct Contents {
    Header header;
    std::vector<Token> rows;
};

Contents contentsOf(TextReading& source)
{
    Contents contents;
    TextLines lines(source.text);
    while (const auto line = lines.next()) {
        const Token content = trimmedToken(*line);
        if (content.text.starts_with('#'))
            takeComment(*line, contents.header, source);
        else if (content)
            contents.rows.push_back(*line);
    }
    return contents;
}

std::optional<double> numberIn(const Header& header, const std::string& key, TextReading& source)
{
    const Token* const entry = header.find(key);
    if (!entry) {
        source.diagnostics.error(DiagnosticCode::Syntax, 1, 0, {},
            AXISCOMP_TEXT("Error", "a line \"# {key} = NUMBER\" before the counts")
                .with("key", key));
        return std::nullopt;
    }
    return readNumber(
        *entry, AXISCOMP_TEXT("Error", "a number for {key}").with("key", key), source.diagnostics);
}

std::optional<RapidCodeInput> inputOf(const Header& header, int number, TextReading& source)
{
    const std::string prefix = "input." + std::to_string(number) + ".";
    const auto minimum = numberIn(header, prefix + "min", source);
    const auto maximum = numberIn(header, prefix + "max", source);
    const auto delta = numberIn(header, prefix + "delta", source);
    if (!minimum || !maximum || !delta)
        return std::nullopt;
    const Token& place = *header.find(prefix + "delta");
    const Text range = AXISCOMP_TEXT("Error", "{number} to {number2} by {number3}")
                           .with("number", Quantity{toText(*minimum)})
                           .with("number2", Quantity{toText(*maximum)})
                           .with("number3", Quantity{toText(*delta)});
    if (!(*delta > 0.0 && *maximum > *minimum)) {
        source.diagnostics.error(DiagnosticCode::Contradiction, place.line, 0, range,
            AXISCOMP_TEXT("Error", "a maximum above the minimum, and a delta above 0"));
        return std::nullopt;
    }
    if ((*maximum - *minimum) / *delta >= static_cast<double>(rapidCodeMostPoints)) {
        source.diagnostics.error(DiagnosticCode::LimitExceeded, place.line, 0, range,
            AXISCOMP_TEXT("Error", "at most {number} points").with("number", rapidCodeMostPoints));
        return std::nullopt;
    }
    const auto points = rapidCodePoints(*minimum, *maximum, *delta);
    if (!points) {
        source.diagnostics.error(DiagnosticCode::Contradiction, place.line, 0, range,
            AXISCOMP_TEXT("Error", "a range that is an integer multiple of the delta"));
        return std::nullopt;
    }
    return RapidCodeInput{*minimum, *maximum, *delta, *points};
}

/// What the file or the setting says; both must say the same.
std::string agreedUnit(
    const Header& header, const std::string& key, std::string_view setting, TextReading& source)
{
    const std::string said = header.text(key);
    const std::string given = source.settings.text(setting);
    if (!said.empty() && !given.empty() && !isSameUnit(said, given))
        source.diagnostics.error(DiagnosticCode::Contradiction, header.find(key)->line, 0,
            AXISCOMP_TEXT("Error", "the unit {unit}").with("unit", said),
            AXISCOMP_TEXT("Error", "{value}, as the setting {key} says")
                .with("value", given)
                .with("key", setting));
    if (said.empty() && given.empty())
        source.diagnostics.warning(DiagnosticCode::UnitNotGiven, 0, 0,
            AXISCOMP_TEXT("Error", "no entry {name}").with("name", key),
            AXISCOMP_TEXT("Error", "the setting {key}, such as mm, where a unit matters")
                .with("key", setting));
    return said.empty() ? given : said;
}

std::optional<double> countsPerUnitOf(const Header& header, TextReading& source)
{
    constexpr std::string_view key = "output.counts-per-unit";
    const Token* const entry = header.find(key);
    const bool isSet = source.settings.has("counts-per-unit");
    const double given = source.settings.number("counts-per-unit");
    if (!entry && !isSet) {
        source.diagnostics.error(DiagnosticCode::UnitNotGiven, 0, 0,
            AXISCOMP_TEXT("Error", "values in counts"),
            AXISCOMP_TEXT("Error",
                "a line \"# output.counts-per-unit = NUMBER\", or the setting counts-per-unit"));
        return std::nullopt;
    }
    const auto said = entry
        ? readNumber(*entry, AXISCOMP_TEXT("Error", "a number of counts"), source.diagnostics)
        : given;
    if (said && isSet && *said != given)
        source.diagnostics.error(DiagnosticCode::Contradiction, entry->line, 0,
            AXISCOMP_TEXT("Error", "{number} counts per unit")
                .with("number", Quantity{toText(*said)}),
            AXISCOMP_TEXT("Error", "{value}, as the setting {key} says")
                .with("value", Quantity{toText(given)})
                .with("key", std::string_view("counts-per-unit")));
    if (said && *said == 0.0) {
        source.diagnostics.error(DiagnosticCode::Contradiction, entry ? entry->line : 0, 0,
            AXISCOMP_TEXT("Error", "{number} counts per unit").with("number", 0),
            AXISCOMP_TEXT("Error", "a number other than 0"));
        return std::nullopt;
    }
    return said;
}

std::vector<double> countsOf(
    const Contents& contents, std::size_t columns, std::size_t rows, TextReading& source)
{
    std::vector<double> counts;
    // No more than the text can have.
    counts.reserve(std::min(columns * rows, source.text.size() / 2));
    std::vector<Token> cells;
    for (std::size_t row = 0; row < contents.rows.size() && row < rows; ++row) {
        if (source.isStopped())
            return {};
        const Token& line = contents.rows[row];
        splitCells(line, ',', cells);
        if (cells.size() != columns) {
            source.diagnostics.error(DiagnosticCode::ColumnCount, line.line, 0,
                AXISCOMP_COUNTED("Error", "{count} values", "1 value").with("count", cells.size()),
                AXISCOMP_TEXT("Error", "{number}, one for each position of the first axis")
                    .with("number", columns));
            continue;
        }
        readNumbers(
            cells, AXISCOMP_TEXT("Error", "a number of counts"), counts, source.diagnostics);
    }
    const Text found = AXISCOMP_COUNTED("Error", "{count} lines of counts", "1 line of counts")
                           .with("count", contents.rows.size());
    const Text expected =
        (rows == 1 ? AXISCOMP_TEXT("Error", "one line")
                   : AXISCOMP_TEXT("Error", "{number}, one for each position of the second axis"))
            .with("number", rows);
    if (contents.rows.size() > rows)
        source.diagnostics.error(
            DiagnosticCode::Contradiction, contents.rows[rows].line, 0, found, expected);
    if (contents.rows.size() < rows)
        source.diagnostics.error(DiagnosticCode::MissingPoint, 0, 0, found, expected);
    return counts;
}

bool hasSecondInput(const Header& header)
{
    return std::ranges::any_of(
        header.entries, [](const auto& entry) { return entry.first.starts_with("input.2."); });
}

std::vector<NeutralTable> parse(TextReading& source)
{
    const Contents contents = contentsOf(source);
    const Header& header = contents.header;
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.name = header.text("name");
    table.notes = header.notes;
    std::vector<std::size_t> sizes;
    for (int number = 1; number <= (hasSecondInput(header) ? 2 : 1); ++number) {
        const std::string prefix = "input." + std::to_string(number) + ".";
        const auto input = inputOf(header, number, source);
        if (!input)
            continue;
        sizes.push_back(input->points);
        SourceAxis axis;
        axis.name = header.text(prefix + "axis");
        axis.unit = agreedUnit(header, prefix + "unit", "position-unit", source);
        axis.knots = input->knots();
        table.axes.push_back(std::move(axis));
    }
    const auto countsPerUnit = countsPerUnitOf(header, source);
    if (source.diagnostics.hasErrors())
        return {};
    CompensationColumn column;
    column.target = header.text("output.axis");
    column.unit = agreedUnit(header, "output.unit", "value-unit", source);
    column.values = countsOf(contents, sizes[0], sizes.size() > 1 ? sizes[1] : 1, source);
    for (double& value : column.values)
        value /= *countsPerUnit;
    table.columns.push_back(std::move(column));
    return {std::move(table)};
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(rapidcode::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    const auto line = TextLines(text).next();
    return line && line->text.starts_with(firstLine) ? Recognition::Certain : Recognition::No;
}

void addEntry(std::string& text, const std::string& key, const std::string& value)
{
    if (!value.empty())
        text += "# " + key + " = " + value + '\n';
}

std::string headerText(const RapidCodeTable& table, const std::vector<std::string>& notes)
{
    std::string text = std::string(firstLine) + ", the first axis fastest\n";
    text += "# " + rapidCodeInputAdvice(table).english() + '\n';
    addEntry(text, "name", table.held.name);
    for (const std::string& note : notes)
        addEntry(text, "note", note);
    for (std::size_t n = 0; n < table.inputs.size(); ++n) {
        const std::string prefix = "input." + std::to_string(n + 1) + ".";
        addEntry(text, prefix + "axis", table.held.axes[n].name);
        addEntry(text, prefix + "unit", table.held.axes[n].unit);
        addEntry(text, prefix + "min", toText(table.inputs[n].minimum));
        addEntry(text, prefix + "max", toText(table.inputs[n].maximum));
        addEntry(text, prefix + "delta", toText(table.inputs[n].delta));
    }
    addEntry(text, "output.axis", table.held.columns[0].target);
    addEntry(text, "output.unit", table.held.columns[0].unit);
    addEntry(text, "output.counts-per-unit", toText(table.countsPerUnit));
    return text;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = rapidcode::format().facts;
    AXISCOMP_TRY(const auto values, SettingValues::of(facts, options.settings, true));
    WrittenTables written;
    AXISCOMP_TRY(auto table, rapidCodeTable(facts, tables.front(), values, written.remarks));
    NeutralTable& held = table.held;
    held.name = oneLine(held.name);
    for (SourceAxis& axis : held.axes)
        axis.name = oneLine(axis.name);
    held.columns[0].target = oneLine(portableTarget(held.columns[0].target, sourceNames(held)));
    for (const std::string& note : tables.front().notes)
        if (std::string line = oneLine(note); !line.empty())
            held.notes.push_back(std::move(line));
    written.bytes = headerText(table, held.notes);
    const std::size_t columns = table.inputs[0].points;
    for (std::size_t i = 0; i < table.counts.size(); ++i)
        written.bytes += std::to_string(table.counts[i]) + ((i + 1) % columns == 0 ? '\n' : ',');
    written.held.push_back(std::move(held));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "rapidcode",
            .controller = "RSI RapidCode (RMP)",
            .description =
                AXISCOMP_TEXT("Error", "CSV file of this program with the table of a compensator"),
            .extensions = extensions,
            .mostDimensions = 2,
            .knots = KnotRule::Even,
            .mostPoints = rapidCodeMostPoints,
            .holdsNames = true,
            .holdsUnits = true,
            .holdsNotes = true,
            .numbers = "whole counts of the output axis",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Zero},
            .outsideEvidence = Evidence::Assumed,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::rapidcode
