// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/aerotech/aerotech_file.h"

#include "core/formats/units.h"
#include "core/text/decimal_comma.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace axiscomp::aerotech {

namespace {

constexpr char blanks[] = " \t,";
constexpr std::string_view endDirective = ":END";

Verbatim quoted(std::string_view text)
{
    return {excerpt(text, Encoding::Utf8)};
}

/// The pieces of a directive: words, and keys with their values, also with blanks round '='.
void takeDirective(const Token& line, Block& block, DiagnosticList& diagnostics)
{
    const std::string_view text = line.text;
    const auto piece = [&](std::size_t begin, std::size_t end) {
        return line.part(begin, end - begin);
    };
    const auto skip = [&](std::size_t at) {
        return std::min(text.find_first_not_of(blanks, at), text.size());
    };
    std::size_t at = skip(std::min(text.find_first_of(blanks), text.size()));
    while (at < text.size()) {
        const std::size_t end = std::min(text.find_first_of(" \t,=", at), text.size());
        const Token word = piece(at, end);
        const std::size_t next = skip(end);
        if (next >= text.size() || text[next] != '=') {
            if (numberOf(word.text))
                block.numbers.push_back(word);
            else
                block.options.push_back({word, {}});
            at = next;
            continue;
        }
        const std::size_t begin = skip(next + 1);
        std::size_t stop = std::min(text.find_first_of(" \t", begin), text.size());
        if (commasBetweenDigits(text.substr(begin, stop - begin)) == 0)
            stop = std::min(text.find_first_of(blanks, begin), stop);
        if (!word || begin == stop) {
            diagnostics.error(DiagnosticCode::Syntax, line.line, line.column + at,
                quoted(text.substr(at)), AXISCOMP_TEXT("Error", "KEY=VALUE"));
            return;
        }
        block.options.push_back({word, piece(begin, stop)});
        at = skip(stop);
    }
}

/// Vendors' tools put lines of asterisks and texts before a table, without the sign of a comment.
bool isBanner(const Token& line)
{
    const std::string_view word = firstToken(line, blanks).text;
    return line.text.front() != ':' && !numberOf(word) && word.find_first_of("0123456789") != 0;
}

/// Makes blocks of lines.
class BlockReader {
public:
    BlockReader(const TextReading& reading, std::string_view directive)
        : m_reading(reading)
        , m_directive(directive)
    {
    }
    [[nodiscard]] std::vector<Block> read();

private:
    void takeStart(const Token& line);
    void takeEnd(const Token& line);
    void takeValues(const Token& line);
    void checkCommas();
    [[nodiscard]] bool isOpen() const { return m_isOpen; }

    const TextReading& m_reading;
    std::string_view m_directive;
    std::vector<Block> m_blocks;
    std::vector<Token> m_tokens;
    std::vector<std::string> m_notes;
    DecimalCommaCheck m_commas;
    bool m_isOpen = false;
};

void BlockReader::takeStart(const Token& line)
{
    DiagnosticList& diagnostics = m_reading.diagnostics;
    Block further;
    takeDirective(line, further, diagnostics);
    const bool isContinued = m_isOpen && m_blocks.back().values.empty() && further.numbers.empty();
    if (m_isOpen && !isContinued) {
        diagnostics.error(DiagnosticCode::Syntax, line.line, line.column, quoted(line.text),
            AXISCOMP_TEXT("Error", ":END of the table that begins in line {line}")
                .with("line", m_blocks.back().start.line));
        m_isOpen = false;
    }
    if (isContinued) {
        Block& block = m_blocks.back();
        block.options.insert(block.options.end(), further.options.begin(), further.options.end());
        return;
    }
    further.start = line;
    further.notes = std::exchange(m_notes, {});
    m_blocks.push_back(std::move(further));
    m_isOpen = true;
}

void BlockReader::takeEnd(const Token& line)
{
    if (!m_isOpen)
        m_reading.diagnostics.error(DiagnosticCode::Syntax, line.line, line.column,
            quoted(line.text),
            AXISCOMP_TEXT("Error", "{directive} before :END").with("directive", m_directive));
    m_isOpen = false;
}

void BlockReader::takeValues(const Token& line)
{
    if (!m_isOpen) {
        m_reading.diagnostics.error(DiagnosticCode::Syntax, line.line, line.column,
            quoted(line.text),
            AXISCOMP_TEXT("Error", "a table that begins with {directive} and ends with :END")
                .with("directive", m_directive));
        m_isOpen = true; // one such problem is enough
        m_blocks.emplace_back();
        m_blocks.back().start = line;
    }
    Block& block = m_blocks.back();
    m_commas.take(line);
    splitTokens(line, blanks, m_tokens);
    readNumbers(
        m_tokens, AXISCOMP_TEXT("Error", "a correction"), block.values, m_reading.diagnostics);
    block.lines.push_back({line.line, m_tokens.size()});
}

void BlockReader::checkCommas()
{
    if (const Token number = m_commas.doubtful())
        m_reading.diagnostics.error(DiagnosticCode::NotANumber, number.line, number.column,
            quoted(number.text),
            AXISCOMP_TEXT("Error",
                "decimal points, and blanks between the numbers; nobody can tell a decimal comma "
                "from one that separates two numbers"));
}

std::vector<Block> BlockReader::read()
{
    TextLines lines(m_reading.text);
    while (const auto whole = lines.next()) {
        if (m_reading.isStopped())
            return {};
        const Token line = trimmedToken(withoutComment(*whole, ";'"));
        if (!line) {
            if (const Token comment = trimmedToken(*whole))
                keepNote(m_notes, comment.text.substr(1));
            continue;
        }
        const std::string_view word = firstToken(line, blanks).text;
        if (sameLetters(word, m_directive)) {
            takeStart(line);
        } else if (sameLetters(word, endDirective)) {
            takeEnd(line);
        } else if (line.text.front() == ':') {
            m_reading.diagnostics.error(DiagnosticCode::Syntax, line.line, line.column,
                quoted(word),
                AXISCOMP_TEXT("Error",
                    "{directive} or :END; tables of one and of two dimensions are in separate "
                    "files")
                    .with("directive", m_directive));
            return {};
        } else if (!m_isOpen && isBanner(line)) {
            keepNote(m_notes, trimmedToken(*whole).text);
        } else {
            takeValues(line);
        }
    }
    checkCommas();
    if (m_isOpen)
        m_reading.diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", ":END of the table that begins in line {line}")
                .with("line", m_blocks.back().start.line));
    if (m_blocks.empty())
        m_reading.diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "a table that begins with {directive}")
                .with("directive", m_directive));
    return std::move(m_blocks);
}

} // namespace

const Option* Block::option(std::string_view key) const
{
    const auto found = std::ranges::find_if(
        options, [&](const Option& option) { return sameLetters(option.key.text, key); });
    return found == options.end() ? nullptr : &*found;
}

std::vector<Block> readBlocks(const TextReading& reading, std::string_view directive)
{
    return BlockReader(reading, directive).read();
}

void checkOptions(
    const Block& block, std::span<const std::string_view> known, DiagnosticList& diagnostics)
{
    for (const Option& option : block.options) {
        const bool isKnown = std::ranges::any_of(
            known, [&](std::string_view key) { return sameLetters(key, option.key.text); });
        if (!isKnown)
            diagnostics.warning(DiagnosticCode::UnknownKey, option.key.line, option.key.column,
                quoted(option.key.text), {});
        else if (block.option(option.key.text) != &option)
            diagnostics.error(DiagnosticCode::Contradiction, option.key.line, option.key.column,
                AXISCOMP_TEXT("Error", "{what} a second time")
                    .with("what", quoted(option.key.text)),
                AXISCOMP_TEXT("Error", "each option once"));
        if (option.value && sameLetters(option.key.text, "NEGCOR"))
            diagnostics.error(DiagnosticCode::Syntax, option.value.line, option.value.column,
                quoted(option.value.text),
                AXISCOMP_TEXT("Error", "{key} without a value, or no {key}")
                    .with("key", quoted(option.key.text)));
    }
}

Recognition recogniseFile(std::string_view text, std::string_view directive)
{
    TextLines lines(text);
    while (const auto whole = lines.next()) {
        const Token line = trimmedToken(withoutComment(*whole, ";'"));
        if (!line || isBanner(line))
            continue;
        const bool isStart = sameLetters(firstToken(line, blanks).text, directive);
        const bool hasMore =
            line.text.find_first_of("0123456789", directive.size()) != std::string_view::npos;
        return isStart && hasMore ? Recognition::Certain : Recognition::No;
    }
    return Recognition::No;
}

std::optional<double> numberOption(
    const Block& block, std::string_view key, double standard, DiagnosticList& diagnostics)
{
    const Option* const option = block.option(key);
    if (!option)
        return standard;
    const Token& place = option->value ? option->value : option->key;
    if (!option->value)
        diagnostics.error(DiagnosticCode::Syntax, place.line, place.column, quoted(place.text),
            AXISCOMP_TEXT("Error", "{key}= and a number").with("key", key));
    else if (commasBetweenDigits(place.text) > 0)
        reportNotANumber(
            place, AXISCOMP_TEXT("Error", "a number with a decimal point"), diagnostics);
    else
        return readNumber(
            place, AXISCOMP_TEXT("Error", "the number of {key}").with("key", key), diagnostics);
    return std::nullopt;
}

void remarkHome(const Block& block, DiagnosticList& diagnostics)
{
    for (const std::string_view key : {"HOMEOFFSET", "HOMEDIRECTION"}) {
        const Option* const option = block.option(key);
        if (option && numberOf(option->value.text).value_or(1.0) != 0.0)
            diagnostics.warning(DiagnosticCode::Assumption, option->key.line, option->key.column,
                Verbatim{std::string(key) + ' ' + quoted(option->value.text).text},
                AXISCOMP_TEXT("Error",
                    "positions in the coordinates of the axis after homing; it is left out"));
    }
}

std::string Unit::of(const TextReading& reading, std::string_view axis) const
{
    const std::string given = reading.settings.text(rotaryAxes.key);
    std::vector<Token> rotary;
    splitTokens({given, 0, 0}, blanks, rotary);
    const bool isRotary = std::ranges::find(rotary, axis, &Token::text) != rotary.end();
    if (isEnglish && isRotary)
        reading.diagnostics.error(DiagnosticCode::Contradiction, place.line, place.column,
            AXISCOMP_TEXT("Error", "{key} ENGLISH of the rotary axis {axis}")
                .with("key", quoted(place.text))
                .with("axis", axis),
            AXISCOMP_TEXT("Error", "METRIC, which is degrees there; inches are lengths"));
    if (!isMetric)
        return name;
    return isRotary ? "deg" : "mm";
}

namespace {

/// What a setting says of the user's units, or a warning that it says nothing.
void takeUserUnit(
    Unit& unit, const FormatSetting& setting, const Text& found, const TextReading& reading)
{
    unit.setting = setting.key;
    unit.name = reading.settings.text(setting.key);
    if (unit.name.empty())
        reading.diagnostics.warning(DiagnosticCode::UnitNotGiven, unit.place.line,
            unit.place.column, found,
            AXISCOMP_TEXT("Error", "the setting {key}, such as mm, where a unit matters")
                .with("key", setting.key));
}

void takeCounts(Unit& unit, const Text& found, const TextReading& reading)
{
    if (reading.settings.has(countsPerUnit.key)) {
        unit.perUnit *= reading.settings.number(countsPerUnit.key);
        takeUserUnit(unit, primaryUnit, found, reading);
        return;
    }
    unit.name = countsUnit;
    unit.setting = countsPerUnit.key;
    reading.diagnostics.warning(DiagnosticCode::UnitNotGiven, unit.place.line, unit.place.column,
        found,
        AXISCOMP_TEXT("Error", "the setting {key}, where a unit matters")
            .with("key", countsPerUnit.key));
}

} // namespace

std::optional<Unit> unitOption(const Block& block, std::string_view key, const TextReading& reading)
{
    Unit unit;
    const Option* const option = block.option(key);
    unit.place = option ? option->key : block.start;
    if (!option) {
        takeUserUnit(unit, primaryUnit,
            AXISCOMP_TEXT("Error", "a table without {key}").with("key", key), reading);
        return unit;
    }
    const std::string_view text = option->value.text;
    const std::size_t slash = std::min(text.find('/'), text.size());
    const std::string_view word = text.substr(0, slash);
    if (slash < text.size()) {
        const auto perUnit = numberOf(text.substr(slash + 1));
        unit.perUnit = perUnit.value_or(0.0);
    }
    const bool isPrimary = sameLetters(word, "PRIMARY");
    const bool isSecondary = sameLetters(word, "SECONDARY");
    const bool isCounts = sameLetters(word, "COUNTS");
    unit.isEnglish = sameLetters(word, "ENGLISH");
    unit.isMetric = sameLetters(word, "METRIC");
    if (!(unit.perUnit > 0.0)
        || (!isPrimary && !isSecondary && !isCounts && !unit.isEnglish && !unit.isMetric)) {
        reading.diagnostics.error(DiagnosticCode::Syntax, option->key.line, option->key.column,
            quoted(text),
            AXISCOMP_TEXT("Error",
                "{key}=METRIC, ENGLISH, PRIMARY, SECONDARY or COUNTS, perhaps divided by a number "
                "as in METRIC/1000")
                .with("key", key));
        return std::nullopt;
    }
    const Text found = Verbatim{std::string(key) + ' ' + quoted(text).text};
    if (unit.isEnglish)
        unit.name = "inch";
    else if (isCounts)
        takeCounts(unit, found, reading);
    else if (isPrimary || isSecondary)
        takeUserUnit(unit, isSecondary ? secondaryUnit : primaryUnit, found, reading);
    return unit;
}

bool areKnownApart(const Unit& positions, const Unit& values, DiagnosticList& diagnostics)
{
    // Values in counts are not added to positions without a unit: whoever converts refuses that.
    const bool areApart = !positions.setting.empty() && !values.setting.empty()
        && positions.setting != values.setting && values.setting != countsPerUnit.key;
    if (!areApart || (!positions.name.empty() && !values.name.empty()))
        return true;
    diagnostics.error(DiagnosticCode::UnitNotGiven, values.place.line, values.place.column,
        AXISCOMP_TEXT("Error", "two kinds of units in one table"),
        AXISCOMP_TEXT("Error", "the settings {key} and {key2}")
            .with("key", positions.setting)
            .with("key2", values.setting));
    return false;
}

bool areFinite(const NeutralTable& table, const Block& block, DiagnosticList& diagnostics)
{
    for (const CompensationColumn& column : table.columns)
        for (const double value : column.values)
            if (!std::isfinite(value)) {
                diagnostics.error(DiagnosticCode::LimitExceeded, block.start.line, 0,
                    AXISCOMP_TEXT("Error", "a correction that is too large for its unit"),
                    AXISCOMP_TEXT("Error", "another CORUNIT"));
                return false;
            }
    return true;
}

std::vector<double> Sampling::knots(double perUnit) const
{
    std::vector<double> positions = evenKnots(-offset, distance, count);
    for (double& position : positions)
        position = position == 0.0 ? 0.0 : position / perUnit; // no -0
    if (isDownwards())
        std::ranges::reverse(positions);
    return positions;
}

Sampling samplingOf(const SourceAxis& axis)
{
    const double span = axis.knots.back() - axis.knots.front();
    return {
        span / static_cast<double>(axis.knots.size() - 1), -axis.knots.front(), axis.knots.size()};
}

Result<NeutralTable> inFileUnits(
    const NeutralTable& table, const SettingValues& settings, std::vector<Text>& remarks)
{
    if (settings.text("units") == "metric")
        return inUnits(table, "mm", "deg", remarks);
    return inSettingUnits(table, settings, remarks);
}

std::string unitWord(const SettingValues& settings)
{
    return settings.text("units") == "metric" ? "METRIC" : "PRIMARY";
}

FormatSettings readingSettings(std::span<const NeutralTable> written, const SettingValues& settings)
{
    FormatSettings reading;
    const std::string& unit = written.front().axes.front().unit;
    if (settings.text("units") == "primary" && !unit.empty())
        reading["primary-unit"] = unit;
    std::set<std::string> rotary;
    for (const NeutralTable& table : written) {
        for (const SourceAxis& axis : table.axes)
            if (axis.unit == "deg")
                rotary.insert(axis.name);
        for (const CompensationColumn& column : table.columns)
            if (column.unit == "deg")
                rotary.insert(column.target);
    }
    for (const std::string& axis : rotary)
        reading["rotary-axes"] += (axis == *rotary.begin() ? "" : ",") + axis;
    return reading;
}

} // namespace axiscomp::aerotech
