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
#include <limits>

namespace axiscomp::linuxcnc {

namespace {

constexpr std::size_t mostEntries = 256;
constexpr std::string_view typeKey = "type";

constexpr std::array<std::string_view, 1> extensions{".comp"};
constexpr std::array settings{
    FormatSetting{.key = typeKey,
        .kind = FormatSetting::Kind::Choice,
        .meaning = AXISCOMP_TEXT(
            "Error", "COMP_FILE_TYPE: 0 for measured positions, 1 for trims; 0 is assumed"),
        .choices = "0, 1",
        .forReading = true},
    FormatSetting{.key = typeKey,
        .kind = FormatSetting::Kind::Choice,
        .meaning = AXISCOMP_TEXT("Error", "COMP_FILE_TYPE: 0 for measured positions, 1 for trims"),
        .choices = "0, 1",
        .standard = "0",
        .forWriting = true},
};
constexpr std::array<std::string_view, 9> rules{
    "Each line is nominal forward reverse, in machine units, between blanks; what follows the "
    "third number is left out.",
    "With COMP_FILE_TYPE 0, which is the standard, forward and reverse are measured positions, and "
    "the trim is nominal - measured; with another type they are the trims.",
    "The trim is added to the commanded position of the joint: forward while it moves up, reverse "
    "while it moves down; when it stands the last one stays.",
    "Nominal positions are strictly increasing and need not be evenly spaced; the controller "
    "leaves a line out that does not increase.",
    "At most 256 lines; the controller leaves further ones out.",
    "The controller stops reading, without a message, at the first line that does not begin with "
    "three numbers, also at an empty one. This program reports that line.",
    "Between the points the trim is linear.",
    "Outside of the table the trim at that end is held.",
    "With a table, BACKLASH of the joint is not used.",
};
constexpr std::array<std::string_view, 2> assumptions{
    "Where the type is not given it is 0, with a warning; measured positions that do not increase "
    "are an error then, since they are likely trims.",
    "A single line, a constant trim, is refused: there must be two.",
};

struct Entry {
    double nominal = 0.0;
    double forward = 0.0;
    double reverse = 0.0;
    std::size_t line = 0;
};

std::optional<Entry> entryOf(const std::vector<Token>& tokens, std::size_t line)
{
    if (tokens.size() < 3)
        return std::nullopt;
    const auto nominal = numberOf(tokens[0].text);
    const auto forward = numberOf(tokens[1].text);
    const auto reverse = numberOf(tokens[2].text);
    if (!nominal || !forward || !reverse)
        return std::nullopt;
    return Entry{*nominal, *forward, *reverse, line};
}

void takeLine(
    const Token& line, std::vector<Token>& tokens, std::vector<Entry>& entries, TextReading& source)
{
    splitTokens(line, " \t", tokens);
    const auto entry = entryOf(tokens, line.line);
    if (!entry) {
        source.diagnostics.error(DiagnosticCode::Syntax, line.line, 0,
            Verbatim{excerpt(line.text, Encoding::Utf8)},
            AXISCOMP_TEXT("Error",
                "three numbers: nominal forward reverse; the controller stops reading here without "
                "a message"));
        return;
    }
    if (tokens.size() > 3)
        source.diagnostics.warning(DiagnosticCode::Assumption, line.line, tokens[3].column,
            AXISCOMP_TEXT("Error", "{text} after three numbers")
                .with("text", excerpt(tokens[3].text, Encoding::Utf8)),
            AXISCOMP_TEXT("Error", "nothing; it is left out, as the controller does"));
    entries.push_back(*entry);
}

std::vector<Entry> entriesOf(TextReading& source)
{
    std::vector<Entry> entries;
    std::vector<Token> tokens;
    std::vector<Token> blankLines; // an error only if there is something behind them
    TextLines lines(source.text);
    while (const auto line = lines.next()) {
        if (source.isStopped())
            return {};
        if (trimmedToken(*line).text.empty()) {
            blankLines.push_back(*line);
            continue;
        }
        for (const Token& blank : blankLines)
            takeLine(blank, tokens, entries, source);
        blankLines.clear();
        takeLine(*line, tokens, entries, source);
    }
    return entries;
}

bool checkEntries(const std::vector<Entry>& entries, TextReading& source)
{
    if (entries.size() > mostEntries)
        source.diagnostics.error(DiagnosticCode::LimitExceeded, entries[mostEntries].line, 0,
            AXISCOMP_TEXT("Error", "{number} lines").with("number", entries.size()),
            AXISCOMP_TEXT("Error", "at most 256; the controller leaves out the others"));
    std::vector<double> nominals;
    std::vector<std::size_t> lines;
    for (const Entry& entry : entries) {
        nominals.push_back(entry.nominal);
        lines.push_back(entry.line);
    }
    return !source.diagnostics.hasErrors() && checkKnots(nominals, lines, {}, source.diagnostics);
}

/// The first line whose measured position is not above the one before; 0: all are.
std::size_t fallingLine(const std::vector<Entry>& entries)
{
    for (std::size_t i = 1; i < entries.size(); ++i)
        if (!(entries[i].forward > entries[i - 1].forward)
            || !(entries[i].reverse > entries[i - 1].reverse))
            return entries[i].line;
    return 0;
}

/// Whether the numbers are those of the type, as far as they tell.
void checkType(const std::vector<Entry>& entries, TextReading& source)
{
    const std::size_t falling = fallingLine(entries);
    const bool isGiven = source.settings.has(typeKey);
    const bool isMeasured = source.settings.text(typeKey) != "1";
    if (!isGiven && falling > 0) {
        source.diagnostics.error(DiagnosticCode::Contradiction, falling, 0,
            AXISCOMP_TEXT("Error", "a measured position that does not increase"),
            AXISCOMP_TEXT("Error", "increasing ones; if these are trims, the setting type=1"));
    } else if (!isGiven) {
        source.diagnostics.warning(DiagnosticCode::Assumption, 0, 0,
            AXISCOMP_TEXT("Error", "measured positions (COMP_FILE_TYPE 0)"),
            AXISCOMP_TEXT("Error", "the setting type=0, or type=1 if these are trims"));
    } else if (isMeasured && falling > 0) {
        source.diagnostics.warning(DiagnosticCode::Assumption, falling, 0,
            AXISCOMP_TEXT("Error", "a measured position that does not increase"),
            AXISCOMP_TEXT("Error", "increasing ones; perhaps these are trims (type=1)"));
    } else if (!isMeasured) {
        const double trims = std::abs(entries.back().forward - entries.front().forward);
        if (trims > 0.5 * (entries.back().nominal - entries.front().nominal))
            source.diagnostics.warning(DiagnosticCode::Assumption, 0, 0,
                AXISCOMP_TEXT("Error", "trims that change by {change}")
                    .with("change", Quantity{roundedText(trims)}),
                AXISCOMP_TEXT("Error",
                    "less than the positions do; perhaps these are measured positions (type=0)"));
    }
}

/// The columns of forward and reverse trims: one when they are the same.
std::vector<CompensationColumn> columnsOf(
    std::vector<double> forward, std::vector<double> reverse, const std::string& unit)
{
    std::vector<CompensationColumn> columns(forward == reverse ? 1 : 2);
    if (columns.size() == 2) {
        columns[0].direction = Direction::Positive;
        columns[1].direction = Direction::Negative;
        columns[1].values = std::move(reverse);
    }
    columns[0].values = std::move(forward);
    for (CompensationColumn& column : columns) {
        column.unit = unit;
        column.target = sourceTarget(0);
    }
    return columns;
}

std::vector<NeutralTable> parse(TextReading& source)
{
    const std::vector<Entry> entries = entriesOf(source);
    if (source.isStopped() || !checkEntries(entries, source))
        return {};
    checkType(entries, source);
    const bool isMeasured = source.settings.text(typeKey) != "1";
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes.resize(1);
    std::vector<double> forward;
    std::vector<double> reverse;
    for (const Entry& entry : entries) {
        table.axes[0].knots.push_back(entry.nominal);
        forward.push_back(isMeasured ? entry.nominal - entry.forward : entry.forward);
        reverse.push_back(isMeasured ? entry.nominal - entry.reverse : entry.reverse);
    }
    table.columns = columnsOf(std::move(forward), std::move(reverse), {});
    takeOneUnit(table, source.settings, source.diagnostics);
    return {std::move(table)};
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(linuxcnc::format().facts, text, options, parse);
}

/// Nothing but lines of three numbers, the first increasing.
Recognition recognise(std::string_view text)
{
    TextLines lines(text);
    std::vector<Token> tokens;
    std::size_t count = 0;
    double last = -std::numeric_limits<double>::infinity();
    for (auto line = lines.next(); line;) {
        const auto following = lines.next();
        splitTokens(*line, " \t", tokens);
        const auto entry = entryOf(tokens, line->line);
        if (entry && tokens.size() == 3 && entry->nominal > last)
            ++count;
        else if (following) // the last line may be cut off
            return Recognition::No;
        if (entry)
            last = entry->nominal;
        line = following;
    }
    return count >= 2 && count <= mostEntries ? Recognition::Possible : Recognition::No;
}

/// A number of the file and the trim that it makes there.
struct Written {
    std::string text;
    double trim = 0.0;
};
Written measured(double nominal, double trim)
{
    // The digits that only come from the rounding of the difference are left out.
    const double exact = nominal - trim;
    const double rounding =
        4 * std::numeric_limits<double>::epsilon() * (std::abs(nominal) + std::abs(trim));
    const std::string brief = roundedText(exact);
    const double rounded = numberOf(brief).value_or(exact);
    const double position = std::abs(rounded - exact) <= rounding ? rounded : exact;
    return {toText(position), nominal - position};
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = linuxcnc::format().facts;
    AXISCOMP_TRY(const auto values, SettingValues::of(facts, options.settings, true));
    WrittenTables written;
    AXISCOMP_TRY(auto table, asOwnAxisTable(facts, tables.front(), values, written.remarks));
    AXISCOMP_TRY(const auto pair, directionPair(facts, table));
    const std::vector<double>& forward = pair.positive->values;
    const std::vector<double>& reverse = pair.negative ? pair.negative->values : forward;
    const bool isMeasured = values.text(typeKey) == "0";
    std::array<std::vector<double>, 2> trims;
    for (std::size_t i = 0; i < table.pointCount(); ++i) {
        const double nominal = table.axes[0].knots[i];
        written.bytes += toText(nominal);
        for (std::size_t n = 0; n < trims.size(); ++n) {
            const double trim = (n == 0 ? forward : reverse)[i];
            const Written number =
                isMeasured ? measured(nominal, trim) : Written{toText(trim), trim};
            if (!std::isfinite(number.trim))
                return cannotHold(facts,
                    AXISCOMP_TEXT(
                        "Error", "a measured position at {position} is beyond what a number can be")
                        .with("position", Quantity{toText(nominal)}),
                    AXISCOMP_TEXT("Error", "check the unit of positions and values"));
            written.bytes += ' ' + number.text;
            trims[n].push_back(number.trim);
        }
        written.bytes += '\n';
    }
    table.columns = columnsOf(std::move(trims[0]), std::move(trims[1]), table.columns.front().unit);
    written.held.push_back(std::move(table));
    written.remarks.push_back(
        (options.fileName.empty() ? AXISCOMP_TEXT("Error",
             "in the section [JOINT_n] of the INI file: COMP_FILE = the file and COMP_FILE_TYPE = "
             "{type}")
                                  : AXISCOMP_TEXT("Error",
                                      "in the section [JOINT_n] of the INI file: COMP_FILE = "
                                      "{file} and COMP_FILE_TYPE = {type}"))
            .with("file", options.fileName)
            .with("type", values.text(typeKey)));
    written.remarks.push_back(AXISCOMP_TEXT("Error", "BACKLASH of the joint is not used any more"));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "linuxcnc",
            .controller = "LinuxCNC",
            .description =
                AXISCOMP_TEXT("Error", "compensation file of a joint: nominal forward reverse"),
            .extensions = extensions,
            .knots = KnotRule::Any,
            .mostPoints = mostEntries,
            .holdsDirections = true,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Code,
            .behaviour = {.outside = Outside::Hold},
            .outsideEvidence = Evidence::Code,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::linuxcnc
