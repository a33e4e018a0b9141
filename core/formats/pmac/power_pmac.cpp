// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/pmac/pmac_file.h"
#include "core/formats/units.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

namespace axiscomp::power_pmac {

namespace {

constexpr std::int64_t mostValues = 1'000'000;
constexpr std::int64_t mostNumber = 255; ///< of a table, and of a motor
constexpr std::string_view prefix = "CompTable[";
constexpr std::string_view sourceCountsKey = "source-counts-per-unit";

constexpr std::array<std::string_view, 2> extensions{".cfg", ".txt"};
constexpr std::array settings{
    pmac::countsForWriting("source-counts-per-unit, target-counts-per-unit"),
    pmac::countsForReading,
    pmac::countsSetting(
        sourceCountsKey, AXISCOMP_TEXT("Error", "motor units for one unit of the positions")),
    pmac::targetCounts,
    FormatSetting{.key = "table",
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error", "number of the table, from 0"),
        .standard = "0",
        .forWriting = true},
    pmac::motorSetting(
        "source-motor", AXISCOMP_TEXT("Error", "number of the motor whose position counts")),
    pmac::motorSetting(
        "target-motor", AXISCOMP_TEXT("Error", "number of the motor that is compensated"))};
constexpr std::array<std::string_view, 6> rules{
    "Assignments to elements of CompTable[n], ended by a semicolon or a line end, names in upper "
    "or "
    "lower case.",
    "Source[0] is the number of the motor whose position counts, Target[0] and Target[1] are the "
    "compensations CompPos and CompPos2 of the motor that is corrected. A table for one of them "
    "alone "
    "is read with a warning; both are written.",
    "Nx[0] is the number of segments, one less than the values; X0[0] is the first position, Dx[0] "
    "the whole span.",
    "Data[0] is a list of values, and Data[i] goes on with it from value i.",
    "Sys.CompEnable is the number of tables in use, from 0: at least one more than the table's "
    "number.",
    "Positions and values are in motor units.",
};
constexpr std::array<std::string_view, 6> assumptions{
    "The values are added to the position of the feedback, only because both feedback loops of the "
    "motor get them; nobody has published the sign.",
    "The values of several tables for one motor are added.",
    "Outside of the span the value at that end is held; between the values it is linear.",
    "Sf[0] multiplies the values: 1 is written, and another one is read with a warning.",
    "Ctrl = 7 and OutCtrl = 0 are what the library that was read writes; their bits were not "
    "found.",
    "Tables over two or three sources (Nx[1] or Nx[2] above 0) are refused, since the order of "
    "their "
    "data was not found. One table is written to a file; one that is read may hold several.",
};

struct Value {
    double number = 0.0;
    std::size_t line = 0;
};

/// What is assigned to one table.
struct Definition {
    std::size_t line = 0; ///< of the first assignment
    std::map<std::string, Token, std::less<>> elements; ///< "nx[0]", in small letters
    std::map<std::int64_t, Value> data;
};

std::string inSmallLetters(std::string_view text)
{
    std::string small(text);
    std::ranges::transform(small, small.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    std::erase_if(small, [](char c) { return c == ' ' || c == '\t'; });
    return small;
}

bool startsWith(std::string_view text, std::string_view begin)
{
    return text.size() >= begin.size() && sameLetters(text.substr(0, begin.size()), begin);
}

/// The statements of a text, line by line, without comments: those of // end with their line, those
/// in /* */ where they say it, perhaps on a line below.
class Statements {
public:
    explicit Statements(std::string_view text) : m_lines(text) { }

    /// Of the next line; nothing behind the last one.
    [[nodiscard]] std::optional<std::vector<Token>> next()
    {
        const auto line = m_lines.next();
        if (!line)
            return std::nullopt;
        std::vector<Token> statements;
        for (std::size_t at = 0; at < line->text.size();)
            at = m_isInComment ? endOfComment(*line, at) : endOfCode(*line, at, statements);
        return statements;
    }
    /// Whether a comment has not ended.
    [[nodiscard]] bool isInComment() const { return m_isInComment; }

private:
    std::size_t endOfComment(const Token& line, std::size_t at)
    {
        const std::size_t end = line.text.find("*/", at);
        m_isInComment = end == std::string_view::npos;
        return m_isInComment ? line.text.size() : end + 2;
    }
    std::size_t endOfCode(const Token& line, std::size_t at, std::vector<Token>& statements)
    {
        const std::size_t end =
            std::min({line.text.find("//", at), line.text.find("/*", at), line.text.size()});
        std::vector<Token> cells;
        splitCells(line.part(at, end - at), ';', cells);
        std::ranges::copy(cells, std::back_inserter(statements));
        m_isInComment = line.text.substr(end, 2) == "/*";
        return m_isInComment ? end + 2 : line.text.size();
    }

    TextLines m_lines;
    bool m_isInComment = false;
};

/// "3]..." behind an opening bracket: the number, and what follows the closing one.
struct Index {
    std::int64_t number = 0;
    Token rest;
};
std::optional<Index> indexAt(const Token& token)
{
    const std::size_t end = token.text.find(']');
    if (end == std::string_view::npos)
        return std::nullopt;
    const auto number = wholeNumberOf(trimmed(token.text.substr(0, end)));
    if (!number || *number < 0)
        return std::nullopt;
    return Index{*number, token.part(end + 1)};
}

constexpr std::string_view tablesInUse = "Sys.CompEnable";

/// "Sys.CompEnable = 1": 1.
std::optional<std::int64_t> countOfTablesInUse(std::string_view statement)
{
    const std::size_t equals = statement.find('=');
    return equals == std::string_view::npos ? std::nullopt
                                            : wholeNumberOf(trimmed(statement.substr(equals + 1)));
}

class Reader {
public:
    explicit Reader(TextReading& reading) : m_reading(reading) { }
    [[nodiscard]] std::vector<NeutralTable> read();

private:
    void take(const Token& statement);
    void takeData(Definition& definition, std::int64_t first, const Token& list);
    [[nodiscard]] std::optional<NeutralTable> table(
        std::int64_t number, const Definition& definition);
    [[nodiscard]] std::optional<std::int64_t> whole(
        const Definition& definition, std::string_view key, const TextPattern& expected);
    [[nodiscard]] std::optional<double> number(
        const Definition& definition, std::string_view key, const TextPattern& expected);
    [[nodiscard]] std::optional<std::string> targetMotor(const Definition& definition);
    [[nodiscard]] double scale(const Definition& definition);
    void checkControl(const Definition& definition);
    [[nodiscard]] std::vector<double> values(const Definition& definition, std::int64_t count);
    [[nodiscard]] double counts(std::string_view key) const
    {
        return pmac::countsPerUnit(m_reading.settings, key).value_or(1.0);
    }

    TextReading& m_reading;
    DiagnosticList& m_diagnostics = m_reading.diagnostics;
    std::map<std::int64_t, Definition> m_definitions;
    Token m_inUse; ///< the last statement that says how many tables are
};

/// What is looked at; the second and the third source do not count where Nx of theirs is 0.
bool isKnown(std::string_view element)
{
    constexpr std::array<std::string_view, 4> ofSources{"source[", "nx[", "x0[", "dx["};
    constexpr std::array<std::string_view, 5> others{
        "target[0]", "target[1]", "sf[0]", "ctrl", "outctrl"};
    return std::ranges::any_of(ofSources, [element](std::string_view name) {
        return element.starts_with(name);
    }) || std::ranges::find(others, element) != others.end();
}

void Reader::takeData(Definition& definition, std::int64_t first, const Token& list)
{
    std::vector<Token> cells;
    splitCells(list, ',', cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto value =
            readNumber(cells[i], AXISCOMP_TEXT("Error", "a value of the table"), m_diagnostics);
        const std::int64_t index = first + static_cast<std::int64_t>(i);
        const auto [at, isNew] =
            definition.data.try_emplace(index, Value{value.value_or(0.0), cells[i].line});
        if (isNew)
            continue;
        at->second = {value.value_or(0.0), cells[i].line};
        m_diagnostics.warning(DiagnosticCode::DuplicateValue, cells[i].line, cells[i].column,
            AXISCOMP_TEXT("Error", "value {number} again").with("number", index),
            AXISCOMP_TEXT("Error", "each value once; the last one counts"));
    }
}

void Reader::take(const Token& statement)
{
    if (startsWith(statement.text, tablesInUse)) {
        m_inUse = statement;
        return;
    }
    if (!startsWith(statement.text, prefix)) {
        const bool isNumber = statement
            && std::string_view("0123456789+-.,").find(statement.text.front())
                != std::string_view::npos;
        if (isNumber && !m_definitions.empty())
            m_diagnostics.error(DiagnosticCode::Syntax, statement.line, statement.column,
                quoted(statement),
                AXISCOMP_TEXT("Error", "an assignment such as {example}")
                    .with("example", Verbatim{"CompTable[0].Data[3] = 4,8"}));
        return;
    }
    const Token behind = statement.part(prefix.size());
    const auto table = indexAt(behind);
    const std::size_t equals = table ? table->rest.text.find('=') : std::string_view::npos;
    if (!table || !table->rest.text.starts_with('.') || equals == std::string_view::npos
        || table->number > mostNumber) {
        m_diagnostics.error(DiagnosticCode::Syntax, statement.line, statement.column,
            quoted(statement),
            AXISCOMP_TEXT("Error", "an assignment such as {example}")
                .with("example", Verbatim{"CompTable[0].Nx[0] = 4"}));
        return;
    }
    Definition& definition = m_definitions[table->number];
    definition.line = definition.line == 0 ? statement.line : definition.line;
    const std::string element = inSmallLetters(table->rest.text.substr(1, equals - 1));
    const Token value = trimmedToken(
        {table->rest.text.substr(equals + 1), statement.line, table->rest.column + equals + 1});
    constexpr std::string_view data = "data[";
    if (element.starts_with(data)) {
        const auto first = indexAt({std::string_view(element).substr(data.size()), 0, 0});
        if (first && first->number <= mostValues)
            return takeData(definition, first->number, value);
    }
    if (!isKnown(element)) {
        m_diagnostics.warning(
            DiagnosticCode::UnknownKey, statement.line, statement.column, quoted(statement), {});
        return;
    }
    const auto [at, isNew] = definition.elements.try_emplace(element, value);
    if (!isNew && at->second.text != value.text)
        m_diagnostics.warning(DiagnosticCode::DuplicateValue, statement.line, statement.column,
            AXISCOMP_TEXT("Error", "{what} a second time").with("what", quoted(statement)),
            AXISCOMP_TEXT("Error", "each value once; the last one counts"));
    at->second = value;
}

std::optional<double> Reader::number(
    const Definition& definition, std::string_view key, const TextPattern& expected)
{
    const auto found = definition.elements.find(key);
    if (found != definition.elements.end())
        return readNumber(found->second, expected, m_diagnostics);
    m_diagnostics.error(DiagnosticCode::Syntax, definition.line, 0, {},
        AXISCOMP_TEXT("Error", "{element} of the table: {meaning}")
            .with("element", Verbatim{std::string(key)})
            .with("meaning", expected));
    return std::nullopt;
}

std::optional<std::int64_t> Reader::whole(
    const Definition& definition, std::string_view key, const TextPattern& expected)
{
    const auto found = definition.elements.find(key);
    if (found != definition.elements.end())
        return readWholeNumber(found->second, expected, m_diagnostics);
    static_cast<void>(number(definition, key, expected));
    return std::nullopt;
}

/// "Motor[1].CompPos.a": both feedback loops of one motor, or one of them with a warning.
std::optional<std::string> Reader::targetMotor(const Definition& definition)
{
    constexpr std::string_view motorPrefix = "motor[";
    std::optional<std::string> motor;
    const Token* only = nullptr;
    bool hasFirst = false;
    bool hasSecond = false;
    for (const std::string_view key : {"target[0]", "target[1]"}) {
        const auto found = definition.elements.find(key);
        if (found == definition.elements.end())
            continue;
        const std::string text = inSmallLetters(found->second.text);
        const auto index = text.starts_with(motorPrefix)
            ? indexAt({std::string_view(text).substr(motorPrefix.size()), 0, 0})
            : std::nullopt;
        const std::string_view element = index ? index->rest.text : std::string_view();
        const bool isFirst = element == ".comppos" || element == ".comppos.a";
        const bool isSecond = element == ".comppos2" || element == ".comppos2.a";
        if ((!isFirst && !isSecond) || (motor && *motor != std::to_string(index->number))) {
            m_diagnostics.error(DiagnosticCode::Contradiction, found->second.line,
                found->second.column, quoted(found->second),
                AXISCOMP_TEXT("Error", "CompPos or CompPos2 of one motor, such as {example}")
                    .with("example", Verbatim{"Motor[1].CompPos.a"}));
            return std::nullopt;
        }
        motor = std::to_string(index->number);
        only = &found->second;
        hasFirst = hasFirst || isFirst;
        hasSecond = hasSecond || isSecond;
    }
    if (only && hasFirst != hasSecond)
        m_diagnostics.warning(DiagnosticCode::Assumption, only->line, only->column,
            AXISCOMP_TEXT("Error", "a table for {element} alone")
                .with("element", Verbatim{hasFirst ? "CompPos" : "CompPos2"}),
            AXISCOMP_TEXT("Error",
                "CompPos and CompPos2 of the motor; the table is taken for both, and written for "
                "both"));
    if (!motor)
        m_diagnostics.error(DiagnosticCode::Syntax, definition.line, 0, {},
            AXISCOMP_TEXT("Error", "{element} of the table: {meaning}")
                .with("element", Verbatim{"Target[0]"})
                .with("meaning", AXISCOMP_TEXT("Error", "the motor that is compensated")));
    return motor;
}

double Reader::scale(const Definition& definition)
{
    const auto found = definition.elements.find("sf[0]");
    if (found == definition.elements.end())
        return 1.0;
    const auto factor = readNumber(
        found->second, AXISCOMP_TEXT("Error", "the scale factor of the values"), m_diagnostics);
    if (factor && *factor != 1.0)
        m_diagnostics.warning(DiagnosticCode::Assumption, found->second.line, 0,
            AXISCOMP_TEXT("Error", "a scale factor Sf[0] of {factor}")
                .with("factor", Quantity{toText(*factor)}),
            AXISCOMP_TEXT("Error", "1; it is taken to multiply the values"));
    return factor.value_or(1.0);
}

/// What was not understood of the way in which the table works.
void Reader::checkControl(const Definition& definition)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> usual{
        {{"ctrl", "7"}, {"outctrl", "0"}}};
    for (const auto& [key, value] : usual) {
        const auto found = definition.elements.find(key);
        if (found != definition.elements.end() && found->second.text != value)
            m_diagnostics.warning(DiagnosticCode::Assumption, found->second.line, 0,
                Verbatim{std::string(key) + '=' + excerpt(found->second.text, Encoding::Utf8)},
                AXISCOMP_TEXT("Error", "{value}; what other bits do is not known")
                    .with("value", value));
    }
}

std::vector<double> Reader::values(const Definition& definition, std::int64_t count)
{
    std::vector<double> values;
    for (const auto& [index, value] : definition.data) {
        const auto expected = static_cast<std::int64_t>(values.size());
        if (index != expected || index >= count)
            break;
        values.push_back(value.number);
    }
    const auto found = static_cast<std::int64_t>(values.size());
    if (found < count)
        m_diagnostics.error(DiagnosticCode::MissingPoint, definition.line, 0,
            AXISCOMP_TEXT("Error", "no value {number}").with("number", found),
            AXISCOMP_TEXT("Error", "{value}, as {key} says")
                .with("value", count)
                .with("key", Verbatim{"Nx[0] + 1"}));
    else if (static_cast<std::int64_t>(definition.data.size()) > count)
        m_diagnostics.error(DiagnosticCode::Contradiction, definition.data.rbegin()->second.line, 0,
            AXISCOMP_COUNTED("Error", "{count} values", "1 value")
                .with("count", definition.data.size()),
            AXISCOMP_TEXT("Error", "{value}, as {key} says")
                .with("value", count)
                .with("key", Verbatim{"Nx[0] + 1"}));
    return values;
}

std::optional<NeutralTable> Reader::table(std::int64_t tableNumber, const Definition& definition)
{
    for (const std::string_view key : {"nx[1]", "nx[2]"}) {
        const auto found = definition.elements.find(key);
        if (found == definition.elements.end() || wholeNumberOf(found->second.text) == 0)
            continue;
        m_diagnostics.error(DiagnosticCode::LimitExceeded, found->second.line, 0,
            AXISCOMP_TEXT("Error", "a table of several sources"),
            AXISCOMP_TEXT(
                "Error", "one source: in which order the values of several stand is not known"));
        return std::nullopt;
    }
    const auto segments = whole(definition, "nx[0]",
        AXISCOMP_TEXT("Error", "the number of segments, one less than values"));
    const auto start = number(definition, "x0[0]", AXISCOMP_TEXT("Error", "the first position"));
    const auto span = number(definition, "dx[0]", AXISCOMP_TEXT("Error", "the whole span"));
    const auto source =
        whole(definition, "source[0]", AXISCOMP_TEXT("Error", "the number of the source motor"));
    const auto target = targetMotor(definition);
    const double factor = scale(definition);
    checkControl(definition);
    if (!segments || !start || !span || !source || !target)
        return std::nullopt;
    if (*segments < 1 || *segments >= mostValues || !(*span > 0.0)) {
        m_diagnostics.error(DiagnosticCode::LimitExceeded, definition.line, 0,
            AXISCOMP_TEXT("Error", "{count} segments over {span}")
                .with("count", *segments)
                .with("span", Quantity{toText(*span)}),
            AXISCOMP_TEXT("Error", "1 to {most} segments over more than 0")
                .with("most", mostValues - 1));
        return std::nullopt;
    }
    NeutralTable table;
    table.name = "CompTable[" + std::to_string(tableNumber) + "]";
    table.sign = SignConvention::Feedback;
    SourceAxis& axis = table.axes.emplace_back();
    axis.name = std::to_string(*source);
    const double perUnit = counts(sourceCountsKey);
    for (std::int64_t i = 0; i <= *segments; ++i)
        axis.knots.push_back(
            (*start + *span * static_cast<double>(i) / static_cast<double>(*segments)) / perUnit);
    CompensationColumn& column = table.columns.emplace_back();
    column.target = *target;
    column.values = values(definition, *segments + 1);
    for (double& value : column.values)
        value = value * factor / counts(pmac::targetCountsKey);
    return table;
}

std::vector<NeutralTable> Reader::read()
{
    Statements lines(m_reading.text);
    while (const auto line = lines.next()) {
        if (m_reading.isStopped())
            return {};
        for (const Token& statement : *line)
            if (statement)
                take(statement);
    }
    if (lines.isInComment())
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0,
            AXISCOMP_TEXT("Error", "a comment without an end"),
            AXISCOMP_TEXT("Error", "{sign} behind it").with("sign", Verbatim{"*/"}));
    if (m_definitions.empty() && !m_diagnostics.hasErrors())
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "assignments to {name}").with("name", Verbatim{"CompTable[0]"}));
    std::vector<NeutralTable> tables;
    const auto inUse = countOfTablesInUse(m_inUse.text);
    if (inUse && !m_definitions.empty() && m_definitions.rbegin()->first >= *inUse)
        warnOfSwitchedOff(m_inUse, m_diagnostics);
    std::size_t used = 0;
    for (const auto& [number, definition] : m_definitions) {
        auto one = table(number, definition);
        if (!one)
            continue;
        pmac::takeMotorUnits(*one, std::span(&sourceCountsKey, 1), m_reading, definition.line,
            AXISCOMP_TEXT("Error", "a table in motor units"));
        tables.push_back(*std::move(one));
        used += number < inUse.value_or(mostNumber + 1) ? 1 : 0;
    }
    warnOfAddedTables(std::span(tables).first(used), m_diagnostics);
    return tables;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    return Reader(reading).read();
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    const FormatFacts& facts = power_pmac::format().facts;
    AXISCOMP_CHECK(checkCounts(facts, options.settings));
    return readText(facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    Statements lines(text);
    while (const auto line = lines.next())
        for (const Token& statement : *line)
            if (startsWith(statement.text, prefix))
                return Recognition::Certain;
    return Recognition::No;
}

struct Numbers {
    std::int64_t table = 0;
    std::int64_t source = 0;
    std::int64_t target = 0;
};

Result<Numbers> numbersOf(
    const FormatFacts& facts, const NeutralTable& table, const SettingValues& given)
{
    Numbers numbers{given.whole("table"), 0, 0};
    AXISCOMP_TRY(numbers.source, axisNumber(facts, given, "source-motor", table.axes[0].name));
    const std::string target = ownAxis(table, table.columns[0]) && !given.has("target-motor")
        ? std::to_string(numbers.source)
        : targetName(table, table.columns[0]);
    AXISCOMP_TRY(numbers.target, axisNumber(facts, given, "target-motor", target));
    for (const std::int64_t number : {numbers.table, numbers.source, numbers.target})
        if (number < 0 || number > mostNumber)
            return cannotHold(facts,
                AXISCOMP_TEXT("Error", "there is no number {number}").with("number", number),
                AXISCOMP_TEXT("Error", "choose one from 0 to {most}").with("most", mostNumber));
    return numbers;
}

std::string textOf(const NeutralTable& table, const Numbers& numbers, double positionCounts,
    const FileNumbers& values)
{
    const std::vector<double>& knots = table.axes[0].knots;
    const FileNumbers positions{positionCounts, true};
    const std::string name = "CompTable[" + std::to_string(numbers.table) + "].";
    std::string text;
    const auto line = [&](std::string_view element, const std::string& value) {
        text += name + std::string(element) + " = " + value + ";\n";
    };
    const std::string motor = "Motor[" + std::to_string(numbers.target) + "].";
    line("Source[0]", std::to_string(numbers.source));
    line("Nx[0]", std::to_string(knots.size() - 1));
    line("Nx[1]", "0");
    line("Nx[2]", "0");
    line("X0[0]", plainNumber(positions.inFile(knots.front())));
    line("Dx[0]", plainNumber(positions.inFile(knots.back() - knots.front())));
    line("Target[0]", motor + "CompPos.a");
    line("Target[1]", motor + "CompPos2.a");
    line("Sf[0]", "1");
    line("Ctrl", "7");
    line("OutCtrl", "0");
    constexpr std::size_t perLine = 10;
    const std::vector<double>& column = table.columns[0].values;
    for (std::size_t first = 0; first < column.size(); first += perLine) {
        std::string list;
        for (std::size_t i = first; i < std::min(first + perLine, column.size()); ++i)
            list += (i == first ? "" : ",") + plainNumber(values.inFile(column[i]));
        line("Data[" + std::to_string(first) + "]", list);
    }
    text += "Sys.CompEnable = " + std::to_string(numbers.table + 1) + ";\n";
    return text;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = power_pmac::format().facts;
    AXISCOMP_CHECK(checkCounts(facts, options.settings));
    AXISCOMP_TRY(const auto given, SettingValues::of(facts, options.settings, true));
    WrittenTables written;
    AXISCOMP_TRY(const auto table, inSettingUnits(tables.front(), given, written.remarks));
    AXISCOMP_CHECK(pmac::checkCounted(facts, table, std::span(&sourceCountsKey, 1), given));
    AXISCOMP_CHECK(checkTargets(table));
    AXISCOMP_TRY(const auto numbers, numbersOf(facts, table, given));
    const auto counts = [&given](std::string_view key) {
        return given.number(given.has(key) ? key : "counts-per-unit");
    };
    written.bytes = textOf(
        table, numbers, counts("source-counts-per-unit"), {counts("target-counts-per-unit"), true});
    FormatSettings reading;
    for (const auto& [key, value] : options.settings)
        if (key.ends_with("counts-per-unit"))
            reading[key] = value;
    if (!table.axes[0].unit.empty())
        reading["position-unit"] = table.axes[0].unit;
    if (!table.columns[0].unit.empty())
        reading["value-unit"] = table.columns[0].unit;
    AXISCOMP_TRY(auto held, readBack(power_pmac::format(), written.bytes, std::move(reading)));
    written.held = std::move(held);
    written.remarks.push_back(
        AXISCOMP_TEXT("Error", "Sys.CompEnable must be at least {number}, also for other tables")
            .with("number", numbers.table + 1));
    written.remarks.emplace_back(AXISCOMP_TEXT("Error",
        "the sign of these tables and what Sf, Ctrl and OutCtrl do are assumptions: look at one "
        "point on the machine before the table is used"));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "power-pmac",
            .controller = "Power PMAC (Delta Tau, Omron)",
            .description = AXISCOMP_TEXT("Error", "compensation table of one source (CompTable)"),
            .extensions = extensions,
            .knots = KnotRule::Even,
            .mostPoints = mostValues,
            .addsTables = true,
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

} // namespace axiscomp::power_pmac
