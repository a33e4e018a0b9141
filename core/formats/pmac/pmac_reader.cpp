// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/pmac/pmac_file.h"
#include "core/formats/units.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace axiscomp::pmac {

namespace {

constexpr std::array<std::string_view, 2> sourceCounts{
    "source-counts-per-unit", "column-counts-per-unit"};

Verbatim quoted(std::string_view text)
{
    return {excerpt(text, Encoding::Utf8)};
}

Text asDefined(std::size_t entries)
{
    return AXISCOMP_TEXT("Error", "{value}, as {key} says")
        .with("value", entries)
        .with("key", Verbatim{"DEFINE COMP"});
}

Text entriesText(Argument count)
{
    return AXISCOMP_COUNTED("Error", "{count} entries", "1 entry").with("count", std::move(count));
}

/// The rest behind a word in capital or small letters; nothing when the token begins otherwise.
std::optional<Token> behindWord(const Token& token, std::string_view word)
{
    if (token.text.size() < word.size() || !sameLetters(token.text.substr(0, word.size()), word))
        return std::nullopt;
    return trimmedToken(token.part(word.size()));
}

/// What follows DEFINE COMP or DEF COMP.
std::optional<Token> behindDefineComp(const Token& line)
{
    for (const std::string_view word : {"DEFINE", "DEF"})
        if (const auto rest = behindWord(line, word))
            if (const auto arguments = behindWord(*rest, "COMP"))
                return arguments;
    return std::nullopt;
}

Token withoutComments(const Token& whole)
{
    Token line = withoutComment(whole, ";");
    line.text = line.text.substr(0, line.text.find("//"));
    return trimmedToken(line);
}

/// "#1" in front of a line addresses a motor; what is left of the line.
Token takeAddress(Token line, std::string& addressed)
{
    if (!line.text.starts_with('#'))
        return line;
    const std::size_t end =
        std::min(line.text.find_first_not_of("0123456789", 1), line.text.size());
    if (end < 2) // no number, and so no motor
        return line;
    addressed = line.text.substr(1, end - 1);
    return trimmedToken(line.part(end));
}

/// One DEFINE COMP with its entries.
struct Definition {
    Token place;
    std::string owner; ///< the motor that was addressed
    bool isGone = false; ///< deleted, or replaced by another table of its owner, further on
    std::array<std::size_t, 2> sizes{1, 0}; ///< intervals along the first and second source
    std::array<std::int64_t, 2> spans{}; ///< in counts
    std::array<std::string, 2> sources;
    std::string target;
    std::size_t entryCount = 0;
    std::vector<double> entries;
    std::vector<std::string> notes;
};

std::optional<std::size_t> readSize(const Token& cell, DiagnosticList& diagnostics)
{
    constexpr std::int64_t most = 1'000'000;
    const auto size =
        readWholeNumber(cell, AXISCOMP_TEXT("Error", "a number of entries"), diagnostics);
    if (!size || (*size >= 1 && *size <= most))
        return size;
    diagnostics.error(DiagnosticCode::LimitExceeded, cell.line, cell.column, entriesText(*size),
        AXISCOMP_TEXT("Error", "{number} to {number2}").with("number", 1).with("number2", most));
    return std::nullopt;
}

/// "#3" or "#3D"
std::optional<std::string> readMotor(const Token& cell, DiagnosticList& diagnostics)
{
    std::string_view digits = trimmed(cell.text.substr(1));
    if (digits.ends_with('D') || digits.ends_with('d'))
        digits.remove_suffix(1);
    const auto motor = wholeNumberOf(trimmed(digits));
    if (motor && *motor >= 1 && *motor <= 32)
        return std::to_string(*motor);
    diagnostics.error(DiagnosticCode::Syntax, cell.line, cell.column, quoted(cell.text),
        AXISCOMP_TEXT("Error", "the number of a motor, #1 to #32, perhaps with a D"));
    return std::nullopt;
}

/// Between commas or blanks: real files have both.
std::vector<Token> splitArguments(const Token& arguments)
{
    std::vector<Token> between;
    splitCells(arguments, ',', between);
    std::vector<Token> cells;
    for (const Token& cell : between) {
        Token rest = trimmedToken(cell);
        std::size_t blank = rest.text.find_first_of(" \t");
        while (blank != std::string_view::npos) {
            cells.push_back(rest.part(0, blank));
            rest = trimmedToken(rest.part(blank));
            blank = rest.text.find_first_of(" \t");
        }
        cells.push_back(rest);
    }
    return cells;
}

class Reader {
public:
    Reader(TextReading& reading, std::size_t dimensions)
        : m_reading(reading)
        , m_dimensions(dimensions)
    {
    }
    [[nodiscard]] std::vector<Definition> read();

private:
    void begin(const Token& line, const Token& arguments);
    [[nodiscard]] bool readArguments(Definition& definition, std::vector<Token> cells);
    /// Whether there was one.
    bool dropTableOf(const std::string& owner);
    void takeEntries(const Token& line);
    void checkSwitchedOff(const Token& line);
    void takeCommand(const Token& line);
    void finish();

    TextReading& m_reading;
    std::size_t m_dimensions;
    std::string m_addressed;
    Token m_switchedOff; ///< "I51=0", unless it is switched on behind it
    std::vector<Definition> m_definitions;
    std::map<std::string, std::size_t> m_owned; ///< of each motor, the definition that is its own
    std::vector<Token> m_tokens;
    std::vector<std::string> m_notes;
    bool m_isOpen = false; ///< entries belong to the last definition
    bool m_isForeign = false; ///< entries belong to something that is left out
};

bool Reader::readArguments(Definition& definition, std::vector<Token> cells)
{
    DiagnosticList& diagnostics = m_reading.diagnostics;
    std::vector<std::string> motors;
    while (cells.size() > 1 && cells[1].text.starts_with('#')) {
        const auto motor = readMotor(cells[1], diagnostics);
        if (!motor)
            return false;
        motors.push_back(*motor);
        cells.erase(cells.begin() + 1);
    }
    if (cells.size() != 1 + m_dimensions || motors.size() > 1 + m_dimensions) {
        diagnostics.error(DiagnosticCode::Syntax, definition.place.line, definition.place.column,
            quoted(definition.place.text),
            m_dimensions == 1 ? AXISCOMP_TEXT("Error", "DEFINE COMP entries,#source,#target,span")
                              : AXISCOMP_TEXT("Error",
                                  "DEFINE COMP rows.columns,#row,#column,#target,span,span"));
        return false;
    }
    for (std::size_t n = 0; n < m_dimensions; ++n) {
        const auto span =
            readWholeNumber(cells[1 + n], AXISCOMP_TEXT("Error", "a span in counts"), diagnostics);
        if (span && *span < 1)
            diagnostics.error(DiagnosticCode::LimitExceeded, cells[1 + n].line, cells[1 + n].column,
                AXISCOMP_TEXT("Error", "a span of {span}").with("span", *span),
                AXISCOMP_TEXT("Error", "at least 1 count"));
        definition.spans[n] = span.value_or(0);
    }
    if (motors.size() <= m_dimensions && m_addressed.empty())
        diagnostics.warning(DiagnosticCode::Assumption, definition.place.line, 0,
            AXISCOMP_TEXT("Error", "motors that are not named"),
            AXISCOMP_TEXT(
                "Error", "the motor that is addressed when the file is loaded; name it with #"));
    motors.resize(std::max(motors.size(), m_dimensions + 1), m_addressed);
    for (std::size_t n = 0; n < m_dimensions; ++n)
        definition.sources[n] = motors[n];
    if (m_dimensions == 2 && motors[0] == motors[1]) {
        diagnostics.error(DiagnosticCode::Contradiction, definition.place.line,
            definition.place.column, quoted(definition.place.text),
            AXISCOMP_TEXT("Error", "another axis than that of the first source"));
        return false;
    }
    definition.target = motors[m_dimensions];
    definition.owner = m_addressed.empty() ? definition.target : m_addressed;
    return true;
}

void Reader::begin(const Token& line, const Token& arguments)
{
    finish();
    DiagnosticList& diagnostics = m_reading.diagnostics;
    std::vector<Token> cells = splitArguments(arguments);
    const std::size_t dot = cells.front().text.find('.');
    const bool isPlane = dot != std::string_view::npos;
    if (isPlane != (m_dimensions == 2)) {
        m_isForeign = true;
        diagnostics.warning(DiagnosticCode::Assumption, line.line, line.column,
            isPlane ? AXISCOMP_TEXT("Error", "a table of two dimensions")
                    : AXISCOMP_TEXT("Error", "a table of one dimension"),
            AXISCOMP_TEXT("Error", "the format {format} to read it; it is left out here")
                .with("format", (isPlane ? pmac_2d::format() : pmac_1d::format()).facts.name));
        return;
    }
    Definition definition;
    definition.place = line;
    const Token& size = cells.front();
    const auto columns = readSize(isPlane ? size.part(dot + 1) : size, diagnostics);
    const auto rows =
        isPlane ? readSize(size.part(0, dot), diagnostics) : std::optional<std::size_t>(0);
    m_isForeign = !columns || !rows || !readArguments(definition, cells);
    if (m_isForeign)
        return;
    definition.sizes = {*columns, *rows};
    definition.entryCount = (*columns + 1) * (*rows + 1) - 1;
    definition.notes = std::exchange(m_notes, {});
    if (dropTableOf(definition.owner))
        diagnostics.warning(DiagnosticCode::Assumption, line.line, line.column,
            AXISCOMP_TEXT("Error", "a second table that belongs to the same motor"),
            AXISCOMP_TEXT("Error", "one for each motor; the last one counts"));
    m_owned[definition.owner] = m_definitions.size();
    m_definitions.push_back(std::move(definition));
    m_isOpen = true;
}

void Reader::finish()
{
    if (m_isOpen && m_definitions.back().entries.size() < m_definitions.back().entryCount) {
        const Definition& last = m_definitions.back();
        m_reading.diagnostics.error(DiagnosticCode::MissingPoint, last.place.line, 0,
            entriesText(last.entries.size()), asDefined(last.entryCount));
    }
    m_isOpen = false;
    m_isForeign = false;
}

void Reader::takeEntries(const Token& line)
{
    DiagnosticList& diagnostics = m_reading.diagnostics;
    if (m_isForeign)
        return;
    if (!m_isOpen || m_definitions.back().entries.size() == m_definitions.back().entryCount) {
        diagnostics.error(DiagnosticCode::Contradiction, line.line, line.column,
            AXISCOMP_TEXT("Error", "further entries: {entries}").with("entries", quoted(line.text)),
            m_isOpen ? asDefined(m_definitions.back().entryCount)
                     : AXISCOMP_TEXT("Error", "DEFINE COMP in front of them"));
        finish();
        m_isForeign = true; // one such problem is enough
        return;
    }
    splitTokens(line, " \t,", m_tokens);
    Definition& definition = m_definitions.back();
    for (const Token& token : m_tokens) {
        const auto entry = readWholeNumber(
            token, AXISCOMP_TEXT("Error", "a whole number of 1/16 count"), diagnostics);
        definition.entries.push_back(static_cast<double>(entry.value_or(0)));
    }
    if (definition.entries.size() > definition.entryCount) {
        diagnostics.error(DiagnosticCode::Contradiction, line.line, 0,
            entriesText(definition.entries.size()), asDefined(definition.entryCount));
        definition.entries.resize(definition.entryCount);
    }
}

bool Reader::dropTableOf(const std::string& owner)
{
    const auto owned = m_owned.find(owner);
    if (owned == m_owned.end())
        return false;
    m_definitions[owned->second].isGone = true;
    m_owned.erase(owned);
    return true;
}

/// "I51=0" and "DELETE COMP" behind the table.
void Reader::checkSwitchedOff(const Token& line)
{
    if (const auto value = behindWord(line, "I51"); value && value->text.starts_with('='))
        m_switchedOff = wholeNumberOf(trimmedToken(value->part(1)).text) == 0 ? line : Token{};
    auto deleted = behindWord(line, "DELETE");
    if (!deleted)
        deleted = behindWord(line, "DEL");
    if (deleted && behindWord(*deleted, "COMP") && dropTableOf(m_addressed))
        warnOfSwitchedOff(line, m_reading.diagnostics);
}

void Reader::takeCommand(const Token& line)
{
    finish();
    const bool isDefine = behindWord(line, "DEF").has_value();
    checkSwitchedOff(line);
    const bool isExpected = std::ranges::any_of(std::array{"CLOSE", "DELETE", "DEL", "I51", "END"},
        [&](std::string_view word) { return behindWord(line, word).has_value(); });
    if (!isExpected)
        m_reading.diagnostics.warning(
            DiagnosticCode::UnknownKey, line.line, line.column, quoted(line.text), {});
    m_isForeign = isDefine; // its entries
}

std::vector<Definition> Reader::read()
{
    TextLines lines(m_reading.text);
    while (const auto whole = lines.next()) {
        if (m_reading.isStopped())
            return {};
        Token line = withoutComments(*whole);
        if (!line) {
            const Token comment = trimmedToken(*whole);
            if (const auto at = comment.text.find_first_not_of("; \t/"); at != comment.text.npos)
                keepNote(m_notes, comment.text.substr(at));
            continue;
        }
        line = takeAddress(line, m_addressed);
        if (!line)
            continue;
        const char first = line.text.front();
        const bool isCommand = (first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z');
        if (const auto arguments = behindDefineComp(line))
            begin(line, *arguments);
        else if (isCommand)
            takeCommand(line);
        else
            takeEntries(line);
    }
    finish();
    if (m_switchedOff && !m_definitions.empty())
        warnOfSwitchedOff(m_switchedOff, m_reading.diagnostics);
    if (m_definitions.empty() && !m_reading.diagnostics.hasErrors())
        m_reading.diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            m_dimensions == 1
                ? AXISCOMP_TEXT("Error", "DEFINE COMP for a table of one dimension")
                : AXISCOMP_TEXT("Error", "DEFINE COMP for a table of two dimensions"));
    return std::move(m_definitions);
}

NeutralTable tableOf(Definition& definition, const TextReading& reading, std::size_t dimensions)
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.notes = std::move(definition.notes);
    const SettingValues& settings = reading.settings;
    for (std::size_t n = 0; n < dimensions; ++n) {
        SourceAxis& axis = table.axes.emplace_back();
        axis.name = definition.sources[n];
        const double counts = countsPerUnit(settings, sourceCounts[n]).value_or(1.0);
        const auto span = static_cast<double>(definition.spans[n]);
        const auto size = static_cast<double>(definition.sizes[n]);
        for (std::size_t i = 0; i <= definition.sizes[n]; ++i)
            axis.knots.push_back(static_cast<double>(i) * span / size / counts);
        axis.wrap = axis.knots.back();
    }
    CompensationColumn& column = table.columns.emplace_back();
    column.target = definition.target;
    const FileNumbers numbers{
        entriesPerCount * countsPerUnit(settings, targetCountsKey).value_or(1.0), false};
    column.values.push_back(0.0); // the entry that is left out
    for (const double entry : definition.entries)
        column.values.push_back(numbers.fromFile(entry));
    takeMotorUnits(table, std::span(sourceCounts).first(dimensions), reading, definition.place.line,
        AXISCOMP_TEXT("Error", "a table in counts"));
    for (std::size_t n = 0; n < dimensions; ++n) {
        const std::size_t line = definition.place.line;
        const Text motor =
            AXISCOMP_TEXT("Error", "motor {number}").with("number", table.axes[n].name);
        static_cast<void>(
            checkKnots(table.axes[n].knots, std::span(&line, 1), motor, reading.diagnostics));
        if (!isClosed(table, n))
            reading.diagnostics.warning(DiagnosticCode::NotPeriodic, definition.place.line, 0,
                AXISCOMP_TEXT("Error", "different entries at 0 and at the span of motor {motor}")
                    .with("motor", table.axes[n].name),
                AXISCOMP_TEXT("Error", "the same: the table rolls over there"));
    }
    const bool areFinite =
        std::ranges::all_of(column.values, [](double value) { return std::isfinite(value); });
    if (!areFinite)
        reading.diagnostics.error(DiagnosticCode::LimitExceeded, definition.place.line, 0,
            AXISCOMP_TEXT("Error", "entries that are too large in these units"),
            AXISCOMP_TEXT("Error", "another counts-per-unit"));
    return table;
}

void warnOfSeveral(
    const std::vector<Definition>& definitions, std::size_t dimensions, DiagnosticList& diagnostics)
{
    std::vector<NeutralTable> names;
    for (const Definition& definition : definitions) {
        if (definition.isGone)
            continue;
        NeutralTable& table = names.emplace_back();
        for (std::size_t n = 0; n < dimensions; ++n)
            table.axes.emplace_back().name = definition.sources[n];
        table.columns.emplace_back().target = definition.target;
    }
    warnOfAddedTables(names, diagnostics);
}

} // namespace

std::vector<NeutralTable> readTables(TextReading& reading, std::size_t dimensions)
{
    std::vector<NeutralTable> tables;
    std::vector<Definition> definitions = Reader(reading, dimensions).read();
    if (reading.diagnostics.hasErrors())
        return {};
    warnOfSeveral(definitions, dimensions, reading.diagnostics);
    for (Definition& definition : definitions)
        tables.push_back(tableOf(definition, reading, dimensions));
    return tables;
}

Recognition recogniseFile(std::string_view text, std::size_t dimensions)
{
    bool hasOwn = false;
    bool hasOther = false;
    std::string addressed;
    TextLines lines(text);
    while (const auto whole = lines.next()) {
        const auto arguments = behindDefineComp(takeAddress(withoutComments(*whole), addressed));
        const std::vector<Token> cells =
            arguments ? splitArguments(*arguments) : std::vector<Token>();
        if (cells.size() < 2 || !numberOf(cells.front().text))
            continue;
        const std::string_view size = cells.front().text;
        const bool isPlane = size.find('.') != std::string_view::npos;
        (isPlane == (dimensions == 2) ? hasOwn : hasOther) = true;
    }
    if (!hasOwn)
        return Recognition::No;
    return hasOther ? Recognition::Possible : Recognition::Certain;
}

std::optional<double> countsPerUnit(const SettingValues& settings, std::string_view key)
{
    for (const std::string_view given : {key, countsForReading.key})
        if (settings.has(given))
            return settings.number(given);
    return std::nullopt;
}

std::optional<Diagnostic> motorContradiction(const NeutralTable& table,
    std::span<const std::string_view> sourceKeys, const SettingValues& settings)
{
    const auto own = ownAxis(table, table.columns.front());
    const bool isSameCount = own
        && countsPerUnit(settings, sourceKeys[*own]) == countsPerUnit(settings, targetCountsKey);
    return isSameCount ? unitContradiction(table) : std::nullopt;
}

namespace {

/// A unit of numbers that stay in counts would be ignored.
void refuseUnitOfCounts(
    std::string_view unitKey, std::string_view countsKey, const TextReading& reading)
{
    if (reading.settings.has(unitKey))
        reading.diagnostics.error(DiagnosticCode::Contradiction, 0, 0,
            AXISCOMP_TEXT("Error", "the setting {key} for numbers in counts").with("key", unitKey),
            AXISCOMP_TEXT("Error", "the setting {key}, which says how many of them are one unit")
                .with("key", countsKey));
}

} // namespace

void takeMotorUnits(NeutralTable& table, std::span<const std::string_view> sourceKeys,
    const TextReading& reading, std::size_t line, const TextPattern& inCounts)
{
    const SettingValues& settings = reading.settings;
    std::vector<std::string_view> missing;
    for (const std::string_view key : sourceKeys)
        if (!countsPerUnit(settings, key))
            missing.push_back(key);
    const bool areSourcesInCounts = missing.size() == sourceKeys.size();
    const bool isTargetInCounts = !countsPerUnit(settings, targetCountsKey);
    if (isTargetInCounts)
        missing.push_back(targetCountsKey);
    const std::string_view expected = missing.size() == 1 ? missing.front() : countsForReading.key;
    if (areSourcesInCounts)
        refuseUnitOfCounts("position-unit", expected, reading);
    else
        takePositionUnit(table, settings, reading.diagnostics);
    if (isTargetInCounts)
        refuseUnitOfCounts("value-unit", expected, reading);
    else
        takeValueUnit(table, settings, reading.diagnostics);
    for (std::size_t n = 0; n < table.axes.size(); ++n)
        if (!countsPerUnit(settings, sourceKeys[n]))
            table.axes[n].unit = countsUnit;
    if (isTargetInCounts)
        table.columns.front().unit = countsUnit;
    if (!missing.empty())
        reading.diagnostics.warning(DiagnosticCode::UnitNotGiven, line, 0, inCounts,
            AXISCOMP_TEXT("Error", "the setting {key}, where a unit matters")
                .with("key", expected));
    if (auto contradiction = motorContradiction(table, sourceKeys, settings))
        reading.diagnostics.error(*std::move(contradiction));
}

} // namespace axiscomp::pmac
